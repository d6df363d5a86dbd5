#include <planish/core/error.h>
#include <planish/pattern/marks.h>

#include <gtest/gtest.h>

#include "core/fnv_hash.h"
#include "pattern/pattern_hash.h"

namespace planish {
namespace {

TEST(Marks, AreCrossesAndRingsAboutTheirVertices) {
  const std::vector<Vec2> positions{{0, 0}, {10, 20}};
  const std::vector<Mark> marks{{1, MarkKind::cross}, {1, MarkKind::drill}};
  const auto lines = mark_lines(positions, marks, "");
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[0], (Polygon{{7, 20}, {13, 20}}));
  EXPECT_EQ(lines[1], (Polygon{{10, 17}, {10, 23}}));
  EXPECT_EQ(lines[2].front(), lines[2].back());
  for (const Vec2 p : lines[2])
    EXPECT_NEAR(norm(p - positions[1]), 1.5, 1e-12);
}

TEST(Marks, AreRefusedBeyondTheMesh) {
  const std::vector<Vec2> positions(3);
  EXPECT_THROW(mark_lines(positions, std::vector<Mark>{{3}}, "panel"), Error);
}

TEST(InnerLines, GoFromVertexToVertex) {
  const std::vector<Vec2> positions{{0, 0}, {10, 20}, {5, 5}};
  const auto lines = inner_lines(positions, std::vector<InnerLine>{{2, 0, 1}, {1, 2}}, "panel");
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0], (Polygon{{5, 5}, {0, 0}, {10, 20}}));
  EXPECT_EQ(lines[1], (Polygon{{10, 20}, {5, 5}}));
  EXPECT_THROW(inner_lines(positions, std::vector<InnerLine>{{0, 3}}, "panel"), Error);
}

TEST(PatternHash, IsFnv1aOfMicrometres) {
  EXPECT_EQ(hash_text(pattern_hash({})), "cbf29ce484222325");
  // Sixteen bytes of 0: the offset times the sixteenth power of the prime.
  std::uint64_t zeros = 0xcbf29ce484222325U;
  for (int i = 0; i < 16; ++i)
    zeros *= 0x100000001b3U;
  EXPECT_EQ(pattern_hash(std::vector<Vec2>{{0, 0}}), zeros);
}

TEST(PatternHash, TellsMicrometresApartAndNothingFiner) {
  const std::vector<Vec2> pattern{{1.0, 2.0}, {-3.0, 4.0}};
  const auto moved = [&](double by) {
    std::vector<Vec2> other = pattern;
    other[1].x += by;
    return pattern_hash(other);
  };
  EXPECT_EQ(moved(0.0004), pattern_hash(pattern));
  EXPECT_NE(moved(0.001), pattern_hash(pattern));
  EXPECT_NE(pattern_hash(std::vector<Vec2>{{2.0, 1.0}}),
            pattern_hash(std::vector<Vec2>{{1.0, 2.0}}));
}

}  // namespace
}  // namespace planish
