#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include <planish/core/error.h>
#include <planish/pattern/allowance.h>

namespace planish {

namespace {

/// A stretch of a loop by its points.
struct Stretch {
  std::size_t loop, from, to;
};

std::optional<Stretch> stretch_of(const EdgeAllowance& edge,
                                  std::span<const std::vector<Index>> border) {
  for (std::size_t k = 0; k < border.size(); ++k) {
    const auto place = [&](Index vertex) {
      const auto found = std::find(border[k].begin(), border[k].end(), vertex);
      return static_cast<std::size_t>(found - border[k].begin());
    };
    const Stretch stretch = {k, place(edge.from), place(edge.to)};
    if (stretch.from < border[k].size() && stretch.to < border[k].size()) return stretch;
  }
  return std::nullopt;
}

}  // namespace

void check_edge_allowances(std::span<const std::vector<Index>> border,
                           std::span<const EdgeAllowance> edges, std::string_view piece) {
  for (const EdgeAllowance& edge : edges) {
    if (stretch_of(edge, border)) continue;
    throw Error(ErrorCode::misplaced_allowance,
                "piece \"" + std::string(piece) + "\": the seam allowance from vertex " +
                    std::to_string(edge.from) + " to " + std::to_string(edge.to) +
                    " is off the border: both must be on one border of the piece",
                {.path = {}, .first = edge.from});
  }
}

Allowance with_edge_allowances(Allowance allowance, const PieceOutline& outline,
                               std::span<const EdgeAllowance> edges) {
  check_edge_allowances(outline.vertices, edges, outline.piece);
  if (edges.empty()) return allowance;
  allowance.edge_widths.clear();
  for (const Polygon& loop : outline.loops)
    allowance.edge_widths.emplace_back(loop.size(), allowance.width);
  for (const EdgeAllowance& edge : edges) {
    const Stretch stretch = *stretch_of(edge, outline.vertices);
    std::vector<double>& widths = allowance.edge_widths[stretch.loop];
    std::size_t at = stretch.from;
    do {
      widths[at] = edge.width;
      at = (at + 1) % widths.size();
    } while (at != stretch.to);
  }
  return allowance;
}

}  // namespace planish
