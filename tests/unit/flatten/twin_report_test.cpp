#include "flatten/twin_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <planish/sheet/pattern_sheet.h>

#include <gtest/gtest.h>

#include "sheet/mirrored_place.h"
#include "support/meshes.h"
#include "support/twins.h"

namespace planish {
namespace {

FlattenOptions quick() {
  return {.method = ControllableLaplacian{}, .stopping = Stopping{.max_sweeps = 3}};
}

/// A patch, its report, and another one with how the first lies over it.
struct Pair {
  TriMesh first, second;
  FlattenReport report;
  MeshMatch match;

  std::optional<FlattenReport> twin(const FlattenOptions& options = quick()) const {
    return twin_report(report, Patch(second), match, "right", options);
  }
};

Pair pair_of(TriMesh first, TriMesh second, const FlattenOptions& options = quick()) {
  const std::vector<const TriMesh*> both = {&first, &second};
  MeshMatch match = find_twins(both).at(1).value().match;
  FlattenReport report = flatten(Patch(first), "left", options);
  return {std::move(first), std::move(second), std::move(report), std::move(match)};
}

TriMesh rough() {
  return meshes::rough_grid(9, 7, 3);
}

Pair mirrored_pair(const FlattenOptions& options = quick()) {
  return pair_of(rough(),
                 meshes::in_floats(meshes::renumbered(meshes::turned(meshes::mirrored(rough())))),
                 options);
}

TEST(TwinReport, HasThePatternMirroredToTheBit) {
  const Pair pair = mirrored_pair();
  const FlattenReport twin = pair.twin().value();
  const auto& theirs = pair.report.unfold.pattern;
  const auto& own = twin.unfold.pattern;
  for (std::size_t v = 0; v < theirs.positions.size(); ++v) {
    EXPECT_EQ(own.positions[pair.match.vertex[v]].x, -theirs.positions[v].x);
    EXPECT_EQ(own.positions[pair.match.vertex[v]].y, theirs.positions[v].y);
    EXPECT_FALSE(std::signbit(own.positions[v].x) && own.positions[v].x == 0.0);
  }
  EXPECT_EQ(own.width, theirs.width);
  EXPECT_EQ(twin.name, "right");
  ASSERT_TRUE(twin.twin_of);
  EXPECT_EQ(twin_text(*twin.twin_of), "mirror image of left");
  // Face up: on the right side of its own triangles.
  for (const Triangle& t : twin.input.triangles()) {
    const Vec2 a = own.positions[t[0]], b = own.positions[t[1]], c = own.positions[t[2]];
    EXPECT_GT(cross(b - a, c - a), 0.0);
  }
}

TEST(TwinReport, HasItsOwnBorderAndTheMirroredInside) {
  const Pair pair = mirrored_pair();
  const FlattenReport twin = pair.twin().value();
  const Patch patch(pair.first);
  std::size_t moved = 0;
  for (Index v = 0; v < pair.first.positions.size(); ++v) {
    const Index w = pair.match.vertex[v];
    const bool stayed = pair.report.processed.positions()[v] == pair.first.positions[v];
    EXPECT_TRUE(stayed || !patch.is_border(v));
    if (stayed) {
      EXPECT_EQ(twin.processed.positions()[w], pair.second.positions[w]);
    } else {
      ++moved;
      const Vec3 move = pair.report.processed.positions()[v] - pair.first.positions[v];
      EXPECT_EQ(twin.processed.positions()[w],
                pair.second.positions[w] + pair.match.motion.of_direction(move));
      EXPECT_LE(norm(twin.processed.positions()[w] -
                     pair.match.motion(pair.report.processed.positions()[v])),
                2e-6);
    }
  }
  EXPECT_GT(moved, 0U);
  EXPECT_EQ(twin.processed.triangles(), pair.second.triangles);
  EXPECT_EQ(twin.input.positions(), pair.second.positions);
}

/// The vertices of an edge of the first one as those of the second.
std::array<Index, 2> edge_beside(const Pair& pair, std::array<Index, 2> edge) {
  const auto [v, w] = std::minmax(pair.match.vertex[edge[0]], pair.match.vertex[edge[1]]);
  return {v, w};
}

TEST(TwinReport, HasTheFiguresOfTheOtherAtItsOwnPlaces) {
  FlattenOptions options = quick();
  options.limits.max = 0.9;
  options.limits.max_stretch = 1e-3;
  const Pair pair = mirrored_pair(options);
  const FlattenReport &theirs = pair.report, twin = pair.twin(options).value();
  EXPECT_EQ(twin.unfold.strain.max, theirs.unfold.strain.max);
  EXPECT_EQ(twin.unfold.strain.worst_edge, edge_beside(pair, theirs.unfold.strain.worst_edge));
  EXPECT_EQ(twin.design_least_stretch.strain.worst_edge,
            edge_beside(pair, theirs.design_least_stretch.strain.worst_edge));
  const auto& own_positions = twin.processed.positions();
  ASSERT_EQ(twin.unfold.limits.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    const LimitCheck &limit = twin.unfold.limits[k], &other = theirs.unfold.limits[k];
    EXPECT_EQ(limit.value, other.value);
    EXPECT_EQ(limit.edge, edge_beside(pair, other.edge));
    const Vec3 middle = 0.5 * (own_positions[limit.edge[0]] + own_positions[limit.edge[1]]);
    EXPECT_LE(norm(limit.at - middle), 2e-6);
  }
  EXPECT_EQ(twin.outcome().missed, theirs.outcome().missed);
  EXPECT_EQ(twin.evolve.after.figures.e_max, theirs.evolve.after.figures.e_max);
  EXPECT_EQ(twin.evolve.deviation.rms, theirs.evolve.deviation.rms);
  EXPECT_EQ(twin.evolve.result.history.size(), theirs.evolve.result.history.size());
  EXPECT_EQ(twin.evolve.result.positions, own_positions);
  EXPECT_EQ(twin.evolve.result.seconds, 0.0);
  EXPECT_EQ(twin.evolve.after.size.area, theirs.evolve.after.size.area);
  EXPECT_EQ(twin.evolve.after.size.extent, measure_size(twin.processed).extent);
  const auto &fold = twin.evolve.fairness.sharpest_fold,
             &other = theirs.evolve.fairness.sharpest_fold;
  ASSERT_TRUE(fold && other);
  EXPECT_EQ(fold->degrees, other->degrees);
  EXPECT_EQ((std::array{fold->from, fold->to}), edge_beside(pair, {other->from, other->to}));
  EXPECT_LE(norm(fold->at - 0.5 * (own_positions[fold->from] + own_positions[fold->to])), 2e-6);
}

TEST(TwinReport, HasOverlapsAndCrossingsAtItsOwnPlaces) {
  Pair pair = mirrored_pair();
  pair.report.unfold.overlap = Overlap{{1.0, 2.0}, {3.0, 5.0}, 4};
  pair.report.unfold.pattern.opened = OpenedCrossings{1, 0.1, 7};
  pair.report.evolve.after.self_intersections = {1, {{{3, 40}, pair.first.positions[7]}}};
  const FlattenReport twin = pair.twin().value();
  EXPECT_EQ(twin.unfold.overlap->low, (Vec2{-3.0, 2.0}));
  EXPECT_EQ(twin.unfold.overlap->high, (Vec2{-1.0, 5.0}));
  EXPECT_EQ(twin.unfold.pattern.opened->vertex, pair.match.vertex[7]);
  const auto& crossing = *twin.evolve.after.self_intersections.first;
  EXPECT_LE(norm(crossing.at - pair.second.positions[pair.match.vertex[7]]), 2e-6);
  const auto sorted = [](Triangle t) {
    std::sort(t.begin(), t.end());
    return t;
  };
  std::vector<Triangle> expected, own;
  for (const Index t : {3, 40}) {
    Triangle corners = pair.first.triangles[t];
    for (Index& v : corners)
      v = pair.match.vertex[v];
    expected.push_back(sorted(corners));
  }
  for (const Index t : crossing.triangles)
    own.push_back(sorted(pair.second.triangles[t]));
  EXPECT_LT(crossing.triangles[0], crossing.triangles[1]);
  EXPECT_TRUE(std::is_permutation(own.begin(), own.end(), expected.begin()));
}

TEST(TwinReport, OfACopyHasThePatternAsItIs) {
  const Pair pair = pair_of(rough(), meshes::renumbered(meshes::turned(rough())));
  const FlattenReport twin = pair.twin().value();
  for (std::size_t v = 0; v < pair.match.vertex.size(); ++v) {
    EXPECT_EQ(twin.unfold.pattern.positions[pair.match.vertex[v]],
              pair.report.unfold.pattern.positions[v]);
  }
  EXPECT_EQ(twin_text(*twin.twin_of), "equal to left");
}

TEST(TwinReport, OfARemeshedPatchHasTheSameVerticesLeft) {
  FlattenOptions options = quick();
  options.remesh = true;
  const TriMesh dense = meshes::rough_grid(90, 80, 5, 0.1, 0.05);
  const Pair pair = pair_of(dense, meshes::renumbered(meshes::mirrored(dense)), options);
  ASSERT_LT(pair.report.input.positions().size(), dense.positions.size());
  const FlattenReport twin = pair.twin(options).value();
  ASSERT_EQ(twin.source.size(), pair.report.source.size());
  EXPECT_TRUE(std::is_sorted(twin.source.begin(), twin.source.end()));
  std::vector<Index> expected;
  for (const Index v : pair.report.source)
    expected.push_back(pair.match.vertex[v]);
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(twin.source, expected);
  for (std::size_t v = 0; v < twin.source.size(); ++v)
    EXPECT_EQ(twin.input.positions()[v], pair.second.positions[twin.source[v]]);
  EXPECT_EQ(twin.unfold.pattern.flipped_triangles, 0U);
  // A vertex that is to stay and did not in the other one.
  std::vector<Index> gone(1);
  while (std::binary_search(expected.begin(), expected.end(), gone[0]))
    ++gone[0];
  options.keep = gone;
  EXPECT_FALSE(pair.twin(options));
  options.keep = {expected[5]};
  EXPECT_TRUE(pair.twin(options));
}

TEST(TwinReport, OfASmoothedPatchIsSmoothedToo) {
  FlattenOptions options = quick();
  options.smooth_first = 3.0;
  const Pair pair = mirrored_pair(options);
  const FlattenReport twin = pair.twin(options).value();
  ASSERT_TRUE(twin.evolve.smoothed_first);
  EXPECT_EQ(twin.evolve.smoothed_first->length, 3.0);
  EXPECT_GT(twin.evolve.smoothed_first->moved.rms, 0.0);
  EXPECT_LE(norm(twin.input.positions()[pair.match.vertex[30]] -
                 pair.match.motion(pair.report.input.positions()[30])),
            2e-6);
}

TEST(MirroredPlace, AddsUpInWholeThousandths) {
  const auto steps = [](double x) { return std::llround(1000.0 * x); };
  meshes::Random random(1);
  for (int k = 0; k < 20'000; ++k) {
    const double place = 500.0 + 480.0 * random.number();
    const double half_way = (std::floor(1000.0 * place) + 0.5) / 1000.0;
    for (const double x : {place, half_way, std::nextafter(half_way, 0.0)}) {
      EXPECT_EQ(steps(x) + steps(mirrored_place(1013.0, x)), 1'013'000);
      EXPECT_NEAR(x + mirrored_place(1013.0, x), 1013.0, 6e-4);
    }
  }
}

std::vector<std::vector<Vec2>> lines_of(const Drawing& sheet, const std::string& name) {
  for (const Layer& layer : sheet.layers) {
    if (layer.name == name && !layer.shapes.empty())
      return std::get<Path>(layer.shapes.front()).lines;
  }
  return {};
}

/// What is written of the places of one line, x of the other one taken from `sum`.
void expect_mirrored(const std::vector<Vec2>& line, const std::vector<Vec2>& other, long long sum) {
  const auto steps = [](double x) { return std::llround(1000.0 * x); };
  ASSERT_EQ(line.size(), other.size());
  for (std::size_t k = 0; k < line.size(); ++k) {
    const Vec2 p = line[k], q = other[(line.size() - k) % line.size()];
    EXPECT_EQ(steps(p.x) + steps(q.x), sum) << k;
    EXPECT_EQ(p.y, q.y) << k;
  }
}

TEST(TwinReport, IsDrawnAsTheMirrorImageOnItsSheet) {
  const Pair pair = mirrored_pair();
  const FlattenReport twin = pair.twin().value();
  PatternOptions options;
  const std::vector<Index> loop = Patch(pair.first).border_loops().front();
  for (const double allowance : {0.0, 0.3}) {
    if (allowance > 0.0) options.allowance = Allowance{.width = allowance};
    options.like.reset();
    options.edge_allowances.clear();
    if (allowance > 0.0) options.edge_allowances = {{loop[2], loop[9], 0.1}};
    const Drawing first = pattern_sheet(pair.report.processed, pair.report.unfold, "left", options);
    options.like = MirrorReference{true, pair.match.vertex[loop[0]]};
    if (allowance > 0.0)  // the patch on its left
      options.edge_allowances = {{pair.match.vertex[loop[9]], pair.match.vertex[loop[2]], 0.1}};
    const Drawing second = pattern_sheet(twin.processed, twin.unfold, "right", options);
    EXPECT_EQ(first.height, second.height);
    for (const char* name : {"cut", "seam"}) {
      const auto theirs = lines_of(first, name), own = lines_of(second, name);
      ASSERT_EQ(theirs.size(), own.size());
      EXPECT_EQ(theirs.empty(), allowance == 0.0 && std::string(name) == "seam");
      for (std::size_t k = 0; k < theirs.size(); ++k) {
        const long long sum = std::llround(1000.0 * (theirs[k][0].x + own[k][0].x));
        EXPECT_EQ(sum % 1000, 0) << "whole millimetres";
        expect_mirrored(theirs[k], own[k], sum);
        EXPECT_GT(signed_area(own[k]), 0.0);
        for (const Vec2 p : own[k]) {
          EXPECT_GE(p.x, 9.99);
          EXPECT_LE(p.x, second.width - 9.99);
        }
      }
    }
  }
}

}  // namespace
}  // namespace planish
