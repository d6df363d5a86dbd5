#include <algorithm>
#include <cmath>

#include <planish/core/error.h>
#include <planish/pattern/pattern_options.h>
#include <planish/pattern/read_annotations.h>

#include <gmock/gmock.h>

#include "support/meshes.h"

namespace planish {
namespace {

using testing::HasSubstr;

const Patch& hill() {
  static const Patch patch(meshes::height_field(
      6, 4, [](double x, double y) { return 0.05 * (x * x + 2.0 * y * y - x * y); }));
  return patch;
}

/// Straight down onto the pattern: places of the hill lie at their x and y.
std::vector<Vec2> from_above() {
  std::vector<Vec2> positions;
  for (const Vec3 p : hill().positions())
    positions.push_back({p.x, p.y});
  return positions;
}

template <class Parse>
void expect_error(Parse parse, const std::string& bytes, ErrorCode code, std::size_t line,
                  const std::string& text) {
  try {
    parse(bytes, hill(), "drawn.obj");
    ADD_FAILURE() << bytes;
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code) << error.what();
    EXPECT_EQ(error.place().path, "drawn.obj");
    EXPECT_EQ(error.place().line, line);
    EXPECT_THAT(error.message(), HasSubstr(text));
  }
}

TEST(DrawnMarks, StandWhereTheyAreDrawn) {
  // On a vertex, inside a triangle, and above one; the last is a point of two lines.
  const Vec3 v = hill().positions()[9];
  const Vec3 p =
      (1.0 / 3.0) * (hill().positions()[0] + hill().positions()[1] + hill().positions()[8]);
  const auto text = [](Vec3 q) {
    return "v " + std::to_string(q.x) + " " + std::to_string(q.y) + " " + std::to_string(q.z) +
           "\n";
  };
  const auto drawn = parse_drawn_marks(
      text(v) + text(p) + text(p + Vec3{0, 0, 0.2}) + "p 1 2\nl 3 1\nl 3 2\n", hill(), "m.obj");
  ASSERT_EQ(drawn.marks.size(), 3U);
  EXPECT_EQ(drawn.marks[0].vertex, 9U);
  const auto lines = mark_lines(from_above(), drawn.marks, "hill");
  ASSERT_EQ(lines.size(), 6U);
  const auto middle = [&](std::size_t k) { return 0.5 * (lines[2 * k][0] + lines[2 * k][1]); };
  EXPECT_LT(norm(middle(0) - Vec2{v.x, v.y}), 1e-5);
  EXPECT_LT(norm(middle(1) - Vec2{p.x, p.y}), 1e-5);
  EXPECT_LT(norm(middle(2) - Vec2{p.x, p.y}), 0.1);
  EXPECT_GT(drawn.farthest, 0.15);
  EXPECT_LE(drawn.farthest, 0.2);
}

TEST(DrawnNotches, StandOnTheNearestEdgeOfTheBorder) {
  const auto drawn = parse_drawn_notches("v 2.25 -0.3 0.3\nv 6 3 2\np 1\np 2\n", hill(), "n.obj");
  ASSERT_EQ(drawn.notches.size(), 2U);
  EXPECT_EQ(drawn.notches[0].edge, (std::array<Index, 2>{2, 3}));
  EXPECT_NEAR(drawn.notches[0].fraction, 0.25, 0.02);
  const Notch& corner = drawn.notches[1];
  EXPECT_EQ(corner.edge->at(corner.fraction > 0.5 ? 1 : 0), 27U);
  EXPECT_NO_THROW(check_notches(hill().border_loops(), drawn.notches, "hill"));
}

TEST(DrawnLinesOfPieces, CrossTheEdgesWhereTheyAreDrawn) {
  const auto drawn = parse_drawn_lines("v 0.3 0.7 0\nv 5.4 2.9 1.4\nl 1 2\n", hill(), "l.obj");
  ASSERT_EQ(drawn.lines.size(), 1U);
  EXPECT_EQ(drawn.outside_length, 0.0);
  const auto lines = inner_lines(from_above(), drawn.lines, "hill");
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_GT(lines[0].size(), 8U);
  for (const Vec2 p : lines[0]) {
    EXPECT_LT(std::abs(cross(p - lines[0].front(), lines[0].back() - lines[0].front())), 0.5);
  }
  // Half of it beyond the border.
  const auto half = parse_drawn_lines("v 3 0.5 0.3\nv 3 -0.5 0.4\nl 1 2\n", hill(), "l.obj");
  ASSERT_EQ(half.lines.size(), 1U);
  EXPECT_NEAR(half.outside_length, 0.5, 0.1);
}

TEST(DrawnAnnotationsOfPieces, AreRefusedFarFromThePatch) {
  const std::string far = "v 1 1 0\nv 1 1 9\n\nl 1 2\n";
  expect_error(parse_drawn_marks, far, ErrorCode::misplaced_mark, 4, "(1, 1, 9)");
  expect_error(parse_drawn_lines, far, ErrorCode::misplaced_mark, 4, "from the mesh");
  expect_error(parse_drawn_notches, far, ErrorCode::misplaced_notch, 4, "from the border");
  expect_error(parse_drawn_lines, "v 1 1 0\np 1\n", ErrorCode::malformed_file, 1, "no line");
  expect_error(parse_drawn_marks, "v 1 1 0\n", ErrorCode::malformed_file, 1, "draws nothing");
}

TEST(DrawnAnnotationsOfPieces, AreRenumberedAndKept) {
  PatternOptions options;
  options.marks = parse_drawn_marks("v 2.3 1.6 0.4\np 1\n", hill(), "m.obj").marks;
  options.drawn_lines =
      parse_drawn_lines("v 2.3 1.6 0.4\nv 2.4 1.6 0.4\nl 1 2\n", hill(), "l.obj").lines;
  const std::vector<Index> named = named_vertices(options);
  for (const Index v : {9U, 16U, 17U})
    EXPECT_NE(std::find(named.begin(), named.end(), v), named.end()) << v;
  std::vector<Index> source;
  for (Index v = 9; v < 30; ++v)
    source.push_back(v);
  const PatternOptions other = renumbered(options, source);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(other.marks[0].place->corners[k], options.marks[0].place->corners[k] - 9);
    EXPECT_EQ(other.drawn_lines[0][0].corners[k], options.drawn_lines[0][0].corners[k] - 9);
  }
  EXPECT_THROW(check_pattern_options(options, 16, hill().border_loops(), "hill"), Error);
}

}  // namespace
}  // namespace planish
