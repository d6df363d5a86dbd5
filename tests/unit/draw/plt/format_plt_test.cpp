#include <limits>
#include <string>
#include <vector>

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
  EXPECT_THAT(plt, HasSubstr("SP1;\nPU0,0;"));
  EXPECT_THAT(plt, Not(HasSubstr("SP3")));
  EXPECT_TRUE(plt.starts_with("IN;\nSP1;\nPU0,0;"));
}

TEST(WritePlt, BeginsAtTheLowerLeftCornerOfAllLines) {
  Path path = k_triangle;
  for (Vec2& p : path.lines[0])
    p = p + Vec2{-30.01, 70.0};
  EXPECT_EQ(plt_of(path), "IN;\nSP1;\nPU0,0;\nPD400,0,400,200,0,0;\nPU;\nSP0;\n");
}

TEST(WritePlt, CountsFromTheCornerOfWhatDoesNotShowToo) {
  Path far = k_triangle;
  for (Vec2& p : far.lines[0])
    p = p + Vec2{20.0, 30.0};
  const std::string plt =
      format_plt({"t", 99.0, 99.0, {Layer{"label", {k_triangle}, false}, Layer{"cut", {far}}}});
  EXPECT_EQ(plt, "IN;\nSP1;\nPU800,1200;\nPD1200,1200,1200,1400,800,1200;\nPU;\nSP0;\n");
}

TEST(WritePlt, CutsWithTheFirstPenAndTakesEightAtMost) {
  Drawing drawing{"t", 1.0, 1.0, {}};
  for (int k = 0; k < 11; ++k) {
    drawing.layers.push_back({"l" + std::to_string(k), {k_triangle}});
  }
  drawing.layers.push_back({"cut", {k_triangle}});
  const std::string plt = format_plt(drawing);
  std::vector<int> pens;
  for (std::size_t at = plt.find("SP"); at != std::string::npos; at = plt.find("SP", at + 1))
    pens.push_back(std::stoi(plt.substr(at + 2)));
  EXPECT_EQ(pens, (std::vector<int>{2, 3, 4, 5, 6, 7, 8, 1, 0}));
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
  EXPECT_THAT(plt, HasSubstr(",4000,0;\nPD4040,0,"));
  EXPECT_TRUE(plt.ends_with("9960,0;\nPU;\nSP0;\n"));
}

TEST(WritePlt, LeavesOutWhatIsNoLine) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(plt_of(Path{{{{1, 1}}, {{nan, 1}, {2, 2}}, {}}, true, Stroke{}}), "IN;\nPU;\nSP0;\n");
}

}  // namespace
}  // namespace planish
