#include "mesh/redundant/cells.h"

#include <algorithm>
#include <tuple>

namespace planish {

namespace {

void sort_cells(std::vector<MeshCell>& cells) {
  std::sort(cells.begin(), cells.end(), [](const MeshCell& a, const MeshCell& b) {
    return std::tie(a.corners, a.rising, a.triangles) < std::tie(b.corners, b.rising, b.triangles);
  });
}

}  // namespace

std::vector<MeshCell> triangle_cells(const TriMesh& mesh, std::span<const unsigned char> gone) {
  std::vector<MeshCell> cells;
  cells.reserve(mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (gone[i] != 0) continue;
    Triangle t = mesh.triangles[i];
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    const bool rising = t[1] < t[2];
    if (!rising) std::swap(t[1], t[2]);
    if (t[0] == t[1] || t[1] == t[2]) continue;
    cells.push_back(
        {{t[0], t[1], t[2], MeshCell::none}, rising, {static_cast<Index>(i), MeshCell::none}});
  }
  sort_cells(cells);
  return cells;
}

std::vector<MeshCell> quad_cells(const TriMesh& mesh, const std::vector<EdgeSides>& edges) {
  std::vector<MeshCell> cells;
  for (const EdgeSides& edge : edges) {
    if (edge.size() != 2 || edge.begin[0].forward == edge.begin[1].forward) continue;
    const EdgeSide &a = edge.begin[0], &b = edge.begin[1];
    const Triangle &of_a = mesh.triangles[a.triangle], &of_b = mesh.triangles[b.triangle];
    MeshCell cell{{of_a[(a.corner + 1) % 3], of_a[(a.corner + 2) % 3], of_a[a.corner],
                   of_b[(b.corner + 2) % 3]},
                  true,
                  {a.triangle, b.triangle}};
    auto& corners = cell.corners;
    if (corners[1] == corners[3]) continue;
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    cell.rising = corners[1] < corners[3];
    if (!cell.rising) std::swap(corners[1], corners[3]);
    cells.push_back(cell);
  }
  sort_cells(cells);
  return cells;
}

}  // namespace planish
