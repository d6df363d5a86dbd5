// Patterns within limits: what is promised of them, and the solver against plain searches.

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <numeric>
#include <string_view>
#include <vector>

#include <planish/core/error.h>
#include <planish/core/range.h>
#include <planish/evolve/method.h>
#include <planish/mesh/shapes.h>
#include <planish/unfold/strain.h>
#include <planish/unfold/unfold.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/meshes.h"
#include "support/watched_job.h"
#include "unfold/stretch/bounded_stretch.h"
#include "unfold/stretch/flat_steps.h"
#include "unfold/stretch/stretch_system.h"

namespace planish {
namespace {

struct Unfolded {
  TriMesh mesh;
  Patch surface;
  Pattern pattern;
  EdgeStrain strain;

  Unfolded(const TriMesh& patch, const StrainLimits& limits, unsigned threads = 0)
      : mesh(patch),
        surface(mesh),
        pattern(unfold(surface, {.least_stretch = true, .limits = limits}, {.threads = threads})),
        strain(edge_strain(surface, pattern.positions)) {}
};

TriMesh panel() {
  return make_shape("panel", 600);
}

TEST(StrainLimits, OfEveryEdgeAreKeptWithLittleMoreStretch) {
  for (const char* shape : {"panel", "saddle", "dome"}) {
    const TriMesh mesh = make_shape(shape, 600);
    const Unfolded least(mesh, {});
    for (const double share : {0.9, 0.7, 0.6}) {
      const double limit = share * least.strain.max;
      const Unfolded kept(mesh, {.max = limit});
      EXPECT_LE(kept.strain.max, limit) << shape;
      EXPECT_GT(kept.strain.max, 0.98 * limit) << shape << ": it goes no further than it need";
      EXPECT_TRUE(kept.pattern.converged) << shape;
      EXPECT_EQ(kept.pattern.flipped_triangles, 0U) << shape;
      EXPECT_LT(kept.strain.rms, 1.35 * least.strain.rms) << shape;
    }
  }
}

TEST(StrainLimits, ThatLeastStretchKeepsChangeNothing) {
  const Unfolded least(panel(), {});
  for (const StrainLimits& limits : {StrainLimits{.max = least.strain.max * (1.0 + 1e-9)},
                                     StrainLimits{.p99 = least.strain.p99 * (1.0 + 1e-9)},
                                     StrainLimits{.rms = least.strain.rms * (1.0 + 2e-4)}}) {
    const Unfolded same(panel(), limits);
    EXPECT_EQ(same.pattern.positions, least.pattern.positions);
    EXPECT_EQ(same.pattern.iterations, least.pattern.iterations);
    EXPECT_TRUE(same.pattern.least_stretch.empty());
  }
}

TEST(StrainLimits, LeaveThePatternOfLeastStretchBeside) {
  const Unfolded least(panel(), {}), kept(panel(), {.max = 0.7 * least.strain.max});
  const EdgeStrain unlimited = edge_strain(kept.surface, kept.pattern.least_stretch);
  EXPECT_NEAR(unlimited.max, least.strain.max, 1e-12);
  EXPECT_NEAR(unlimited.rms, least.strain.rms, 1e-12);
}

TEST(StrainLimits, OfTheAreaAreKeptOnNinetyNinePerCentOfIt) {
  const Unfolded least(panel(), {});
  for (const double share : {0.9, 0.6}) {
    const double limit = share * least.strain.p99;
    const Unfolded kept(panel(), {.p99 = limit});
    EXPECT_LE(kept.strain.p99, limit);
    EXPECT_LE(kept.strain.max, std::max(3.0 * limit, least.strain.max));
    const auto checks = check_limits(kept.surface, kept.pattern.positions, {.p99 = limit});
    ASSERT_EQ(checks.size(), 1U);
    EXPECT_TRUE(checks[0].met);
    EXPECT_LE(checks[0].share_beyond, 0.01);
    EXPECT_EQ(checks[0].value, kept.strain.p99);
  }
}

TEST(StrainLimits, ThatNoPatternKeepsEndNearTheSmallestThatOneDoes) {
  const Unfolded least(panel(), {});
  const double smallest = smallest_limit(least.surface, least.pattern);
  EXPECT_LT(smallest, least.strain.max);
  const Unfolded near(panel(), {.max = 0.5 * smallest});
  EXPECT_GT(near.strain.max, 0.5 * smallest);
  EXPECT_LT(near.strain.max, 1.05 * smallest);
  EXPECT_EQ(near.pattern.flipped_triangles, 0U);
  const auto checks = check_limits(near.surface, near.pattern.positions, {.max = 0.5 * smallest});
  EXPECT_FALSE(all_kept(checks));
  EXPECT_EQ(checks[0].edge, near.strain.worst_edge);
  EXPECT_GT(checks[0].share_beyond, 0.0);
  // A pattern keeps the limit that smallest_limit() returns.
  EXPECT_LE(Unfolded(panel(), {.max = 1.01 * smallest}).strain.max, 1.01 * smallest);
}

TEST(StrainLimits, ArePassedOverWhereThereIsNoStrainButRounding) {
  const TriMesh flat = meshes::rough_grid(20, 20, 3, 0.3, 0.0);
  const Unfolded least(flat, {});
  ASSERT_LT(least.strain.max, 1e-6);
  WatchedJob job;
  EXPECT_NEAR(smallest_limit(least.surface, least.pattern, job.context()), least.strain.max, 1e-12);
  EXPECT_EQ(job.reports(), 0) << "without a step";
}

/// Moves one vertex after another a little at random, and keeps what makes a figure less.
template <class Figure>
double less_by_chance(std::vector<Vec2> flat, double reach, int tries, const Figure& figure) {
  meshes::Random random(5);
  double best = figure(flat);
  for (int k = 0; k < tries; ++k) {
    const auto v = static_cast<std::size_t>(k) % flat.size();
    const Vec2 before = flat[v];
    flat[v] = before + Vec2{reach * random.number(), reach * random.number()};
    const double now = figure(flat);
    if (now < best) {
      best = now;
    } else {
      flat[v] = before;
    }
  }
  return best;
}

TEST(StrainLimits, TheSmallestIsNotMadeSmallerByChance) {
  const TriMesh mesh = make_shape("dome", 100);
  const Unfolded least(mesh, {});
  const double smallest = smallest_limit(least.surface, least.pattern);
  const Unfolded found(mesh, {.max = 0.9 * smallest});
  const auto largest = [&](const std::vector<Vec2>& flat) {
    return edge_strain(least.surface, flat).max;
  };
  for (const double reach : {1e-1, 1e-2, 1e-3}) {
    EXPECT_GT(
        less_by_chance(found.pattern.positions, reach * found.pattern.width / 50.0, 3000, largest),
        0.99 * smallest);
  }
}

TEST(StrainLimits, NoOtherPatternWithinThemHasLessStretch) {
  const TriMesh mesh = make_shape("dome", 100);
  const Patch patch(mesh);
  const Unfolded least(mesh, {});
  const double limit = 0.75 * least.strain.max;
  const Unfolded kept(mesh, {.max = limit});
  const Disk disk = make_disk(patch);
  const auto on_disk = [&](const std::vector<Vec2>& pattern) {
    std::vector<Vec2> flat;
    for (const Index v : disk.vertex_of)
      flat.push_back(disk.area_scale * (disk.box_scale * pattern[v]));
    return flat;
  };
  const auto edges = flat_edges(mesh, disk);
  const auto energy_within = [&](const std::vector<Vec2>& flat) {
    for (const double strain : strains_of(edges, flat)) {
      if (std::abs(strain) > limit) return std::numeric_limits<double>::infinity();
    }
    return total_energy(disk, flat);
  };
  const std::vector<Vec2> flat = on_disk(kept.pattern.positions);
  const double energy = energy_within(flat);
  EXPECT_LT(energy, 1.5 * total_energy(disk, on_disk(least.pattern.positions)));
  for (const double reach : {1e-2, 1e-3, 1e-4})
    EXPECT_GT(less_by_chance(flat, reach, 5000, energy_within), 0.99 * energy);
}

TEST(StretchSystem, TermsOfEdgesAreDerivatives) {
  // f(d) = |d|^3 of each edge vector d, by differences of the gradient and of the value.
  const TriMesh mesh = make_shape("saddle", 100);
  const Patch patch(mesh);
  const Disk disk = make_disk(patch);
  const auto edges = flat_edges(mesh, disk);
  const Pattern pattern = unfold(patch, {.least_stretch = true});
  std::vector<Vec2> flat;
  for (const Index v : disk.vertex_of)
    flat.push_back(disk.area_scale * (disk.box_scale * pattern.positions[v]));
  flat = turn_to_axis(disk, flat);
  ThreadPool alone(1);
  const auto assembled = [&](const std::vector<Vec2>& at) {
    auto system = std::make_unique<StretchSystem>(disk, alone);
    system->assemble(at, Curvature::full);
    for (const FlatEdge& edge : edges) {
      const Vec2 d = at[edge.to] - at[edge.from];
      const double r = norm(d);
      system->add(
          edge, system->pair_of(edge),
          {3.0 * r * d, 3.0 * (r + d.x * d.x / r), 3.0 * d.x * d.y / r, 3.0 * (r + d.y * d.y / r)});
    }
    return system;
  };
  const auto value = [&](const std::vector<Vec2>& at) {
    double sum = total_energy(disk, at);
    for (const FlatEdge& edge : edges)
      sum += std::pow(norm(at[edge.to] - at[edge.from]), 3.0);
    return sum;
  };
  const auto at_flat = assembled(flat);
  const StretchSystem& system = *at_flat;
  meshes::Random random(3);
  Eigen::VectorXd direction(system.gradient().size());
  for (double& x : direction)
    x = random.number();
  constexpr double h = 1e-6;
  const std::vector<Vec2> move = system.spread(direction);
  const auto ahead = moved(flat, h, move), behind = moved(flat, -h, move);
  EXPECT_NEAR(system.gradient().dot(direction), (value(ahead) - value(behind)) / (2.0 * h),
              1e-6 * system.gradient().norm());
  const Eigen::VectorXd along = system.hessian().selfadjointView<Eigen::Lower>() * direction;
  const Eigen::VectorXd by_differences =
      (assembled(ahead)->gradient() - assembled(behind)->gradient()) / (2.0 * h);
  EXPECT_LT((along - by_differences).norm(), 1e-6 * along.norm());
}

TEST(FlatEdges, AreAllOfTheMeshWithTheirLengthsAndAreas) {
  const TriMesh mesh = panel();
  const Patch patch(mesh);
  const Disk disk = make_disk(patch);
  const auto edges = flat_edges(mesh, disk);
  EXPECT_EQ(edges.size(), disk.vertex_count + disk.triangles.size() - 1) << "Euler's formula";
  double area = 0.0;
  for (const FlatEdge& edge : edges) {
    const Vec3 d =
        mesh.positions[disk.vertex_of[edge.to]] - mesh.positions[disk.vertex_of[edge.from]];
    EXPECT_NEAR(edge.length, disk.area_scale * disk.box_scale * norm(d), 1e-14);
    area += edge.area;
  }
  EXPECT_NEAR(area, 1.0, 1e-12);
}

TEST(StrainLimits, GiveTheSameBitsOnAnyNumberOfThreadsAndAtAnyScaleOfTwo) {
  TriMesh mesh = panel();
  const Unfolded one(mesh, {.max = 0.03}, 1);
  ASSERT_FALSE(one.pattern.least_stretch.empty());
  EXPECT_EQ(Unfolded(mesh, {.max = 0.03}, 3).pattern.positions, one.pattern.positions);
  for (Vec3& p : mesh.positions)
    p = 1024.0 * p;
  const Unfolded large(mesh, {.max = 0.03});
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    EXPECT_EQ(large.pattern.positions[v], 1024.0 * one.pattern.positions[v]);
}

TEST(StrainLimits, GiveTwinsTheSamePattern) {
  const TriMesh mesh = panel();
  const Unfolded one(mesh, {.max = 0.03});
  ASSERT_FALSE(one.pattern.least_stretch.empty());
  // Renumbered from the end, turned, and rounded to single precision.
  const auto rounded = [](double x) { return static_cast<double>(static_cast<float>(x)); };
  TriMesh twin;
  const auto last = static_cast<Index>(mesh.positions.size() - 1);
  for (auto p = mesh.positions.rbegin(); p != mesh.positions.rend(); ++p) {
    const Vec3 turned{0.6 * p->x - 0.8 * p->z, p->y, 0.8 * p->x + 0.6 * p->z};
    twin.positions.push_back({rounded(turned.x), rounded(turned.y), rounded(turned.z)});
  }
  for (const Triangle& t : mesh.triangles)
    twin.triangles.push_back({last - t[1], last - t[2], last - t[0]});
  const Unfolded other(twin, {.max = 0.03});
  double apart = 0.0;
  for (const Triangle& t : mesh.triangles) {
    const auto length = [](const Pattern& pattern, Index v, Index w) {
      return norm(pattern.positions[v] - pattern.positions[w]);
    };
    // Lengths across the pattern, which need no fitting.
    apart = std::max(
        apart, std::abs(length(one.pattern, t[0], 0) - length(other.pattern, last - t[0], last)));
  }
  EXPECT_LT(apart, 1e-4 * one.pattern.width);
}

TEST(StrainLimits, PassByNeedles) {
  // Vertices pushed nearly onto an opposite side: angles down to a tenth of a degree.
  TriMesh mesh = panel();
  const Patch patch(mesh);
  for (std::size_t k = 40; k < mesh.triangles.size(); k += 150) {
    const Triangle& t = mesh.triangles[k];
    if (!patch.is_inner(t[0])) continue;
    const Vec3 middle = 0.5 * mesh.positions[t[1]] + 0.5 * mesh.positions[t[2]];
    mesh.positions[t[0]] = mesh.positions[t[0]] + 0.97 * (middle - mesh.positions[t[0]]);
  }
  const Unfolded least(mesh, {});
  const Unfolded kept(mesh, {.max = 0.75 * least.strain.max});
  EXPECT_LE(kept.strain.max, 0.75 * least.strain.max);
  EXPECT_EQ(kept.pattern.flipped_triangles, 0U);
}

TEST(StrainLimits, AreTakenOfATriangleAndOfWhatIsFlat) {
  const TriMesh triangle{{{0, 0, 0}, {3, 0, 1}, {1, 2, 0}}, {{0, 1, 2}}};
  EXPECT_LT(Unfolded(triangle, {.max = 1e-9}).strain.max, 1e-9);
  EXPECT_LT(Unfolded(meshes::flat_grid(5, 5), {.p99 = 1e-9}).strain.max, 1e-9);
}

TEST(StrainLimits, CanBeCancelledAtEveryStep) {
  const Patch patch(panel());
  EXPECT_GT(unfold(patch, {.limits = {.max = 0.03}}).iterations, 8);
  expect_cancellable(
      [&](const Context& context) { unfold(patch, {.limits = {.max = 0.03}}, context); });
}

/// A pattern is shorter where the sheet has to be stretched.
TEST(StrainLimits, OfStretchAndCompressionAreKeptApart) {
  const Unfolded least(panel(), {});
  const double most = least.strain.max;
  for (const auto& [stretch, compression] :
       {std::pair{0.9, 0.45}, std::pair{0.45, 0.9}, std::pair{1.2, 0.3}}) {
    const Unfolded kept(panel(),
                        {.max_stretch = stretch * most, .max_compression = compression * most});
    EXPECT_LE(kept.strain.max_stretch, stretch * most);
    EXPECT_LE(kept.strain.max_compression, compression * most);
    EXPECT_TRUE(kept.pattern.converged);
    EXPECT_EQ(kept.pattern.flipped_triangles, 0U);
  }
}

TEST(StrainLimits, OfOneWayAloneAreKeptByTheSizeOfThePattern) {
  const Unfolded least(panel(), {});
  const double tenth = 0.1 * least.strain.max;
  const Unfolded large(panel(), {.p99_stretch = tenth}), small(panel(), {.max_compression = tenth});
  EXPECT_LE(large.strain.p99_stretch, tenth);
  EXPECT_GT(large.pattern.area_ratio, 1.0);
  EXPECT_LE(small.strain.max_compression, tenth);
  EXPECT_LT(small.pattern.area_ratio, 1.0);
}

TEST(StrainLimits, ThatAreEqualBothWaysGiveTheBitsOfOneForBoth) {
  const Unfolded least(panel(), {});
  const double limit = 0.7 * least.strain.max, of_area = 0.6 * least.strain.p99;
  EXPECT_EQ(Unfolded(panel(), {.max_stretch = limit, .max_compression = limit}).pattern.positions,
            Unfolded(panel(), {.max = limit}).pattern.positions);
  EXPECT_EQ(
      Unfolded(panel(), {.p99_stretch = of_area, .p99_compression = of_area}).pattern.positions,
      Unfolded(panel(), {.p99 = of_area}).pattern.positions);
}

TEST(StrainLimits, OfTheAreaAndOfEveryEdgeAreKeptTogether) {
  const Unfolded least(panel(), {});
  const StrainLimits both = {.max = 0.85 * least.strain.max, .p99 = 0.6 * least.strain.p99};
  const Unfolded area(panel(), {.p99 = both.p99}), kept(panel(), both);
  EXPECT_GT(area.strain.max, both.max) << "or the other limit would say nothing";
  EXPECT_TRUE(both.kept_by(kept.strain));
}

TEST(StrainLimits, AreCheckedEachWithItsPlace) {
  const Unfolded least(panel(), {});
  StrainLimits limits;
  for (const Criterion kind : k_strain_criteria)
    limits.of(kind) = 0.5 * figure_of(least.strain, kind);
  const auto checks = check_limits(least.surface, least.pattern.positions, limits);
  ASSERT_EQ(checks.size(), k_strain_criteria.size());
  for (std::size_t k = 0; k < checks.size(); ++k) {
    const LimitCheck& check = checks[k];
    EXPECT_EQ(check.what, k_strain_criteria[k]);
    EXPECT_EQ(check.value, figure_of(least.strain, check.what)) << to_string(check.what);
    EXPECT_FALSE(check.met) << to_string(check.what);
    EXPECT_GT(check.share_beyond, to_string(check.what).starts_with("p99") ? 0.01 : 0.0);
  }
  const auto strain_at = [&](const LimitCheck& check) {
    const auto [v, w] = check.edge;
    return norm(least.pattern.positions[w] - least.pattern.positions[v]) /
               norm(least.mesh.positions[w] - least.mesh.positions[v]) -
           1.0;
  };
  EXPECT_NEAR(strain_at(checks[3]), -least.strain.max_stretch, 1e-12) << "shorter: stretched";
  EXPECT_NEAR(strain_at(checks[5]), least.strain.max_compression, 1e-12);
  EXPECT_EQ(std::max(least.strain.max_stretch, least.strain.max_compression), least.strain.max);
}

TEST(StrainLimits, BothWaysAskForAsMuchAsTheirMean) {
  EXPECT_EQ(StrainLimits{.p99 = 0.05}.both_ways(), 0.05);
  EXPECT_EQ(StrainLimits{.max = 0.02}.both_ways(), 0.02);
  EXPECT_EQ(
      (StrainLimits{.max_stretch = 0.12, .p99_stretch = 0.08, .p99_compression = 0.02}).both_ways(),
      0.05);
  EXPECT_EQ((StrainLimits{.p99 = 0.06, .p99_stretch = 0.02}).both_ways(), 0.04);
  EXPECT_EQ(StrainLimits{.max_stretch = 0.1}.both_ways(), 0.0) << "a large pattern keeps it";
  EXPECT_EQ(StrainLimits{.rms = 0.1}.both_ways(), 0.0);
}

TEST(StrainLimits, RefuseWhatIsNoLimit) {
  const TriMesh mesh = panel();
  const Patch patch(mesh);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const StrainLimits& limits :
       {StrainLimits{.max = -0.1}, StrainLimits{.p99 = infinity}, StrainLimits{.rms = -infinity},
        StrainLimits{.max = std::nan("")}, StrainLimits{.max_stretch = -0.1},
        StrainLimits{.p99_compression = 1.5}, StrainLimits{.rms = 1.5}}) {
    const std::vector<Vec2> pattern = unfold(patch).positions;
    for (const std::function<void()>& work : std::vector<std::function<void()>>{
             [&] { require(limits); }, [&] { unfold(patch, {.limits = limits}); },
             [&] { check_limits(patch, pattern, limits); }}) {
      try {
        work();
        ADD_FAILURE() << "no error";
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::option_out_of_range);
      }
    }
  }
}

TEST(StrainLimits, AreAtMostThoseThatAutoTakes) {
  Auto options;
  describe(options, [](std::string_view name, auto&, std::string_view, Range range = {}) {
    if (name == "max_strain" || name == "max_rms_strain") {
      EXPECT_EQ(range.min, 0.0) << name;
      EXPECT_EQ(range.max, k_largest_strain_limit) << name;
    }
  });
  EXPECT_NO_THROW(require(StrainLimits{.max = k_largest_strain_limit}));
}

}  // namespace
}  // namespace planish
