#include "evolve/simd/move_stars.h"

#include <cstring>

#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

#include "evolve/methods/controllable_laplacian.h"
#include "evolve/state/sweep.h"
#include "measure/simd/star_defects.h"
#include "support/meshes.h"

namespace planish {
namespace {

/// Stars of few neighbours or very many, nearly all valences from 3 up to 29 in one mesh.
TriMesh many_valences(std::size_t columns = 22, int added = 1500) {
  TriMesh mesh = meshes::rough_grid(columns, columns, 3, 0.3, 0.6);
  // A vertex put into a triangle has valence 3 and adds one to each corner's.
  meshes::Random random(7);
  for (int i = 0; i < added; ++i) {
    const auto share = 0.5 + 0.5 * random.number();
    const auto t =
        static_cast<std::size_t>(share * 0.2 * static_cast<double>(mesh.triangles.size()));
    const auto [a, b, c] = mesh.triangles[t];
    const auto v = static_cast<Index>(mesh.positions.size());
    const auto& p = mesh.positions;
    mesh.positions.push_back((1.0 / 3.0) * (p[a] + p[b] + p[c]) + Vec3{0.0, 0.0, 1e-3});
    mesh.triangles[t] = {a, b, v};
    mesh.triangles.push_back({b, c, v});
    mesh.triangles.push_back({c, a, v});
  }
  return mesh;
}

struct Outcome {
  std::vector<Vec3> positions;
  std::size_t moved = 0;
};

Outcome sweeps_with(Isa isa, const TriMesh& mesh, const ControllableLaplacian& options,
                    bool with_skipping = true, int sweeps = 12) {
  const Patch patch(mesh);
  ThreadPool pool(1);
  PatchState state(patch, pool);
  ControllableMover mover(options, state, isa);
  Outcome outcome;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    if (!with_skipping) mover.forget_idle();
    outcome.moved += visit_all(state.plan(), pool, [&](std::size_t begin, std::size_t end) {
      return mover.move(begin, end);
    });
    state.measure(pool);
  }
  outcome.positions = state.positions_in_mesh_order();
  return outcome;
}

bool same_bits(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec3)) == 0;
}

std::vector<ControllableLaplacian> all_kinds_of_options() {
  return {
      {}, {.lambda_min = -0.5}, {.max_deviation = 0.02}, {.lambda_min = -1.0, .min_angle = 0.0}};
}

TEST(MoveStars, GivesTheSameBitsWithEverySetOfInstructions) {
  for (const TriMesh& mesh : {many_valences(), make_shape("panel", 400), meshes::fan(70, 0.4)}) {
    for (const ControllableLaplacian& options : all_kinds_of_options()) {
      const Outcome expected = sweeps_with(Isa::baseline, mesh, options);
      EXPECT_GT(expected.moved, 0U);
      for (const Isa isa : available_isas()) {
        const Outcome found = sweeps_with(isa, mesh, options);
        EXPECT_EQ(found.moved, expected.moved) << to_string(isa);
        EXPECT_TRUE(same_bits(found.positions, expected.positions)) << to_string(isa);
      }
    }
  }
}

TEST(MoveStars, SkippingWhatCannotHaveChangedChangesNothing) {
  auto options_of_both_solvers = all_kinds_of_options();
  options_of_both_solvers.push_back({.solver = LineSolver::trust_region});
  // As many as it takes to meet a star whose ring changed in the visit before its own.
  for (const TriMesh& mesh : {many_valences(40, 3000), make_shape("saddle", 1000)}) {
    for (const ControllableLaplacian& options : options_of_both_solvers) {
      const Outcome with = sweeps_with(best_isa(), mesh, options, true, 40);
      const Outcome without = sweeps_with(best_isa(), mesh, options, false, 40);
      EXPECT_EQ(with.moved, without.moved);
      EXPECT_TRUE(same_bits(with.positions, without.positions));
    }
  }
}

TEST(StarDefects, GivesTheSameBitsWithEverySetOfInstructions) {
  const TriMesh mesh = many_valences();
  const Patch patch(mesh);
  std::vector<Site> sites;
  for (const Vec3 p : mesh.positions)
    sites.push_back({p.x, p.y, p.z, 0.0});
  for (const Index v : patch.inner_vertices()) {
    const Star star{patch.ring(v).data(), v};
    const Star stars[] = {star, star, star};
    double expected[3], found[3];
    star_defects_for(Isa::baseline)(sites.data(), stars, 3, patch.ring(v).size(), expected);
    for (const Isa isa : available_isas()) {
      star_defects_for(isa)(sites.data(), stars, 3, patch.ring(v).size(), found);
      EXPECT_EQ(std::memcmp(expected, found, sizeof found), 0) << to_string(isa);
    }
  }
}

}  // namespace
}  // namespace planish
