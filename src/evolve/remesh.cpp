#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include <planish/core/error.h>
#include <planish/evolve/remesh.h>
#include <planish/mesh/inspect.h>
#include <planish/mesh/patch.h>

#include "evolve/state/fixed_marks.h"
#include "mesh/coarsen/coarsen.h"

namespace planish {

namespace {

constexpr std::size_t k_enough = 5000, k_per_border_vertex = 3;

std::size_t border_vertices(const Patch& patch) {
  std::size_t count = 0;
  for (const auto& loop : patch.border_loops())
    count += loop.size();
  return count;
}

std::vector<unsigned char> kept_marks(const Patch& patch, const Constraints& constraints,
                                      std::span<const Index> keep) {
  auto marks = fixed_marks(constraints, patch.vertex_count());
  if (!keep.empty()) marks.resize(patch.vertex_count(), 0);
  for (const Index v : keep) {
    if (v >= patch.vertex_count()) {
      throw Error(ErrorCode::index_out_of_range,
                  "vertex " + std::to_string(v) + " is to be kept but there are " +
                      std::to_string(patch.vertex_count()),
                  {.path = {}, .first = v});
    }
    marks[v] = 1;
  }
  return marks;
}

RemeshedPatch whole(const Patch& patch, const Constraints& constraints) {
  std::vector<Index> source(patch.vertex_count());
  std::iota(source.begin(), source.end(), Index{0});
  return {patch, constraints, std::move(source)};
}

}  // namespace

std::size_t vertices_of_remeshed(const Patch& patch) {
  if (!can_be_coarsened(patch)) return patch.vertex_count();
  const std::size_t wanted = std::max(k_enough, k_per_border_vertex * border_vertices(patch));
  return std::min(wanted, patch.vertex_count());
}

RemeshedPatch remesh(const Patch& patch, const Constraints& constraints,
                     std::span<const Index> keep) {
  require(patch.inspection(), Purpose::measure);
  const std::vector<unsigned char> marks = kept_marks(patch, constraints, keep);
  const std::size_t wanted = vertices_of_remeshed(patch);
  if (wanted == patch.vertex_count()) return whole(patch, constraints);
  CoarsePatch coarse = coarsen(patch, wanted, CoarseBorder::kept, marks);
  Constraints left = restricted_to(constraints, coarse.source);
  return {Patch(std::move(coarse.mesh)), std::move(left), std::move(coarse.source)};
}

}  // namespace planish
