#include "evolve/auto/shared/coarse_levels.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "evolve/auto/shared/tuning.h"
#include "evolve/state/fixed_marks.h"
#include "mesh/symmetry/coarsen_mirrored.h"

namespace planish {

namespace {

/// Triangles are sorted, so that levels do not depend on the order in the file.
TriMesh sorted_mesh(const PatchState& patch) {
  TriMesh mesh = mesh_at_first(patch);
  for (Triangle& t : mesh.triangles)
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  std::sort(mesh.triangles.begin(), mesh.triangles.end());
  return mesh;
}

Constraints constraints_of(const PatchState& patch) {
  Constraints constraints;
  bool weighted = false;
  for (Index v = 0; v < patch.vertex_count(); ++v) {
    if (patch.is_fixed(v)) constraints.fixed.push_back(v);
    constraints.weights.push_back(patch.weight(v));
    weighted = weighted || patch.weight(v) != 1.0;
  }
  if (!weighted) constraints.weights.clear();
  return constraints;
}

/// Number in the state of each vertex of the mesh that a level was made from.
std::vector<Index> numbers_in(const PatchState& state, std::size_t level, std::size_t vertices) {
  std::vector<Index> numbers(vertices, 0);
  for (Index v = 0; v < state.vertex_count(); ++v)
    numbers[level > 0 ? state.vertex_of(v) : v] = v;
  return numbers;
}

}  // namespace

CoarseLevels::CoarseLevels(const PatchState& patch, std::size_t small, MirrorOrbits orbits,
                           const ThreadPool& pool) {
  if (patch.inner_count() < small) return;
  Patch fine(sorted_mesh(patch));
  if (!can_be_coarsened(fine)) return;
  Constraints constraints = constraints_of(patch);
  while (fine.vertex_count() > small) {
    const std::size_t count = fine.vertex_count(), wanted = count / tuning::k_thinning;
    const std::vector<unsigned char> kept = fixed_marks(constraints, count);
    std::optional<CoarsePatch> mirrored =
        coarsen_mirrored(fine, orbits, wanted, CoarseBorder::thinned, kept, &pool);
    if (!mirrored) orbits = {};
    CoarsePatch coarse =
        mirrored ? *std::move(mirrored) : coarsen(fine, wanted, CoarseBorder::thinned, kept, &pool);
    if (2 * coarse.source.size() > count) break;  // no worthwhile step
    fine = Patch(std::move(coarse.mesh));
    orbits = orbits.of_part(coarse.source);
    constraints = restricted_to(constraints, coarse.source);
    levels_.push_back({fine, std::move(coarse.source), constraints, orbits});
  }
}

std::unique_ptr<PatchState> CoarseLevels::make_state(std::size_t level, ThreadPool& pool) const {
  const Level& made = levels_[level - 1];
  return std::make_unique<PatchState>(made.patch, pool, made.constraints, made.orbits);
}

void CoarseLevels::lift(std::size_t level, const PatchState& coarse, const FairnessEnergy& cost,
                        PatchState& fine, ThreadPool& pool) const {
  const std::span<const unsigned char> movable = cost.movable();
  const std::vector<Index>& source = levels_[level - 1].source;
  const std::size_t fine_vertices =
      level > 1 ? levels_[level - 2].patch.vertex_count() : fine.vertex_count();
  const std::vector<Index> numbers = numbers_in(fine, level - 1, fine_vertices);
  const std::size_t count = cost.origin().size();
  std::vector<unsigned char> given(count, 0);
  Positions moves(count);
  for (Index v = 0; v < coarse.vertex_count(); ++v) {
    const Index to = numbers[source[coarse.vertex_of(v)]];
    // What is a corner here, and must stay, may be none on the coarse level.
    const bool stays = to < count && !fine.is_inner(to) && !movable[to];
    if (to >= count || stays) continue;
    given[to] = 1;
    moves[to] = (fine.scale() / coarse.scale()) * (coarse.position(v) - coarse.origin(v));
  }
  const Positions spread = cost.spread(given, moves, pool);
  for (Index v = 0; v < count; ++v) {
    if (!fine.is_fixed(v)) fine.move(v, fine.origin(v) + spread[v]);
  }
}

}  // namespace planish
