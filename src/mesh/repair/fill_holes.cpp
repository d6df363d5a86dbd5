#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <planish/core/error.h>
#include <planish/mesh/cut.h>
#include <planish/mesh/patch.h>
#include <planish/mesh/repair.h>

#include "mesh/edge_sides.h"
#include "mesh/repair/repaired.h"
#include "mesh/repair/sheets.h"
#include "mesh/repair/triangulate_loop.h"

namespace planish {

namespace {

// Closing a hole takes cubic time.
constexpr std::size_t k_most_edges = 500;

double length_of_loop(const std::vector<Index>& loop, const TriMesh& mesh) {
  const std::vector<Index> last{loop.back(), loop.front()};
  return path_length(loop, mesh.positions) + path_length(last, mesh.positions);
}

/// The sides of all triangles by edge, to be looked up.
class EdgeTable {
 public:
  explicit EdgeTable(const TriMesh& mesh) : sides_(sorted_sides(mesh)) {}

  /// The triangle of an edge of one; none where there is no such edge.
  Index triangle_at(Index a, Index b) const {
    const auto [low, high] = std::minmax(a, b);
    const auto at =
        std::lower_bound(sides_.begin(), sides_.end(), std::pair<Index, Index>(low, high),
                         [](const EdgeSide& side, const std::pair<Index, Index>& ends) {
                           return std::pair(side.low, side.high) < ends;
                         });
    const bool found = at != sides_.end() && at->low == low && at->high == high;
    return found ? at->triangle : RepairedMesh::none;
  }

 private:
  std::vector<EdgeSide> sides_;
};

Vec3 unit_normal(const Triangle& t, const std::vector<Vec3>& positions) {
  const Vec3 normal = cross(positions[t[1]] - positions[t[0]], positions[t[2]] - positions[t[0]]);
  const double length = norm(normal);
  return length > 0.0 ? 1.0 / length * normal : Vec3{};
}

/// Of every piece its longest loop, of equal ones the first.
std::vector<unsigned char> are_outer(const std::vector<double>& lengths,
                                     const std::vector<Index>& piece, std::size_t pieces) {
  constexpr std::size_t k_no_loop = static_cast<std::size_t>(-1);
  std::vector<std::size_t> longest(pieces, k_no_loop);
  for (std::size_t l = 0; l < lengths.size(); ++l) {
    std::size_t& best = longest[piece[l]];
    if (best == k_no_loop || lengths[l] > lengths[best]) best = l;
  }
  std::vector<unsigned char> outer(lengths.size(), 0);
  for (const std::size_t l : longest) {
    if (l != k_no_loop) outer[l] = 1;
  }
  return outer;
}

/// Triangles that close the hole, with the surface's orientation.
/// @param mesh at the scale of unit_scale()
std::optional<std::vector<Triangle>> filling(const TriMesh& mesh, const EdgeTable& edges,
                                             std::vector<Index> loop) {
  if (loop.size() > k_most_edges) return std::nullopt;
  std::reverse(loop.begin(), loop.end());  // the loop has the surface on its left
  std::vector<Vec3> corners, beside;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    corners.push_back(mesh.positions[loop[i]]);
    const Index t = edges.triangle_at(loop[i], loop[(i + 1) % loop.size()]);
    beside.push_back(unit_normal(mesh.triangles[t], mesh.positions));
  }
  const auto may_join = [&](std::size_t i, std::size_t j) {
    return edges.triangle_at(loop[i], loop[j]) == RepairedMesh::none;
  };
  auto triangles = triangulate_loop(corners, beside, may_join);
  if (!triangles) return std::nullopt;
  for (Triangle& t : *triangles)
    t = {loop[t[0]], loop[t[1]], loop[t[2]]};
  return triangles;
}

}  // namespace

FilledMesh fill_holes(const TriMesh& mesh, double length) {
  if (!(length > 0.0)) {
    throw Error(ErrorCode::option_out_of_range,
                "the length of holes to fill must be above 0, not " + std::to_string(length));
  }
  FilledMesh result{unchanged(mesh)};
  const auto connectivity = Connectivity::build(mesh);
  if (mesh.triangles.empty() || !connectivity) return result;
  const auto& loops = connectivity->border_loops();
  const EdgeTable edges(mesh);
  const Sheets pieces = find_sheets(mesh);
  std::vector<double> lengths;
  std::vector<Index> piece;
  for (const std::vector<Index>& loop : loops) {
    lengths.push_back(length_of_loop(loop, mesh));
    piece.push_back(pieces.of_triangle[edges.triangle_at(loop[0], loop[1])]);
  }
  const std::vector<unsigned char> outer = are_outer(lengths, piece, pieces.count);
  TriMesh unit = mesh;
  const double scale = unit_scale(mesh);
  for (Vec3& p : unit.positions)
    p = scale * p;
  for (std::size_t l = 0; l < loops.size(); ++l) {
    if (outer[l] != 0 || !(lengths[l] <= length)) continue;
    const auto triangles = filling(unit, edges, loops[l]);
    ++(triangles ? result.filled : result.left);
    if (!triangles) continue;
    result.mesh.triangles.insert(result.mesh.triangles.end(), triangles->begin(), triangles->end());
    result.source.insert(result.source.end(), triangles->size(), RepairedMesh::none);
  }
  return result;
}

}  // namespace planish
