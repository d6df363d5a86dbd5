#include "report/page/display_mesh.h"

#include <utility>

#include "mesh/coarsen/coarsen.h"

namespace planish {

namespace {

/// Without the vertices that no triangle uses.
DisplayMesh used_part(const TriMesh& mesh, const Connectivity& connectivity) {
  DisplayMesh shown;
  std::vector<Index> number(mesh.positions.size(), 0);
  for (Index v = 0; v < mesh.positions.size(); ++v) {
    if (connectivity.ring(v).empty()) continue;
    number[v] = static_cast<Index>(shown.source.size());
    shown.source.push_back(v);
  }
  shown.triangles.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles)
    shown.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
  return shown;
}

}  // namespace

DisplayMesh display_mesh(const TriMesh& mesh, const Connectivity& connectivity, std::size_t most,
                         std::span<const Index> keep) {
  if (mesh.positions.size() <= most || !can_be_coarsened(mesh))
    return used_part(mesh, connectivity);
  std::vector<unsigned char> must_stay(mesh.positions.size(), 0);
  for (const Index v : keep)
    must_stay[v] = 1;
  CoarsePatch coarse = coarsen(mesh, connectivity, most, CoarseBorder::thinned, must_stay);
  // Numbered anew, should it hold vertices that no triangle uses.
  DisplayMesh shown = used_part(coarse.mesh, Connectivity(coarse.mesh));
  for (Index& v : shown.source)
    v = coarse.source[v];
  return shown;
}

}  // namespace planish
