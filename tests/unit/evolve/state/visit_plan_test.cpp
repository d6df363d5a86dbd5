#include "evolve/state/visit_plan.h"

#include <algorithm>
#include <map>
#include <set>

#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

#include "evolve/state/patch_state.h"
#include "support/inner_rings.h"
#include "support/meshes.h"

namespace planish {
namespace {

struct Planned {
  TriMesh mesh;
  Patch surface{mesh};
  ThreadPool pool;
  PatchState state{surface, pool};

  explicit Planned(TriMesh m, unsigned threads = 2) : mesh(std::move(m)), pool(threads) {}
  const VisitPlan& plan() const { return state.plan(); }
};

/// Enough vertices for several pieces, seams between them, and seams of the seams.
TriMesh large_panel() {
  return make_shape("panel", 60'000);
}

TEST(VisitPlan, VisitsEveryInnerVertexOnceWithItsRing) {
  const Planned planned(large_panel());
  const VisitPlan& plan = planned.plan();
  std::vector<int> visits(planned.state.inner_count(), 0);
  std::size_t visited = 0;
  for (const planish::Run& run : plan.runs) {
    EXPECT_EQ(run.begin, visited);
    visited = run.end;
    for (std::size_t i = run.begin; i < run.end; ++i) {
      const Index v = plan.visits[i];
      ++visits[v];
      // The same neighbours in the same order as in the mesh.
      const auto expected = planned.surface.ring(planned.state.vertex_of(v));
      ASSERT_EQ(run.valence, expected.size());
      for (std::size_t j = 0; j < expected.size(); ++j)
        EXPECT_EQ(planned.state.vertex_of(plan.ring(run, i)[j]), expected[j]);
    }
  }
  EXPECT_EQ(visited, planned.state.inner_count());
  EXPECT_EQ(*std::min_element(visits.begin(), visits.end()), 1);
  EXPECT_EQ(plan.piece_start.back(), visited);
  EXPECT_EQ(plan.stage_start.back(), plan.piece_start.size() - 1);
  EXPECT_EQ(plan.stage_start.size(), 4U);  // insides, seams, the rest
}

/// The inner vertices in the closed rings of the visits from begin to end - 1 in a run.
std::multiset<Index> seen(const Planned& planned, const planish::Run& run, std::size_t begin,
                          std::size_t end) {
  std::multiset<Index> all;
  for (std::size_t i = begin; i < end; ++i) {
    all.insert(planned.plan().visits[i]);
    for (const Index w : planned.plan().ring(run, i)) {
      if (planned.state.is_inner(w)) all.insert(w);
    }
  }
  return all;
}

TEST(VisitPlan, RunsHoldVerticesThatDoNotSeeEachOther) {
  const Planned planned(large_panel());
  for (const planish::Run& run : planned.plan().runs) {
    const auto all = seen(planned, run, run.begin, run.end);
    EXPECT_EQ(std::set<Index>(all.begin(), all.end()).size(), all.size());
  }
}

TEST(VisitPlan, PiecesOfAStageDoNotSeeEachOther) {
  const Planned planned(large_panel());
  const VisitPlan& plan = planned.plan();
  for (std::size_t stage = 0; stage + 1 < plan.stage_start.size(); ++stage) {
    std::map<Index, std::size_t> seen_by;
    for (std::size_t piece = plan.stage_start[stage]; piece < plan.stage_start[stage + 1];
         ++piece) {
      plan.for_runs(plan.piece_start[piece], plan.piece_start[piece + 1],
                    [&](const planish::Run& run, std::size_t begin, std::size_t end) {
                      for (const Index v : seen(planned, run, begin, end))
                        EXPECT_EQ(seen_by.emplace(v, piece).first->second, piece);
                    });
    }
  }
}

TEST(VisitPlan, ColorsTellTheOrderOfVisitsThatSeeEachOther) {
  const Planned planned(large_panel());
  const VisitPlan& plan = planned.plan();
  std::vector<Index> color_of(planned.state.inner_count()), visit_of(color_of);
  for (const planish::Run& run : plan.runs) {
    for (Index i = run.begin; i < run.end; ++i)
      color_of[plan.visits[i]] = run.color, visit_of[plan.visits[i]] = i;
    EXPECT_LT(run.color, plan.color_count);
  }
  for (const planish::Run& run : plan.runs) {
    for (Index i = run.begin; i < run.end; ++i) {
      for (const Index w : plan.ring(run, i)) {
        if (!planned.state.is_inner(w)) continue;
        EXPECT_EQ(color_of[w] < run.color, visit_of[w] < i);
      }
    }
  }
}

TEST(VisitPlan, IsTheSameOnAnyNumberOfThreads) {
  const Planned one(large_panel(), 1);
  for (const unsigned threads : {2U, 4U}) {
    const Planned other(large_panel(), threads);
    EXPECT_EQ(other.plan().visits, one.plan().visits);
    EXPECT_EQ(other.plan().piece_start, one.plan().piece_start);
    EXPECT_EQ(other.plan().stage_start, one.plan().stage_start);
  }
}

TEST(VisitPlan, LeavesLittleToTheLastStage) {
  const Planned planned(large_panel());
  const VisitPlan& plan = planned.plan();
  const auto part_after = [&](std::size_t stage) {
    const std::size_t left = plan.visits.size() - plan.piece_start[plan.stage_start[stage]];
    return static_cast<double>(left) / static_cast<double>(plan.visits.size());
  };
  EXPECT_LT(part_after(1), 0.1);
  EXPECT_LT(part_after(2), 0.01);
}

TEST(VisitPlan, TakesVerticesThatAllLieInOnePlace) {
  // No curve can tell them apart: most are seams, and all must still be visited apart.
  TriMesh mesh = make_shape("panel", 20'000);
  for (Vec3& p : mesh.positions)
    p = 1e-9 * p;
  mesh.positions[Patch(mesh).border_loops()[0][0]] = {1e3, 0.0, 0.0};
  const Planned planned(mesh);
  std::set<Index> visited(planned.plan().visits.begin(), planned.plan().visits.end());
  EXPECT_EQ(visited.size(), planned.state.inner_count());
}

}  // namespace
}  // namespace planish
