// What is promised of runs that never seem to end. Each is short by itself, to be there always;
// PLANISH_LONG_TESTS=1 makes them as long as they are promised.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <vector>

#include <planish/evolve/evolve.h>
#include <planish/flatten/flatten.h>
#include <planish/measure/flattenability.h>
#include <planish/mesh/patch.h>
#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

#include "support/memory.h"

namespace planish {
namespace {

bool is_long() {
  const char* flag = std::getenv("PLANISH_LONG_TESTS");
  return flag != nullptr && *flag != '\0' && *flag != '0';
}

bool is_finite(const TriMesh& mesh) {
  return std::ranges::all_of(mesh.positions,
                             [](Vec3 p) { return std::isfinite(p.x) && std::isfinite(p.y + p.z); });
}

constexpr std::size_t k_megabyte = std::size_t{1} << 20U;

TEST(LongRuns, ThousandsOfSweepsNeitherGrowNorDrift) {
  const TriMesh mesh = make_shape("panel", is_long() ? 195'000 : 3'000);
  const Patch patch(mesh);
  double energy = measure(patch).energy;
  std::size_t early = 0, late = 0;
  int sweeps = 0;
  const auto result = evolve(patch, ControllableLaplacian{}, {.max_sweeps = 1000}, {},
                             {.on_progress = [&](const Progress&) {
                               if (++sweeps == 100) early = resident_bytes();
                               late = resident_bytes();
                             }});
  EXPECT_EQ(result.history.size(), 1000U);
  for (const SweepRecord& record : result.history) {
    EXPECT_LE(record.energy, energy) << record.sweep;
    energy = record.energy;
  }
  // The history itself may grow, and what the system takes in pages.
  EXPECT_LE(late, early + k_megabyte);
  const TriMesh evolved{result.positions, mesh.triangles};
  EXPECT_TRUE(is_finite(evolved));
  // What was updated a thousand times is what is measured afresh.
  EXPECT_NEAR(measure(Patch(evolved)).energy / energy, 1.0, 1e-9);
  for (Index v = 0; v < mesh.positions.size(); ++v) {
    if (!patch.is_inner(v)) {
      ASSERT_EQ(evolved.positions[v], mesh.positions[v]);
    }
  }
}

TEST(LongRuns, ManyPatchesInOneProcessDoNotGrow) {
  const auto flatten_patch = [](int i) {
    const char* shape = i % 2 == 0 ? "panel" : "dome";
    const auto report =
        flatten(Patch(make_shape(shape, 200 + static_cast<std::size_t>(i % 7) * 50)), shape,
                {.method = Auto{}, .stopping = Stopping{.max_sweeps = 5}});
    ASSERT_TRUE(is_finite(report.processed.mesh()));
  };
  const int patches = is_long() ? 1000 : 30;
  std::size_t early = 0;
  for (int i = 0; i < patches; ++i) {
    flatten_patch(i);
    if (i == patches / 3) early = allocated_bytes();
  }
  // Each thread keeps a few freed blocks for itself.
  EXPECT_LE(allocated_bytes(), early + k_megabyte / 16);
}

/// A patch, with and without a fault in its middle.
struct Faulty {
  TriMesh sound, faulty;
  Vec3 middle;
};

/// The inner vertex nearest the middle of the box, moved by what `fault` says.
template <class Fault>
Faulty with_fault(Fault fault) {
  Faulty patch{.sound = make_shape("panel", 4000), .faulty = {}, .middle = {}};
  for (const Vec3 p : patch.sound.positions)
    patch.middle += (1.0 / static_cast<double>(patch.sound.positions.size())) * p;
  Index nearest = 0;
  for (Index v = 0; v < patch.sound.positions.size(); ++v) {
    const auto distance = [&](Index u) { return norm(patch.sound.positions[u] - patch.middle); };
    if (distance(v) < distance(nearest)) nearest = v;
  }
  patch.faulty = patch.sound;
  fault(patch.faulty, nearest);
  return patch;
}

/// What evolving leaves of a patch beyond a quarter of its size from the middle.
struct FarAway {
  double most_defect = 0.0;  ///< radians
  double energy = 0.0;       ///< square radians
};

FarAway far_from(Vec3 middle, const TriMesh& sound, const std::vector<Vec3>& evolved) {
  double size = 0.0;
  for (const Vec3 p : sound.positions)
    size = std::max(size, norm(p - middle));
  const std::vector<double> defects = angle_defects(Patch(sound).with_positions(evolved));
  FarAway far;
  for (std::size_t v = 0; v < defects.size(); ++v) {
    if (norm(sound.positions[v] - middle) < 0.25 * size) continue;
    far.most_defect = std::max(far.most_defect, std::abs(defects[v]));
    far.energy += defects[v] * defects[v];
  }
  return far;
}

/// Evolves both; the faulty one must lose energy in every sweep and be far away as if it were
/// sound.
void expect_no_spread(const Faulty& patch, int sweeps) {
  const Patch surface(patch.sound);
  const Stopping stopping{.max_sweeps = sweeps};
  double energy = measure(Patch(patch.faulty)).energy;
  const auto faulty = evolve(Patch(patch.faulty), ControllableLaplacian{}, stopping);
  for (const SweepRecord& record : faulty.history) {
    EXPECT_LE(record.energy, energy);
    energy = record.energy;
  }
  EXPECT_TRUE(is_finite({faulty.positions, {}}));
  const auto sound = evolve(Patch(patch.sound), ControllableLaplacian{}, stopping);
  const FarAway after_fault = far_from(patch.middle, patch.sound, faulty.positions);
  const FarAway without = far_from(patch.middle, patch.sound, sound.positions);
  EXPECT_LE(after_fault.most_defect, 1.1 * without.most_defect);
  EXPECT_LE(after_fault.energy, 1.1 * without.energy);
}

/// Any neighbour of a vertex.
Index neighbour(const TriMesh& mesh, Index v) {
  for (const Triangle& t : mesh.triangles) {
    if (t[0] == v) return t[1];
  }
  return v;
}

TEST(LongRuns, ASpikeASliverAndAFoldedStarStayWhereTheyAre) {
  const int sweeps = is_long() ? 1000 : 100;
  const auto spike = with_fault([](TriMesh& mesh, Index v) { mesh.positions[v].z += 1e5; });
  const auto sliver = with_fault([](TriMesh& mesh, Index v) {
    const Vec3 beside = mesh.positions[neighbour(mesh, v)];
    mesh.positions[v] = beside + 1e-9 * (mesh.positions[v] - beside);
  });
  const auto folded = with_fault([](TriMesh& mesh, Index v) {
    const Vec3 beside = mesh.positions[neighbour(mesh, v)];
    mesh.positions[v] = beside + (-3.0) * (mesh.positions[v] - beside);
  });
  {
    SCOPED_TRACE("spike");
    expect_no_spread(spike, sweeps);
  }
  {
    SCOPED_TRACE("sliver");
    expect_no_spread(sliver, sweeps);
  }
  {
    SCOPED_TRACE("folded");
    expect_no_spread(folded, sweeps);
  }
}

}  // namespace
}  // namespace planish
