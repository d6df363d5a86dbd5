#include "flatten/twin_report.h"

#include <algorithm>
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

TEST(TwinReport, HasTheCautionsOfItsOwnNumbers) {
  const auto far = [](TriMesh mesh) {
    for (Vec3& p : mesh.positions)
      p += {4e6, 0.0, 0.0};
    return meshes::in_floats(std::move(mesh));
  };
  Pair pair = mirrored_pair();
  const auto has_coarse = [](const FlattenReport& report) {
    return std::any_of(report.cautions.begin(), report.cautions.end(), [](const Caution& caution) {
      return std::holds_alternative<CoarseCoordinates>(caution);
    });
  };
  EXPECT_FALSE(has_coarse(pair.twin().value()));
  EXPECT_EQ(pair.twin()->cautions.size(), pair.report.cautions.size());
  pair.report.cautions.emplace_back(CoarseCoordinates{1.0, 2.0});
  EXPECT_FALSE(has_coarse(pair.twin().value())) << "the first lies far from the origin, not this";
  pair.report.cautions.pop_back();
  pair.second = far(pair.second);
  const auto twin = pair.twin();
  ASSERT_TRUE(twin);
  EXPECT_TRUE(has_coarse(*twin));
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

TEST(TwinReport, HasFiguresOfItsOwn) {
  const Pair pair = mirrored_pair();
  const FlattenReport twin = pair.twin().value();
  const EdgeStrain strain = edge_strain(twin.processed, twin.unfold.pattern.positions);
  EXPECT_EQ(twin.unfold.strain.max, strain.max);
  EXPECT_EQ(twin.unfold.strain.worst_edge, strain.worst_edge);
  EXPECT_NE(twin.unfold.strain.max, pair.report.unfold.strain.max);
  EXPECT_NEAR(twin.unfold.strain.max, pair.report.unfold.strain.max, 1e-5);
  EXPECT_NEAR(twin.unfold_before.strain.rms, pair.report.unfold_before.strain.rms, 1e-5);
  EXPECT_EQ(twin.evolve.after.figures.e_max, measure_patch(twin.processed).figures.e_max);
  EXPECT_NEAR(twin.evolve.deviation.rms, pair.report.evolve.deviation.rms, 1e-5);
  EXPECT_EQ(twin.evolve.result.history.size(), pair.report.evolve.result.history.size());
  EXPECT_EQ(twin.evolve.result.stop, pair.report.evolve.result.stop);
  EXPECT_EQ(twin.evolve.result.seconds, 0.0);
  const Fairness fairness = measure_fairness(twin.input, twin.processed.positions());
  ASSERT_TRUE(fairness.bending_ratio);
  EXPECT_EQ(twin.evolve.fairness.bending_ratio, fairness.bending_ratio);
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
  EXPECT_NEAR(twin.unfold.strain.rms, pair.report.unfold.strain.rms, 1e-12);
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
  EXPECT_NEAR(twin.evolve.smoothed_first->moved.rms, pair.report.evolve.smoothed_first->moved.rms,
              1e-5);
  EXPECT_NEAR(twin.evolve.deviation.rms, pair.report.evolve.deviation.rms, 1e-5);
  EXPECT_NEAR(twin.unfold.strain.rms, pair.report.unfold.strain.rms, 1e-5);
}

TriMesh scaled(TriMesh mesh, double scale) {
  for (Vec3& p : mesh.positions)
    p = scale * p;
  return mesh;
}

TEST(TwinReport, IsRefusedWhereALimitWouldBeMissed) {
  FlattenOptions options = quick();
  options.limits.max = 0.9;
  std::size_t rounded = 0;
  for (const double scale : {1.0 - 5e-6, 1.0 + 5e-6}) {
    Pair pair = pair_of(rough(), scaled(meshes::mirrored(rough()), scale), options);
    EXPECT_TRUE(pair.twin(options));
    ASSERT_EQ(pair.report.unfold.limits.size(), 1U);
    // To the last bit, which one of the two misses: by rounding, which is no stretch.
    StrainLimitCheck& limit = pair.report.unfold.limits[0];
    limit.asked = limit.reached;
    const FlattenReport twin = pair.twin(options).value();
    EXPECT_TRUE(twin.unfold.limits[0].kept());
    rounded += twin.unfold.strain.max > limit.asked ? 1 : 0;
    limit.asked = limit.reached = 0.98 * limit.reached;
    EXPECT_FALSE(pair.twin(options)) << "by more than that";
  }
  EXPECT_EQ(rounded, 1U);
}

TEST(TwinReport, IsRefusedWhereSeamsWouldNotMatch) {
  FlattenOptions options = quick();
  options.match_seams = true;
  // In each of them the border is longer by this share.
  const Pair close = pair_of(rough(), scaled(meshes::mirrored(rough()), 1.0 + 8e-6), options);
  EXPECT_TRUE(close.twin(options));
  const Pair far = pair_of(rough(), scaled(meshes::mirrored(rough()), 1.0 + 1.2e-5), options);
  EXPECT_FALSE(far.twin(options));
  EXPECT_TRUE(far.twin(quick()));
}

TEST(TwinReport, IsRefusedWhereTheTargetWouldBeMissed) {
  std::size_t refused = 0;
  for (const double scale : {1.0, 2.0}) {
    Pair pair = mirrored_pair();
    const double e_max = pair.twin().value().evolve.after.figures.e_max;
    const double theirs = pair.report.evolve.after.figures.e_max;
    ASSERT_GT(std::abs(e_max - theirs), 1e-8 * theirs);
    // A target that the twin meets, at first exactly.
    pair.report.evolve.stopping.target_e_max = scale * theirs;
    EXPECT_EQ(pair.twin().has_value(), e_max <= scale * theirs);
    refused += pair.twin() ? 0 : 1;
    pair.report.evolve.stopping.target_e_max = 0.5 * std::min(e_max, theirs);
    EXPECT_TRUE(pair.twin()) << "neither of them meets it";
  }
  EXPECT_LE(refused, 1U);
}

TEST(TwinReport, KeepsALimitOfDeviation) {
  FlattenOptions options;
  options.method = ControllableLaplacian{.max_deviation = 0.01};
  const Pair pair = mirrored_pair(options);
  ASSERT_NEAR(pair.report.evolve.deviation.max, 0.01, 1e-12) << "the limit holds vertices back";
  ASSERT_TRUE(pair.twin(options));
  EXPECT_NEAR(pair.twin(options)->evolve.deviation.max, 0.01, 1e-12);
}

TEST(BorderMismatch, IsOfTheStretchThatDiffersMost) {
  const TriMesh square = meshes::flat_grid(2, 2);
  const Patch patch(square);
  std::vector<Vec2> pattern;
  for (const Vec3 p : square.positions)
    pattern.push_back({p.x, p.y});
  EXPECT_EQ(border_mismatch(patch, pattern), 0.0);
  pattern[1].x += 0.25;  // one edge of the border longer, the next shorter
  EXPECT_NEAR(border_mismatch(patch, pattern), 0.25, 1e-15);
  for (Vec2& p : pattern)
    p = 2.0 * p;
  EXPECT_NEAR(border_mismatch(patch, pattern), 8.0, 1e-15);
}

TEST(BorderMismatch, IsOfNoStretchWithAFreeEdge) {
  const TriMesh square = meshes::flat_grid(3, 3);  // vertices 0 to 3 along one side
  const Patch patch(square);
  std::vector<Vec2> pattern;
  for (const Vec3 p : square.positions)
    pattern.push_back({p.x, p.y});
  pattern[1].x += 0.25;
  const std::vector<std::array<Index, 2>> both = {{1, 0}, {1, 2}}, one = {{0, 1}};
  EXPECT_EQ(border_mismatch(patch, pattern, both), 0.0);
  EXPECT_NEAR(border_mismatch(patch, pattern, one), 0.25, 1e-15) << "the next one is shorter";
  pattern[2].x += 0.25;
  const std::vector<std::array<Index, 2>> between = {{2, 1}};
  EXPECT_NEAR(border_mismatch(patch, pattern, between), 0.25, 1e-15)
      << "one is longer, one shorter, and a free one between them";
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
    options.like = DrawnLike{true, pair.match.vertex[loop[0]]};
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
