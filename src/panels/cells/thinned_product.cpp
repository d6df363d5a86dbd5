#include "panels/cells/thinned_product.h"

#include <utility>
#include <vector>

#include "mesh/coarsen/coarsen.h"

namespace planish {

Patch thinned_product(const Patch& patch, std::size_t vertices, const ThreadPool& pool) {
  if (vertices >= patch.vertex_count()) return patch;
  const bool is_closed = patch.border_loops().empty();
  // A part without a border is thinned without one of its triangles, whose vertices then stay.
  TriMesh mesh = patch.mesh();
  Triangle lid{};
  if (is_closed) {
    lid = mesh.triangles.back();
    mesh.triangles.pop_back();
  }
  CoarsePatch thin = coarsen(is_closed ? Patch(std::move(mesh)) : patch, vertices,
                             CoarseBorder::thinned, {}, &pool);
  if (is_closed) {
    std::vector<Index> number(patch.vertex_count(), 0);
    for (Index v = 0; v < thin.source.size(); ++v)
      number[thin.source[v]] = v;
    thin.mesh.triangles.push_back({number[lid[0]], number[lid[1]], number[lid[2]]});
  }
  return Patch(std::move(thin.mesh));
}

}  // namespace planish
