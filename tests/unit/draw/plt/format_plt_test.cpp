#include <limits>
#include <string>

#include <planish/draw/format_drawing.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace planish {
namespace {

using testing::HasSubstr;
using testing::Not;

const Path k_triangle{{{{0, 0}, {10, 0}, {10, 5.0124}}}, true, Stroke{}};

std::string plt_of(Path path) {
  return format_plt({"t", 100.0, 100.0, {Layer{"cut", {std::move(path)}}}});
}

TEST(WritePlt, CountsFortyUnitsAMillimetreAndClosesWhatIsClosed) {
  EXPECT_EQ(plt_of(k_triangle), "IN;\nSP1;\nPU0,0;\nPD400,0,400,200,0,0;\nPU;\nSP0;\n");
  Path open = k_triangle;
  open.closed = false;
  EXPECT_THAT(plt_of(open), HasSubstr("PD400,0,400,200;\n"));
}

TEST(WritePlt, GivesEachLayerWithLinesAPen) {
  Path area = k_triangle;
  area.stroke.reset();
  area.fill = Color{};
  const std::string plt = format_plt(
      {"t",
       1.0,
       1.0,
       {Layer{"strain", {area}}, Layer{"cut", {k_triangle}}, Layer{"hidden", {k_triangle}, false},
        Layer{"label", {Text{{1.0, 2.0}, 8.0, "L"}}}}});
  EXPECT_THAT(plt, HasSubstr("SP2;\nPU40,400;\nPD40,80,240,80;\n")) << "an L of strokes";
  EXPECT_THAT(plt, Not(HasSubstr("SP3")));
  EXPECT_TRUE(plt.starts_with("IN;\nSP1;\nPU0,0;"));
}

TEST(WritePlt, BreaksLongLinesIntoInstructionsThatGoOn) {
  Path path{{{}}, false, Stroke{}};
  for (int i = 0; i < 250; ++i)
    path.lines[0].push_back({static_cast<double>(i), 1.0});
  const std::string plt = plt_of(path);
  std::size_t instructions = 0;
  for (std::size_t at = plt.find("PD"); at != std::string::npos; at = plt.find("PD", at + 1))
    ++instructions;
  EXPECT_EQ(instructions, 3U);
  EXPECT_THAT(plt, HasSubstr(",4000,40;\nPD4040,40,"));
  EXPECT_TRUE(plt.ends_with("9960,40;\nPU;\nSP0;\n"));
}

TEST(WritePlt, LeavesOutWhatIsNoLine) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(plt_of(Path{{{{1, 1}}, {{nan, 1}, {2, 2}}, {}}, true, Stroke{}}), "IN;\nPU;\nSP0;\n");
}

}  // namespace
}  // namespace planish
