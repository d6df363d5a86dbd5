#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <vector>

#include <planish/mesh/shapes.h>
#include <planish/unfold/strain.h>
#include <planish/unfold/unfold.h>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "support/meshes.h"
#include "support/watched_job.h"
#include "unfold/disk/disk.h"
#include "unfold/stretch/held_border.h"
#include "unfold/stretch/matched_border.h"

namespace planish {
namespace {

/// Of least stretch.
Pattern matched(const TriMesh& mesh) {
  return unfold(Patch(mesh), {.match_seams = true, .least_stretch = true});
}

Pattern unmatched(const TriMesh& mesh) {
  return unfold(Patch(mesh), {.least_stretch = true});
}

/// Measured without the library's help.
double worst_border_edge(const TriMesh& mesh, const std::vector<Vec2>& flat) {
  double worst = 0.0;
  const Patch patch(mesh);
  for (const auto& loop : patch.border_loops()) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Index a = loop[k], b = loop[(k + 1) % loop.size()];
      const double length = norm(mesh.positions[b] - mesh.positions[a]);
      worst = std::max(worst, std::abs(norm(flat[b] - flat[a]) / length - 1.0));
    }
  }
  return worst;
}

/// The energy that is to be least, from the public stretches.
double energy_of(const TriMesh& mesh, const std::vector<Vec2>& flat) {
  const auto stretches = principal_stretches(mesh, flat);
  double energy = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& tri = mesh.triangles[t];
    const Vec3 a = mesh.positions[tri[0]];
    const double area = 0.5 * norm(cross(mesh.positions[tri[1]] - a, mesh.positions[tri[2]] - a));
    for (const double s : {stretches[t].max, stretches[t].min})
      energy += area * (s - 1.0 / s) * (s - 1.0 / s);
  }
  return energy;
}

/// What the border's bending adds to that energy, by the turns of the pattern of least stretch.
double bend_of(const TriMesh& mesh, const std::vector<Vec2>& flat, const std::vector<Vec2>& least) {
  const auto loop = Patch(mesh).border_loops().front();
  const std::size_t n = loop.size();
  const auto turn = [&](const std::vector<Vec2>& places, std::size_t k) {
    const Vec2 a = places[loop[(k + n - 1) % n]], b = places[loop[k]],
               c = places[loop[(k + 1) % n]];
    return std::atan2(cross(b - a, c - b), dot(b - a, c - b));
  };
  double area = 0.0, sum = 0.0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 a = mesh.positions[t[0]];
    area += 0.5 * norm(cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a));
  }
  for (std::size_t k = 0; k < n; ++k) {
    const Vec3 a = mesh.positions[loop[(k + n - 1) % n]], b = mesh.positions[loop[k]],
               c = mesh.positions[loop[(k + 1) % n]];
    const double change = turn(flat, k) - turn(least, k);
    sum += change * change / (0.5 * (norm(b - a) + norm(c - b)));
  }
  return HeldBorder::k_stiffness * area * std::sqrt(area) * sum;
}

TEST(MatchSeams, KeepsEveryBorderLengthHoweverCurvedThePatch) {
  for (const Shape& shape : shapes()) {
    for (const std::size_t n : {100U, 1200U}) {
      const TriMesh mesh = make_shape(shape.name, n);
      const Pattern pattern = matched(mesh);
      EXPECT_LT(worst_border_edge(mesh, pattern.positions), 1e-11) << shape.name;
      EXPECT_EQ(pattern.flipped_triangles, 0U) << shape.name;
      EXPECT_TRUE(pattern.converged) << shape.name;
      EXPECT_EQ(pattern.unmatched_least_stretch.size(), mesh.positions.size());
    }
  }
}

TEST(MatchSeams, LeavesTheOrdinaryPatternAsItIs) {
  const TriMesh mesh = make_shape("saddle", 500);
  const Pattern plain = unmatched(mesh);
  EXPECT_TRUE(plain.unmatched_least_stretch.empty());
  EXPECT_GT(worst_border_edge(mesh, plain.positions), 1e-4);
  const Pattern pattern = matched(mesh);
  EXPECT_NEAR(energy_of(mesh, pattern.unmatched_least_stretch), energy_of(mesh, plain.positions),
              1e-9 * energy_of(mesh, plain.positions));
  EXPECT_GT(energy_of(mesh, pattern.positions), energy_of(mesh, plain.positions));
}

TEST(MatchSeams, PutsThePeakOfATripodIntoTheMiddle) {
  const TriMesh tripod = meshes::fan(3, 0.8);  // its border can only be one triangle
  const Pattern pattern = matched(tripod);
  for (Index v = 1; v <= 3; ++v) {
    EXPECT_NEAR(norm(pattern.positions[v] - pattern.positions[0]), 1.0, 1e-6);
    EXPECT_NEAR(norm(pattern.positions[v] - pattern.positions[v % 3 + 1]), std::sqrt(3.0), 1e-11);
  }
}

/// At the least energy what pulls at the vertices is along border edges only.
TEST(MatchSeams, LeavesNothingToGainAmongPatternsOfThatBorder) {
  for (const char* name : {"dome", "saddle"}) {
    const TriMesh mesh = make_shape(name, 150);
    std::vector<Vec2> flat = matched(mesh).positions;
    const std::vector<Vec2> least = unmatched(mesh).positions;
    const auto energy = [&] { return energy_of(mesh, flat) + bend_of(mesh, flat, least); };
    const auto unknowns = static_cast<Eigen::Index>(2 * flat.size());
    Eigen::VectorXd gradient(unknowns);
    for (Eigen::Index i = 0; i < unknowns; ++i) {
      Vec2& p = flat[static_cast<std::size_t>(i / 2)];
      double& coordinate = i % 2 == 0 ? p.x : p.y;
      const double at = coordinate, h = 1e-4;
      coordinate = at + h;
      const double above = energy();
      coordinate = at - h;
      gradient[i] = (above - energy()) / (2.0 * h);
      coordinate = at;
    }
    const auto loop = Patch(mesh).border_loops().front();
    Eigen::MatrixXd normals =
        Eigen::MatrixXd::Zero(unknowns, static_cast<Eigen::Index>(loop.size()));
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Index a = loop[k], b = loop[(k + 1) % loop.size()];
      const Vec2 d = (1.0 / norm(flat[b] - flat[a])) * (flat[b] - flat[a]);
      const auto column = static_cast<Eigen::Index>(k);
      normals(2 * a, column) = -d.x, normals(2 * a + 1, column) = -d.y;
      normals(2 * b, column) = d.x, normals(2 * b + 1, column) = d.y;
    }
    const Eigen::VectorXd pulls = normals.colPivHouseholderQr().solve(gradient);
    EXPECT_LT((gradient - normals * pulls).norm(), 2e-3 * gradient.norm()) << name;
    EXPECT_GT(gradient.norm(), 1e-3) << name;  // so there is something to hold against
  }
}

/// Half of a body with a waist.
TriMesh half_waist() {
  constexpr double columns = 24.0, rows = 48.0;
  TriMesh mesh = meshes::flat_grid(24, 48);
  for (Vec3& p : mesh.positions) {
    const double angle = std::numbers::pi * p.x / columns, z = 2.0 * p.y / rows - 1.0;
    const double radius = 1.0 - 0.35 * std::exp(-std::pow(z / 0.35, 2.0));
    p = {radius * std::cos(angle), radius * std::sin(angle), 1.5 * z};
  }
  return mesh;
}

/// Least stretch makes the sides of a waist shorter, and what is too long must not become teeth.
TEST(MatchSeams, BendsABorderThatIsTooLongWithoutTeeth) {
  const TriMesh mesh = half_waist();
  const Patch patch(mesh);
  const auto loop = patch.border_loops().front();
  const std::size_t n = loop.size();
  const auto turns = [&](const std::vector<Vec2>& flat) {
    std::vector<double> all;
    for (std::size_t k = 0; k < n; ++k) {
      const Vec2 before = flat[loop[k]] - flat[loop[(k + n - 1) % n]];
      const Vec2 after = flat[loop[(k + 1) % n]] - flat[loop[k]];
      all.push_back(std::atan2(cross(before, after), dot(before, after)));
    }
    return all;
  };
  const Pattern pattern = matched(mesh);
  const std::vector<double> now = turns(pattern.positions),
                            least = turns(pattern.unmatched_least_stretch);
  double length = 0.0, wanted = 0.0, most = 0.0;
  for (std::size_t k = 0; k < n; ++k) {
    const Index v = loop[k], w = loop[(k + 1) % n];
    length += norm(pattern.unmatched_least_stretch[w] - pattern.unmatched_least_stretch[v]);
    wanted += norm(mesh.positions[w] - mesh.positions[v]);
    most = std::max(most, std::abs(now[k] - least[k]));
  }
  EXPECT_GT(wanted, 1.005 * length) << "there is something to be taken up";
  EXPECT_LT(most, 0.1) << "teeth turn by more than a radian";
}

TEST(MatchSeams, GivesTwoPatchesEquallyLongSidesOfTheirSeam) {
  // One surface cut along a column; both sides have the same vertices.
  TriMesh left =
      meshes::height_field(8, 8, [](double x, double y) { return 0.2 * x * x - 0.1 * y * y; });
  TriMesh right = meshes::height_field(
      8, 8, [](double x, double y) { return 0.2 * (x + 8) * (x + 8) - 0.1 * y * y; });
  for (Vec3& p : right.positions)
    p.x += 8.0;
  const auto side = [](const Pattern& pattern, std::size_t column) {
    double length = 0.0;
    for (std::size_t j = 0; j < 8; ++j) {
      length += norm(pattern.positions[9 * (j + 1) + column] - pattern.positions[9 * j + column]);
    }
    return length;
  };
  EXPECT_NEAR(side(matched(left), 8), side(matched(right), 0), 1e-10);
  EXPECT_GT(std::abs(side(unmatched(left), 8) - side(unmatched(right), 0)), 1e-3);
}

using Edges = std::vector<std::array<Index, 2>>;

/// Of the only border loop, those that a rule is true of, by the place of their first vertex.
template <class Rule>
Edges border_edges(const TriMesh& mesh, Rule rule) {
  const Patch patch(mesh);
  const std::vector<Index>& loop = patch.border_loops().front();
  Edges edges;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Index v = loop[k], w = loop[(k + 1) % loop.size()];
    if (rule(mesh.positions[v], mesh.positions[w])) edges.push_back({w, v});
  }
  return edges;
}

TEST(FreeEdges, MayChangeTheirLengthAndTheOthersKeepIt) {
  const TriMesh mesh =
      meshes::height_field(12, 9, [](double x, double y) { return 0.05 * (x * x - 0.7 * y * y); });
  const auto on_the_left = [](Vec3 v, Vec3 w) { return v.x < 0.5 && w.x < 0.5; };
  const Edges free = border_edges(mesh, [&](Vec3 v, Vec3 w) { return !on_the_left(v, w); });
  const Patch patch(mesh);
  const Pattern pattern =
      unfold(patch, {.match_seams = true, .free_edges = free, .least_stretch = true});
  EXPECT_TRUE(pattern.converged);
  EXPECT_EQ(pattern.flipped_triangles, 0U);
  EXPECT_LT(largest_border_strain(patch, pattern.positions, free), 1e-9);
  EXPECT_GT(largest_border_strain(patch, pattern.positions), 1e-3);
  // More freedom, less stretch.
  const double least = energy_of(mesh, unmatched(mesh).positions);
  const double all = energy_of(mesh, matched(mesh).positions);
  const double some = energy_of(mesh, pattern.positions);
  EXPECT_GT(some, least * (1.0 + 1e-6));
  EXPECT_LT(some, 0.9 * all);
}

TEST(FreeEdges, OfTheWholeBorderLeaveThePatternOfLeastStretch) {
  for (const char* name : {"saddle", "dome"}) {
    const TriMesh mesh = make_shape(name, 400);
    const Patch patch(mesh);
    const Edges all = border_edges(mesh, [](Vec3, Vec3) { return true; });
    const Pattern pattern =
        unfold(patch, {.match_seams = true, .free_edges = all, .least_stretch = true});
    const Pattern least = unmatched(mesh);
    EXPECT_EQ(largest_border_strain(patch, pattern.positions, all), 0.0) << "none is left";
    EXPECT_NEAR(energy_of(mesh, pattern.positions), energy_of(mesh, least.positions),
                1e-6 * energy_of(mesh, least.positions))
        << name;
  }
}

/// Of small moves of a vertex that keep the lengths that are to be kept, none stretches less.
TEST(FreeEdges, LeaveNothingToGain) {
  const TriMesh mesh =
      meshes::height_field(6, 5, [](double x, double y) { return 0.08 * (x * x + 0.5 * y * y); });
  const Edges free = border_edges(mesh, [](Vec3 v, Vec3 w) { return v.x > 0.5 || w.x > 0.5; });
  std::vector<Vec2> flat =
      unfold(Patch(mesh), {.match_seams = true, .free_edges = free, .least_stretch = true})
          .positions;
  const double least = energy_of(mesh, flat);
  constexpr double step = 1e-3;
  for (std::size_t v = 0; v < flat.size(); ++v) {
    // Not beside an edge that keeps its length, nor where the border turns at such a one.
    if (mesh.positions[v].x < 1.5) continue;
    for (const Vec2 move : {Vec2{step, 0.0}, Vec2{-step, 0.0}, Vec2{0.0, step}, Vec2{0.0, -step}}) {
      const Vec2 place = flat[v];
      flat[v] = place + move;
      EXPECT_GT(energy_of(mesh, flat), least) << v;
      flat[v] = place;
    }
  }
}

TEST(MatchSeams, GivesEdgesTheLengthsThatAreAskedFor) {
  const TriMesh mesh = make_shape("dome", 200);
  const Patch patch(mesh);
  UnfoldOptions options{.match_seams = true};
  options.least_stretch = true;
  const std::vector<Index>& loop = patch.border_loops().front();
  std::map<std::array<Index, 2>, double> wanted;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Index v = loop[k], w = loop[(k + 1) % loop.size()];
    const double own = norm(mesh.positions[w] - mesh.positions[v]);
    wanted[{v, w}] = own;
    if (k % 2 == 0) continue;
    wanted[{v, w}] = 1.02 * own;
    options.seam_lengths.push_back({{w, v}, 1.02 * own});
  }
  const Pattern pattern = unfold(patch, options);
  for (const auto& [edge, length] : wanted) {
    const Vec2 along = pattern.positions[edge[1]] - pattern.positions[edge[0]];
    EXPECT_NEAR(norm(along), length, 1e-9 * length);
  }
  for (const double bad : {0.0, -1.0, std::numeric_limits<double>::infinity()}) {
    options.seam_lengths.back().length = bad;
    EXPECT_THROW(unfold(patch, options), Error);
  }
}

TEST(MatchSeams, HasAStartForAnyBorder) {
  ThreadPool alone(1);
  // Also a border with one long side, which the circle's centre lies beyond.
  TriMesh fans[] = {meshes::fan(7, 0.3), meshes::ruffled_fan(8, 1.5), meshes::fan(9, 0.0)};
  fans[2].positions[1] = {6.0, -1.0, 0.0};
  for (const TriMesh& mesh : fans) {
    const Disk disk = make_disk(Patch(mesh));
    const auto lengths = border_lengths(mesh, disk);
    const auto flat = circle_start(disk, lengths, alone);
    EXPECT_TRUE(all_upright(disk, flat));
    for (std::size_t k = 0; k < lengths.size(); ++k) {
      const Vec2 a = flat[disk.border[k]], b = flat[disk.border[(k + 1) % lengths.size()]];
      EXPECT_NEAR(norm(b - a), lengths[k], 1e-9);
    }
  }
}

TEST(MatchSeams, ReportsEveryStepAndCanBeCancelledAfterAny) {
  const Patch dome(make_shape("dome", 1000));
  WatchedJob job;
  const Pattern pattern = unfold(dome, {.match_seams = true, .least_stretch = true}, job.context());
  EXPECT_EQ(job.reports(), pattern.iterations);
  expect_cancellable([&](const Context& context) {
    unfold(dome, {.match_seams = true, .least_stretch = true}, context);
  });
}

TEST(MatchSeams, DoesWithoutAnyStep) {
  for (const TriMesh& mesh : {meshes::flat_grid(3, 2), make_shape("dome", 100)}) {
    const Pattern pattern = unfold(Patch(mesh), {.max_iterations = 0, .match_seams = true});
    EXPECT_LT(worst_border_edge(mesh, pattern.positions), 1e-9);
    EXPECT_EQ(pattern.flipped_triangles, 0U);
  }
}

}  // namespace
}  // namespace planish
