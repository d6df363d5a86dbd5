#include "report/page/display_mesh.h"

#include <utility>

#include "mesh/coarsen/coarsen.h"

namespace planish {

namespace {

/// Without the vertices that no triangle uses.
DisplayMesh used_part(const Patch& patch) {
  DisplayMesh shown;
  std::vector<Index> number(patch.vertex_count(), 0);
  for (Index v = 0; v < patch.vertex_count(); ++v) {
    if (patch.ring(v).empty()) continue;
    number[v] = static_cast<Index>(shown.source.size());
    shown.source.push_back(v);
  }
  shown.triangles.reserve(patch.triangles().size());
  for (const Triangle& t : patch.triangles())
    shown.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
  return shown;
}

}  // namespace

DisplayMesh display_mesh(const Patch& patch, std::size_t most, std::span<const Index> keep) {
  if (patch.vertex_count() <= most || !can_be_coarsened(patch)) return used_part(patch);
  std::vector<unsigned char> must_stay(patch.vertex_count(), 0);
  for (const Index v : keep)
    must_stay[v] = 1;
  CoarsePatch coarse = coarsen(patch, most, CoarseBorder::thinned, must_stay);
  // Numbered anew, should it hold vertices that no triangle uses.
  DisplayMesh shown = used_part(Patch(coarse.mesh));
  for (Index& v : shown.source)
    v = coarse.source[v];
  return shown;
}

}  // namespace planish
