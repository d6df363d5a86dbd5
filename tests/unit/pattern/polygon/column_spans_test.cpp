#include "pattern/polygon/column_spans.h"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "oracle/outline_distance.h"

namespace planish {
namespace {

bool holds(const ColumnSpans& spans, Vec2 p, double step) {
  const auto k = static_cast<std::ptrdiff_t>(std::floor(p.x / step)) - spans.first;
  if (k < 0 || k >= static_cast<std::ptrdiff_t>(spans.columns.size())) return false;
  for (const Span& span : spans.columns[static_cast<std::size_t>(k)]) {
    if (span.low <= p.y && p.y <= span.high) return true;
  }
  return false;
}

/// A ring with deep bays, and a hole in it.
oracle::Loops waved_ring() {
  oracle::Loops loops(2);
  for (int k = 0; k < 90; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / 90;
    const double r = 50.0 + 22.0 * std::sin(5.0 * angle);
    loops[0].push_back({60.0 + r * std::cos(angle), 60.0 + r * std::sin(angle)});
    loops[1].push_back({60.0 + 20.0 * std::cos(angle), 60.0 - 20.0 * std::sin(angle)});
  }
  return loops;
}

TEST(ColumnSpans, HoldEveryPlaceWithinReachAndLittleElse) {
  const oracle::Loops loops = waved_ring();
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-20.0, 140.0);
  for (const double step : {0.37, 3.0, 40.0}) {
    for (const double reach : {0.0, 0.5, 6.0}) {
      const ColumnSpans spans = column_spans(loops, step, reach);
      for (int i = 0; i < 4000; ++i) {
        const Vec2 p = {place(random), place(random)};
        const double distance = oracle::distance_to_outline(p, loops);
        const bool within = oracle::is_inside(p, loops) || distance < reach;
        if (within) {
          EXPECT_TRUE(holds(spans, p, step)) << p.x << " " << p.y;
        } else if (distance > reach + step + 1e-9) {
          // What a column holds too much is beside a place within reach.
          EXPECT_FALSE(holds(spans, p, step)) << p.x << " " << p.y;
        }
      }
    }
  }
}

TEST(ColumnSpans, EndWhereAPieceDoes) {
  const std::vector<Polygon> box = {{{0.0, 0.0}, {6.0, 0.0}, {6.0, 4.0}, {0.0, 4.0}}};
  const ColumnSpans spans = column_spans(box, 2.0, 0.0);
  EXPECT_EQ(spans.first, 0);
  ASSERT_EQ(spans.columns.size(), 3U);
  for (const auto& column : spans.columns) {
    ASSERT_EQ(column.size(), 1U);
    EXPECT_EQ(column[0].low, 0.0);
    EXPECT_EQ(column[0].high, 4.0);
  }
}

TEST(ColumnSpans, CountPartsThatLieTwice) {
  // A strip laid over itself: its loop winds around the middle twice.
  const std::vector<Polygon> strip = {{{0.0, 0.0},
                                       {10.0, 0.0},
                                       {10.0, 10.0},
                                       {4.0, 10.0},
                                       {4.0, 2.0},
                                       {12.0, 2.0},
                                       {12.0, 12.0},
                                       {0.0, 12.0}}};
  const ColumnSpans spans = column_spans(strip, 1.0, 0.0);
  EXPECT_TRUE(holds(spans, {8.0, 6.0}, 1.0));
}

}  // namespace
}  // namespace planish
