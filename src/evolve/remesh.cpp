#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include <planish/core/error.h>
#include <planish/evolve/remesh.h>
#include <planish/mesh/connectivity.h>
#include <planish/mesh/inspect.h>

#include "evolve/state/fixed_marks.h"
#include "mesh/coarsen/coarsen.h"

namespace planish {

namespace {

constexpr std::size_t k_enough = 5000, k_per_border_vertex = 3;

std::size_t border_vertices(const Connectivity& connectivity) {
  std::size_t count = 0;
  for (const auto& loop : connectivity.border_loops())
    count += loop.size();
  return count;
}

std::vector<unsigned char> kept_marks(const TriMesh& mesh, const Constraints& constraints,
                                      std::span<const Index> keep) {
  auto marks = fixed_marks(constraints, mesh.positions.size());
  if (!keep.empty()) marks.resize(mesh.positions.size(), 0);
  for (const Index v : keep) {
    if (v >= mesh.positions.size()) {
      throw Error(ErrorCode::index_out_of_range,
                  "vertex " + std::to_string(v) + " is to be kept but there are " +
                      std::to_string(mesh.positions.size()),
                  {.path = {}, .first = v});
    }
    marks[v] = 1;
  }
  return marks;
}

RemeshedPatch whole(const TriMesh& mesh, const Constraints& constraints) {
  std::vector<Index> source(mesh.positions.size());
  std::iota(source.begin(), source.end(), Index{0});
  return {mesh, constraints, std::move(source)};
}

}  // namespace

RemeshedPatch remesh(const TriMesh& mesh, const Constraints& constraints,
                     std::span<const Index> keep) {
  require(inspect(mesh), Purpose::measure);
  const std::vector<unsigned char> marks = kept_marks(mesh, constraints, keep);
  if (!can_be_coarsened(mesh)) return whole(mesh, constraints);
  const Connectivity connectivity(mesh);
  const std::size_t wanted =
      std::max(k_enough, k_per_border_vertex * border_vertices(connectivity));
  if (wanted >= mesh.positions.size()) return whole(mesh, constraints);
  CoarsePatch coarse = coarsen(mesh, connectivity, wanted, CoarseBorder::kept, marks);
  Constraints left = restricted_to(constraints, coarse.source);
  return {std::move(coarse.mesh), std::move(left), std::move(coarse.source)};
}

}  // namespace planish
