// Do the two solvers of ControllableLaplacian reach the same minima?

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <planish/evolve/evolve.h>
#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

#include "evolve/methods/controllable_laplacian.h"
#include "evolve/vertex_step/ring_energy_on_line.h"
#include "support/random_fans.h"

namespace planish {
namespace {

constexpr int k_rings = 3'000;
constexpr int k_scan = 400;

struct Move {
  double lambda = 0.0, b = 0.0;
};

/// The middle vertex of a fan, moved by each solver, and its line seen by looking everywhere.
struct BothMoves {
  double b0 = 0.0;  ///< before
  Move model, trust_region;
  double curvature = 0.0;                                ///< of b where trust_region ended
  double lowest = 0.0;                                   ///< b on the way downhill to the bound
  bool one_minimum = true;                               ///< on that way, as far as the scan sees
  double beside_model = 0.0, beside_trust_region = 0.0;  ///< b next to where each ended
};

/// The patch laid out for sweeping and the middle of it.
class Middle {
 public:
  explicit Middle(const TriMesh& mesh) : patch_(mesh), pool_(1), state_(patch_, pool_) {
    while (state_.vertex_of(state_.plan().visits[visit_]) != 0)
      ++visit_;
    const planish::Run& run = *state_.plan().run_of(visit_);
    star_ = state_.plan().star(run, visit_);
    line_.emplace(state_.sites().data(), star_, run.valence);
  }

  const RingEnergyOnLine& line() const { return *line_; }

  Move move(const ControllableLaplacian& options) {
    ControllableMover(options, state_).move(visit_, visit_ + 1);
    const Vec3 x = state_.position(star_.center), L = line_->laplacian();
    return {dot(x - line_->start(), L) / dot(L, L), line_->at(x).b.value};
  }

 private:
  Patch patch_;
  ThreadPool pool_;
  PatchState state_;
  std::size_t visit_ = 0;
  Star star_{};
  std::optional<RingEnergyOnLine> line_;
};

/// What is lowest from 0 to `end`, and whether b falls up to there and rises behind.
struct Scan {
  double lowest;
  bool one_minimum = true;
};

Scan scan(const RingEnergyOnLine& line, double b0, double end) {
  Scan seen{b0};
  bool falls = true;
  double last = b0;
  for (int i = 1; i <= k_scan; ++i) {
    const double b = line.at(line.place(end * i / k_scan)).b.value;
    if (b < last && !falls) seen.one_minimum = false;
    falls = b < last;
    last = b;
    seen.lowest = std::min(seen.lowest, b);
  }
  return seen;
}

/// b at a place and a step to either side.
double lowest_beside(const RingEnergyOnLine& line, double lambda, double step, Interval interval) {
  double lowest = line.at(line.place(lambda)).b.value;
  for (const double beside : {lambda - step, lambda + step}) {
    const double at = std::clamp(beside, interval.low, interval.high);
    lowest = std::min(lowest, line.at(line.place(at)).b.value);
  }
  return lowest;
}

BothMoves moves_of(const TriMesh& mesh, double lambda_min) {
  ControllableLaplacian options{.lambda_min = lambda_min, .min_angle = 0.0};
  BothMoves moves;
  moves.model = Middle(mesh).move(options);
  options.solver = LineSolver::trust_region;
  moves.trust_region = Middle(mesh).move(options);

  const Middle middle(mesh);
  const RingEnergyOnLine& line = middle.line();
  const LineSample start = line.at(line.start()).b;
  moves.b0 = start.value;
  moves.curvature = line.at(line.place(moves.trust_region.lambda)).b.curvature;
  const Interval interval{lambda_min, 1.0};
  const Scan seen = scan(line, start.value, start.slope < 0.0 ? interval.high : interval.low);
  moves.lowest = seen.lowest, moves.one_minimum = seen.one_minimum;
  moves.beside_model = lowest_beside(line, moves.model.lambda, 1e-2, interval);
  moves.beside_trust_region = lowest_beside(line, moves.trust_region.lambda, 1e-4, interval);
  return moves;
}

std::vector<BothMoves> moves_on_random_rings(double lambda_min) {
  std::vector<BothMoves> moves;
  meshes::Random random(1);
  for (int i = 0; i < k_rings; ++i) {
    const auto kind = static_cast<meshes::FanKind>(i % 3);
    moves.push_back(moves_of(meshes::RandomFan(random, kind).mesh(), lambda_min));
  }
  return moves;
}

// Where b has one minimum downhill of the start, trust_region is at it, on every ring. The default
// is too, as far as its tolerance goes, but for 1 ring in 400, where its model foretold a value by
// chance and was believed.
void expect_the_same_minimum_where_there_is_one(const std::vector<BothMoves>& moves) {
  int rings = 0, apart = 0, apart_a_little = 0, sharp = 0, sharp_apart = 0, one_stays = 0;
  for (const BothMoves& m : moves) {
    one_stays += (m.model.lambda == 0.0) != (m.trust_region.lambda == 0.0);
    if (!m.one_minimum || (m.model.lambda == 0.0 && m.trust_region.lambda == 0.0)) continue;
    ++rings;
    EXPECT_LE(m.trust_region.b, std::min(m.lowest, m.model.b) + 1e-6 * m.b0);
    apart += std::abs(m.model.b - m.trust_region.b) > 1e-3 * m.b0;
    apart_a_little += std::abs(m.model.b - m.trust_region.b) > 1e-6 * m.b0;
    if (m.curvature < m.b0) continue;
    ++sharp;
    sharp_apart += std::abs(m.model.lambda - m.trust_region.lambda) > 0.01;
  }
  EXPECT_GT(rings, 1800);
  EXPECT_LT(apart, 0.004 * rings);
  EXPECT_LT(apart_a_little, 0.06 * rings);
  EXPECT_GT(sharp, 600);
  EXPECT_LT(sharp_apart, 0.006 * sharp);
  EXPECT_LT(one_stays, 0.002 * k_rings);
}

// Where it has several they may end in different ones. Each ends lower than it began, and nothing
// beside is lower.
void expect_a_minimum_on_each_line(const std::vector<BothMoves>& moves) {
  int rings = 0, apart = 0;
  for (const BothMoves& m : moves) {
    EXPECT_TRUE(m.model.lambda == 0.0 ? m.model.b == m.b0 : m.model.b < m.b0);
    EXPECT_TRUE(m.trust_region.lambda == 0.0 ? m.trust_region.b == m.b0 : m.trust_region.b < m.b0);
    EXPECT_GE(m.beside_trust_region, m.trust_region.b - 1e-7 * m.b0);
    if (m.one_minimum) continue;
    ++rings;
    EXPECT_GE(m.beside_model, m.model.b - 1e-3 * m.b0);
    apart += std::abs(m.model.b - m.trust_region.b) > 1e-3 * m.b0;
  }
  EXPECT_GT(rings, 120);
  EXPECT_LT(apart, 0.08 * rings);
}

class BothSolvers : public testing::TestWithParam<double> {};

TEST_P(BothSolvers, ReachAMinimumOfTheLine) {
  const std::vector<BothMoves> moves = moves_on_random_rings(GetParam());
  expect_the_same_minimum_where_there_is_one(moves);
  expect_a_minimum_on_each_line(moves);
}

INSTANTIATE_TEST_SUITE_P(LambdaMin, BothSolvers, testing::Values(0.0, -1.0));

double energy_after_ten_sweeps(const TriMesh& mesh, ControllableLaplacian options,
                               LineSolver solver) {
  options.solver = solver;
  return evolve(Patch(mesh), options, {.max_sweeps = 10}).history.back().energy;
}

TEST(BothSolversOnPatches, EndTenSweepsWithTheSameEnergyToAThousandth) {
  for (const char* name : {"panel", "dome", "saddle"}) {
    for (const double lambda_min : {0.0, -1.0}) {
      const TriMesh mesh = make_shape(name, 1000);
      const ControllableLaplacian options{.lambda_min = lambda_min};
      const double model = energy_after_ten_sweeps(mesh, options, LineSolver::model);
      const double other = energy_after_ten_sweeps(mesh, options, LineSolver::trust_region);
      EXPECT_NEAR(other, model, 1e-3 * model) << name << " " << lambda_min;
    }
  }
}

}  // namespace
}  // namespace planish
