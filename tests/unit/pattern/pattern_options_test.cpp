#include <planish/core/error.h>
#include <planish/pattern/pattern_options.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace planish {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

PatternOptions options() {
  PatternOptions options;
  options.notches = {Notch::at_vertex(20, NotchKind::v), Notch::at_fraction(0.5),
                     Notch::on_edge(30, 20, 0.25)};
  options.marks = {{25, MarkKind::drill}};
  options.inner_lines = {{24, 3}};
  options.edge_allowances = {{41, 3, 5.0}};
  return options;
}

TEST(PatternOptions, NameVerticesByNotchesAndMarks) {
  EXPECT_THAT(named_vertices(options()), ElementsAre(20, 30, 20, 25, 24, 3, 41, 3));
  EXPECT_TRUE(named_vertices({}).empty());
}

TEST(PatternOptions, GoOverToAMeshOfSomeOfTheVertices) {
  const std::vector<Index> source = {3, 20, 24, 25, 30, 41};
  const PatternOptions left = renumbered(options(), source);
  EXPECT_THAT(named_vertices(left), ElementsAre(1, 4, 1, 3, 2, 0, 5, 0));
  EXPECT_EQ(left.notches[1].fraction, 0.5);
  EXPECT_EQ(left.notches[2].fraction, 0.25);
  EXPECT_EQ(left.marks[0].kind, MarkKind::drill);
}

std::string error_of(const PatternOptions& options, ErrorCode code) {
  const std::vector<std::vector<Index>> border = {{1, 20, 30, 40}, {5, 6, 7}};
  try {
    check_pattern_options(options, 50, border, "panel");
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code);
    return error.what();
  }
  return "no error";
}

TEST(PatternOptions, AreCheckedBeforeThereIsAPattern) {
  constexpr ErrorCode off = ErrorCode::misplaced_notch;
  PatternOptions good = options();
  good.edge_allowances.front() = {40, 1, 5.0};
  EXPECT_EQ(error_of(good, off), "no error");
  EXPECT_THAT(error_of({.notches = {Notch::at_vertex(2)}}, off), HasSubstr("vertex 2"));
  EXPECT_THAT(error_of({.notches = {Notch::at_vertex(2)}}, off), HasSubstr("panel"));
  EXPECT_THAT(error_of({.notches = {Notch::at_fraction(1.5)}}, off), HasSubstr("1.5"));
  EXPECT_THAT(error_of({.notches = {Notch::on_edge(1, 30, 0.5)}}, off),
              HasSubstr("vertex 1 to 30"));
  EXPECT_THAT(error_of({.notches = {Notch::on_edge(7, 5, 0.5)}}, off), "no error");
  EXPECT_THAT(error_of({.edge_allowances = {{1, 2, 5.0}}}, ErrorCode::misplaced_allowance),
              HasSubstr("from vertex 1 to 2"));
  EXPECT_THAT(error_of({.edge_allowances = {{1, 6, 5.0}}}, ErrorCode::misplaced_allowance),
              HasSubstr("one border"));
  EXPECT_EQ(error_of({.edge_allowances = {{30, 1, 5.0}}}, off), "no error");
  PatternOptions marks = {.marks = {{50, MarkKind::cross}}};
  marks.label.name = "collar";
  EXPECT_THAT(error_of(marks, ErrorCode::index_out_of_range), HasSubstr("collar"));
}

TEST(PatternOptions, OfAMirrorImageHaveTheAngleOfTheGrainMirrored) {
  PatternOptions options;
  options.grain = 30.0;
  options.label.name = "left";
  EXPECT_EQ(for_mirror_image(options).grain, Grain(150.0));
  EXPECT_EQ(for_mirror_image(options).label.name, "left");
  options.grain = Vec3{0.0, 0.0, 1.0};
  EXPECT_EQ(for_mirror_image(options).grain, options.grain);
  options.like = MirrorReference{true, 4};
  const std::vector<Index> source = {1, 4, 6};
  EXPECT_EQ(renumbered(options, source).like->start, 1U);
}

TEST(PatternOptions, LeavesOutNumbersOfSeamsWhoseVerticesAreGone) {
  PatternOptions options;
  options.seam_numbers = {{1, 20}, {2, 21}, {3, 30}};
  EXPECT_TRUE(named_vertices(options).empty()) << "a coarser mesh need not keep them";
  const std::vector<Index> source = {10, 20, 30};
  const auto left = renumbered(options, source).seam_numbers;
  ASSERT_EQ(left.size(), 2U);
  EXPECT_EQ(left[0].number, 1);
  EXPECT_EQ(left[0].vertex, 1U);
  EXPECT_EQ(left[1].number, 3);
  EXPECT_EQ(left[1].vertex, 2U);
}

}  // namespace
}  // namespace planish
