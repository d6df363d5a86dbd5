#include <algorithm>
#include <type_traits>
#include <utility>

#include <planish/pattern/pattern_options.h>

namespace planish {

namespace {

/// Calls `visit` on every vertex number that options hold.
template <class Options, class Visit>
void for_vertices(Options& options, Visit visit) {
  for (auto& notch : options.notches) {
    if (!notch.edge) continue;
    auto& [from, to] = *notch.edge;
    const bool is_vertex = from == to;
    visit(from);
    if (!is_vertex) visit(to);
    if constexpr (!std::is_const_v<Options>) to = is_vertex ? from : to;
  }
  const auto visit_corners = [&](auto& place) {
    for (auto& corner : place.corners)
      visit(corner);
  };
  for (auto& mark : options.marks) {
    visit(mark.vertex);
    if (mark.place) visit_corners(*mark.place);
  }
  for (auto& line : options.drawn_lines) {
    for (auto& place : line)
      visit_corners(place);
  }
  for (auto& line : options.inner_lines) {
    for (auto& vertex : line)
      visit(vertex);
  }
  for (auto& edge : options.edge_allowances) {
    visit(edge.from);
    visit(edge.to);
  }
  if (options.fold) {
    visit(options.fold->from);
    visit(options.fold->to);
  }
  if (options.like) visit(options.like->start);
}

/// Numbers of seams are not visited above: a coarser mesh may lack their vertices.
std::vector<SeamNumber> renumbered(std::vector<SeamNumber> numbers, std::span<const Index> source) {
  std::erase_if(numbers, [&](const SeamNumber& seam) {
    return !std::binary_search(source.begin(), source.end(), seam.vertex);
  });
  for (SeamNumber& seam : numbers) {
    const auto found = std::lower_bound(source.begin(), source.end(), seam.vertex);
    seam.vertex = static_cast<Index>(found - source.begin());
  }
  return numbers;
}

}  // namespace

PatternOptions for_mirror_image(PatternOptions options) {
  if (options.grain) {
    if (auto* degrees = std::get_if<double>(&*options.grain)) *degrees = 180.0 - *degrees;
  }
  return options;
}

PatternOptions on_mirrored_border(PatternOptions options) {
  for (Notch& notch : options.notches) {
    if (!notch.edge) notch.fraction = 1.0 - notch.fraction;
  }
  for (EdgeAllowance& edge : options.edge_allowances)
    std::swap(edge.from, edge.to);
  for (PatternEdge& edge : options.edges)
    edge.clockwise = !edge.clockwise;
  return options;
}

void check_pattern_options(const PatternOptions& options, std::size_t vertex_count,
                           std::span<const std::vector<Index>> border, const std::string& name) {
  const std::string& piece = options.label.name.empty() ? name : options.label.name;
  check_notches(border, options.notches, piece);
  check_edge_allowances(border, options.edge_allowances, piece);
  if (options.fold) check_fold(border, *options.fold, piece);
  check_marks(vertex_count, options.marks, piece);
  check_inner_lines(vertex_count, options.inner_lines, piece);
  check_inner_lines(vertex_count, options.drawn_lines, piece);
}

std::vector<Index> named_vertices(const PatternOptions& options) {
  std::vector<Index> vertices;
  for_vertices(options, [&](Index vertex) { vertices.push_back(vertex); });
  return vertices;
}

PatternOptions renumbered(PatternOptions options, std::span<const Index> source) {
  for_vertices(options, [&](Index& vertex) {
    const auto found = std::lower_bound(source.begin(), source.end(), vertex);
    vertex = static_cast<Index>(found - source.begin());
  });
  options.seam_numbers = renumbered(std::move(options.seam_numbers), source);
  return options;
}

}  // namespace planish
