#include "mesh/redundant/doubled.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include <planish/mesh/repair.h>
#include <planish/mesh/weld.h>

#include "mesh/edge_sides.h"
#include "mesh/redundant/cells.h"
#include "mesh/repair/border_places.h"
#include "mesh/repair/sheets.h"
#include "mesh/turning_sets.h"

namespace planish {

namespace {

// With how many of the parts that reach about as far a part is compared.
constexpr std::size_t k_most_beside = 64;

/// How far a part reaches: the least and the largest coordinates.
using Reach = std::array<double, 6>;

std::vector<Reach> reaches_of(const TriMesh& mesh, const Sheets& parts) {
  std::vector<Reach> reaches(parts.count);
  std::vector<unsigned char> begun(parts.count, 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    Reach& reach = reaches[parts.of_triangle[t]];
    for (const Index v : mesh.triangles[t]) {
      const Vec3& p = mesh.positions[v];
      if (begun[parts.of_triangle[t]] == 0) reach = {p.x, p.y, p.z, p.x, p.y, p.z};
      begun[parts.of_triangle[t]] = 1;
      reach = {std::min(reach[0], p.x), std::min(reach[1], p.y), std::min(reach[2], p.z),
               std::max(reach[3], p.x), std::max(reach[4], p.y), std::max(reach[5], p.z)};
    }
  }
  return reaches;
}

/// Whether two parts reach equally far, within the length. Where triangles share no vertices at
/// all nothing is looked for.
bool has_parts_of_equal_reach(const TriMesh& mesh, double length) {
  const Sheets parts = find_parts_by_vertices(mesh);
  if (parts.count < 2 || parts.count == mesh.triangles.size()) return false;
  std::vector<Reach> reaches = reaches_of(mesh, parts);
  // Numbers that differ where reaches do, but for accidents; weights of at most 1.
  constexpr Reach k_weights = {0.31, 0.59, 0.83, 0.97, 0.47, 0.71};
  std::vector<std::pair<double, Index>> order;
  order.reserve(reaches.size());
  for (std::size_t p = 0; p < reaches.size(); ++p) {
    double sum = 0.0;
    for (std::size_t k = 0; k < k_weights.size(); ++k)
      sum += k_weights[k] * reaches[p][k];
    order.emplace_back(sum, static_cast<Index>(p));
  }
  std::sort(order.begin(), order.end());
  const auto are_near = [&](const Reach& a, const Reach& b) {
    return std::equal(a.begin(), a.end(), b.begin(),
                      [&](double x, double y) { return std::abs(x - y) <= length; });
  };
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::size_t end = std::min(order.size(), i + 1 + k_most_beside);
    for (std::size_t j = i + 1; j < end && order[j].first - order[i].first <= 6.0 * length; ++j) {
      if (are_near(reaches[order[i].second], reaches[order[j].second])) return true;
    }
  }
  return false;
}

/// Of each vertex the smallest at its place.
std::vector<Index> places_of(const TriMesh& mesh) {
  const double length = default_weld_length(mesh);
  if (!has_parts_of_equal_reach(mesh, length)) return first_at_place(mesh.positions);
  const double scale = unit_scale(mesh);
  TriMesh unit = mesh;
  for (Vec3& p : unit.positions)
    p = scale * p;
  // All sides, so that vertices inside have places too.
  return find_border_places(unit, sorted_sides(unit), scale * length).of_vertex;
}

TriMesh at_places(const TriMesh& mesh) {
  const std::vector<Index> place = places_of(mesh);
  TriMesh result = mesh;
  for (Triangle& t : result.triangles) {
    for (Index& v : t)
      v = place[v];
  }
  return result;
}

/// Triangles that lie on each other, as cells of the same corners.
struct Stacks {
  std::vector<std::vector<MeshCell>> cells;  // of each stack: two or more
  std::vector<Index> of_triangle;            // the stack that it is in, or none

  const std::vector<MeshCell>* at(Index t) const {
    return of_triangle[t] == MeshCell::none ? nullptr : &cells[of_triangle[t]];
  }
};

bool has(const MeshCell& cell, Index t) {
  return cell.triangles[0] == t || cell.triangles[1] == t;
}

template <class Visit>
void for_each_triangle(const MeshCell& cell, const Visit& visit) {
  visit(cell.triangles[0]);
  if (cell.triangles[1] != MeshCell::none) visit(cell.triangles[1]);
}

/// Of cells with the same corners: two or more are a stack, if none of their triangles is in one.
void add_stacks(const std::vector<MeshCell>& cells, Stacks& stacks) {
  for (std::size_t begin = 0; begin < cells.size();) {
    std::size_t end = begin;
    bool is_free = true;
    for (; end < cells.size() && cells[end].has_same_corners(cells[begin]); ++end) {
      for_each_triangle(cells[end], [&](Index t) {
        is_free = is_free && stacks.of_triangle[t] == MeshCell::none;
      });
    }
    if (end - begin > 1 && is_free) {
      const auto number = static_cast<Index>(stacks.cells.size());
      stacks.cells.emplace_back(cells.begin() + static_cast<std::ptrdiff_t>(begin),
                                cells.begin() + static_cast<std::ptrdiff_t>(end));
      for (const MeshCell& cell : stacks.cells.back())
        for_each_triangle(cell, [&](Index t) { stacks.of_triangle[t] = number; });
    }
    begin = end;
  }
}

/// Whether the two triangles of a quadrilateral lie on each other, so that it is none.
bool is_folded(const TriMesh& mesh, const MeshCell& quad) {
  const auto normal = [&](Index t) {
    const Triangle& corners = mesh.triangles[t];
    const Vec3 from = mesh.positions[corners[0]];
    return cross(mesh.positions[corners[1]] - from, mesh.positions[corners[2]] - from);
  };
  return !(dot(normal(quad.triangles[0]), normal(quad.triangles[1])) > 0.0);
}

Stacks find_stacks(const TriMesh& mesh, std::span<const unsigned char> gone) {
  Stacks stacks{{}, std::vector<Index>(mesh.triangles.size(), MeshCell::none)};
  add_stacks(triangle_cells(mesh, gone), stacks);
  std::vector<unsigned char> skipped(gone.begin(), gone.end());
  for (std::size_t t = 0; t < skipped.size(); ++t) {
    if (stacks.of_triangle[t] != MeshCell::none) skipped[t] = 1;
  }
  const std::vector<EdgeSide> sides = sorted_sides(mesh, skipped);
  std::vector<MeshCell> quads = quad_cells(mesh, group_by_edge(sides));
  std::erase_if(quads, [&](const MeshCell& quad) { return is_folded(mesh, quad); });
  add_stacks(quads, stacks);
  return stacks;
}

/// Looks for doubles piece by piece.
class Doubles {
 public:
  /// @param has_border of each piece, whether it ends anywhere
  Doubles(const TriMesh& placed, const Sheets& pieces, std::vector<unsigned char> has_border,
          std::span<const unsigned char> gone)
      : mesh_(placed),
        pieces_(pieces),
        has_border_(std::move(has_border)),
        stacks_(find_stacks(placed, gone)),
        members_(pieces.count) {
    for (std::size_t t = 0; t < gone.size(); ++t) {
      if (gone[t] == 0) members_[pieces.of_triangle[t]].push_back(static_cast<Index>(t));
    }
  }

  DoubledSheets take() && {
    add_copies();
    add_backs_within();
    std::sort(found_.backs.begin(), found_.backs.end());
    std::sort(found_.repeated.begin(), found_.repeated.end());
    return std::move(found_);
  }

 private:
  /// The first cell at a triangle whose triangles are all in pieces that are wanted.
  template <class IsWanted>
  const MeshCell* cell_of_pieces(Index t, const IsWanted& is_wanted) const {
    const std::vector<MeshCell>* stack = stacks_.at(t);
    if (stack == nullptr) return nullptr;
    const auto found = std::find_if(stack->begin(), stack->end(), [&](const MeshCell& cell) {
      bool all = !has(cell, t);
      for_each_triangle(cell,
                        [&](Index other) { all = all && is_wanted(pieces_.of_triangle[other]); });
      return all;
    });
    return found == stack->end() ? nullptr : &*found;
  }

  template <class IsWanted>
  bool is_doubled_by(std::size_t piece, const IsWanted& is_wanted) const {
    return !members_[piece].empty() &&
           std::all_of(members_[piece].begin(), members_[piece].end(),
                       [&](Index t) { return cell_of_pieces(t, is_wanted) != nullptr; });
  }

  bool is_rising(Index t) const {
    const std::vector<MeshCell>& stack = *stacks_.at(t);
    return std::find_if(stack.begin(), stack.end(),
                        [&](const MeshCell& cell) { return has(cell, t); })
        ->rising;
  }

  /// Of pieces that double each other those that come later; of no stack all.
  void add_copies() {
    std::vector<unsigned char> is_front(pieces_.count, 0);
    const auto front = [&](Index piece) { return is_front[piece] != 0; };
    for (std::size_t p = 0; p < pieces_.count; ++p) {
      const auto is_other = [&](Index piece) { return piece != p; };
      if (!is_doubled_by(p, is_other)) continue;
      is_front[p] = is_doubled_by(p, front) ? 0 : 1;
      if (is_front[p] != 0) continue;
      for (const Index t : members_[p]) {
        const bool is_same = cell_of_pieces(t, front)->rising == is_rising(t);
        (is_same ? found_.repeated : found_.backs).push_back(t);
      }
      members_[p].clear();
    }
  }

  /// Whether each of its triangles has one other, in the piece itself and in the other orientation.
  /// One that ends anywhere is a sheet that was folded flat, or a tube.
  bool is_doubled_in_itself(std::size_t piece) const {
    return has_border_[piece] == 0 &&
           std::all_of(members_[piece].begin(), members_[piece].end(), [&](Index t) {
             const std::vector<MeshCell>* stack = stacks_.at(t);
             return stack != nullptr && stack->size() == 2 &&
                    (*stack)[0].rising != (*stack)[1].rising &&
                    cell_of_pieces(t, [&](Index other) { return other == piece; }) != nullptr;
           });
  }

  /// In pieces that have both sides: of each stack the cell that does not agree with the first
  /// triangle of the piece.
  void add_backs_within() {
    std::vector<Index> wanted;  // stacks
    std::vector<unsigned char> skipped(mesh_.triangles.size(), 1);
    for (std::size_t p = 0; p < pieces_.count; ++p) {
      if (!is_doubled_in_itself(p)) continue;
      for (const Index t : members_[p]) {
        const MeshCell& first = first_of(stacks_.of_triangle[t]);
        if (first.triangles[0] == t) wanted.push_back(stacks_.of_triangle[t]);
        if (has(first, t)) skipped[t] = 0;
      }
    }
    const std::vector<EdgeSide> sides = sorted_sides(mesh_, skipped);
    TurningSets sets(mesh_.triangles.size());
    for (const EdgeSides& edge : group_by_edge(sides)) {
      if (edge.size() != 2) continue;
      const EdgeSide &a = edge.begin[0], &b = edge.begin[1];
      sets.join(a.triangle, b.triangle, a.forward == b.forward ? 1 : 0);
    }
    for (const Index stack : wanted) {
      const MeshCell& first = first_of(stack);
      const std::vector<MeshCell>& both = stacks_.cells[stack];
      const bool is_back = sets.first_of(first.triangles[0]).turned != 0;
      const MeshCell& back = is_back ? first : &first == &both[0] ? both[1] : both[0];
      for_each_triangle(back, [&](Index t) { found_.backs.push_back(t); });
    }
  }

  /// The cell of a stack with the first triangle.
  const MeshCell& first_of(Index stack) const {
    const std::vector<MeshCell>& cells = stacks_.cells[stack];
    return *std::min_element(cells.begin(), cells.end(), [](const MeshCell& a, const MeshCell& b) {
      return a.triangles < b.triangles;
    });
  }

  const TriMesh& mesh_;
  const Sheets& pieces_;
  std::vector<unsigned char> has_border_;
  Stacks stacks_;
  std::vector<std::vector<Index>> members_;
  DoubledSheets found_;
};

}  // namespace

bool may_be_doubled(const TriMesh& mesh) {
  const std::vector<Index> first = first_at_place(mesh.positions);
  for (std::size_t v = 0; v < first.size(); ++v) {
    if (first[v] != v) return true;
  }
  return has_parts_of_equal_reach(mesh, default_weld_length(mesh));
}

DoubledSheets find_doubled_sheets(const TriMesh& mesh, std::span<const unsigned char> gone) {
  const TriMesh placed = at_places(mesh);
  const std::vector<EdgeSide> sides = sorted_sides(mesh, gone);
  const std::vector<EdgeSides> edges = group_by_edge(sides);
  const Sheets pieces = find_sheets(mesh.triangles.size(), edges);
  std::vector<unsigned char> has_border(pieces.count, 0);
  for (const EdgeSides& edge : edges) {
    if (edge.size() == 1) has_border[pieces.of_triangle[edge.begin->triangle]] = 1;
  }
  return Doubles(placed, pieces, std::move(has_border), gone).take();
}

}  // namespace planish
