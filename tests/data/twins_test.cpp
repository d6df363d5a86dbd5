// Patches and their twins: mirrored, turned, with other numbers, rounded to 32-bit floats. The
// folder is that of patches_test.cpp.

#include "support/twins.h"

#include <algorithm>
#include <array>
#include <complex>
#include <string_view>
#include <vector>

#include <planish/io/read_mesh.h>
#include <planish/unfold/strain.h>
#include <planish/unfold/unfold.h>

#include <gtest/gtest.h>

#include "mesh/match/twins.h"
#include "support/farthest.h"
#include "support/test_patches.h"

namespace planish {
namespace {

constexpr std::uint64_t k_seed = 7;

TriMesh twin_of(const TriMesh& mesh) {
  return meshes::in_floats(meshes::renumbered(meshes::turned(meshes::mirrored(mesh)), k_seed));
}

TEST(TwinsOfPatches, AreRecognised) {
  for (const PatchFacts& facts : patches()) {
    SCOPED_TRACE(facts.name);
    const TriMesh mesh = read_mesh(facts.path).mesh, other = twin_of(mesh);
    const std::vector<const TriMesh*> both = {&mesh, &other};
    const auto twin = find_twins(both).at(1);
    ASSERT_TRUE(twin);
    const auto moved = [&](Index v) {
      return norm(twin->match.motion(mesh.positions[v]) - other.positions[twin->match.vertex[v]]);
    };
    double most = 0.0;
    for (Index v = 0; v < mesh.positions.size(); ++v)
      most = std::max(most, moved(v));
    EXPECT_LT(most, 2e-6 * bounding_box_diagonal(mesh) + 1e-6);
    // Those that are symmetrical may be taken for a copy, and otherwise than they were made.
    if (!twin->match.mirrored) continue;
    const auto vertex = meshes::shuffled_numbers(mesh.positions.size(), k_seed);
    EXPECT_EQ(twin->match.vertex == vertex, true);
  }
}

/// Largest distance of corresponding places after the best motion of the second.
double farthest_in_plane(const std::vector<Vec2>& one, const std::vector<Vec2>& other) {
  const auto p = centred(one), q = centred(other);
  std::complex<double> turn;
  for (std::size_t v = 0; v < p.size(); ++v)
    turn += p[v] * std::conj(q[v]);
  turn /= std::abs(turn);
  double most = 0.0;
  for (std::size_t v = 0; v < p.size(); ++v)
    most = std::max(most, std::abs(p[v] - turn * q[v]));
  return most;
}

TEST(TwinsOfPatches, HaveMirroredPatternsUnderABoundOfStrain) {
  constexpr std::array<std::string_view, 10> names = {
      "gc_front_4k",  "mhf_front_5k", "gc_back_5k",   "dress_front_5k", "mhm_thigh_5k",
      "gc_sleeve_5k", "car_wing_5k",  "shoe_vamp_4k", "boat_hull_5k",   "jumpsuit_front_3k"};
  constexpr double share = 0.55, most = 1e-4;  // 0.1 mm in a metre of the diagonal
  for (const PatchFacts& facts : patches()) {
    if (std::find(names.begin(), names.end(), facts.path.stem().string()) == names.end()) continue;
    const TriMesh mesh = read_mesh(facts.path).mesh, other = twin_of(mesh);
    const Patch patch(mesh);
    const Pattern least = unfold(patch, {.least_stretch = true});
    const double bound = share * edge_strain(patch, least.positions).max;
    const UnfoldOptions bounded{.limits = {.max = bound}};
    const Pattern pattern = unfold(patch, bounded);
    const Pattern mirrored = unfold(Patch(other), bounded);
    const auto vertex = meshes::shuffled_numbers(mesh.positions.size(), k_seed);
    std::vector<Vec2> back;
    for (const Index v : vertex)
      back.push_back({-mirrored.positions[v].x, mirrored.positions[v].y});
    EXPECT_LT(farthest_in_plane(pattern.positions, back), most * bounding_box_diagonal(mesh))
        << facts.name;
    EXPECT_FALSE(pattern.least_stretch.empty()) << facts.name << ": nothing was bounded";
  }
}

}  // namespace
}  // namespace planish
