#include <cmath>
#include <numbers>
#include <vector>

#include <planish/pattern/nest.h>

#include <gtest/gtest.h>

#include "oracle/outline_gap.h"
#include "property/property.h"

namespace planish {
namespace {

/// A star of spikes: its bays are what pieces may wrongly be pushed into.
NestPiece random_piece() {
  const auto radii =
      *rc::gen::resize(100, rc::gen::container<std::vector<int>>(30, rc::gen::inRange(10, 100)));
  const auto count = static_cast<std::size_t>(*rc::gen::inRange(3, 30));
  NestPiece piece{{"random", {{}}}, *rc::gen::inRange(1, 4), 0.1 * *rc::gen::inRange(0, 3600)};
  for (std::size_t k = 0; k < count; ++k) {
    const double angle =
        2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(count);
    piece.outline.loops[0].push_back({radii[k] * std::cos(angle), radii[k] * std::sin(angle)});
  }
  return piece;
}

PLANISH_PROPERTY(NestProperty, NoTwoPiecesAreNearerThanTheGap, 100) {
  std::vector<NestPiece> pieces;
  std::size_t copies = 0;
  for (int p = *rc::gen::inRange(1, 6); p > 0; --p) {
    pieces.push_back(random_piece());
    copies += static_cast<std::size_t>(pieces.back().quantity);
  }
  NestOptions options{.width = 202.0 + *rc::gen::inRange(0, 300), .tries = 2};
  options.gap = 0.5 * *rc::gen::inRange(0, 40);
  options.margin = 0.5 * *rc::gen::inRange(0, 3);
  options.step = 0.25 * *rc::gen::inRange(0, 80);
  options.turns = *rc::gen::element(Turns::none, Turns::half, Turns::quarter, Turns::free);
  if (*rc::gen::inRange(0, 2) == 1) options.length = 210.0 + *rc::gen::inRange(0, 300);
  const Nesting nesting = nest(pieces, options);
  RC_ASSERT(nesting.placements.size() == copies);
  std::vector<oracle::Loops> loops;
  for (const NestPlacement& placement : nesting.placements) {
    loops.push_back(pieces[placement.piece].outline.loops);
    for (Vec2& p : loops.back()[0])
      p = placement(p);
    const oracle::OutlineBox box = oracle::outline_box(loops.back());
    const double m = options.margin - 1e-6;
    RC_ASSERT(box.low.x >= m && box.low.y >= m && box.high.y <= options.width - m);
    RC_ASSERT(!options.length || box.high.x <= *options.length - m);
    for (std::size_t j = 0; j + 1 < loops.size(); ++j) {
      if (nesting.placements[j].sheet != placement.sheet) continue;
      RC_ASSERT(oracle::gap_between(loops.back(), loops[j], options.gap + 1.0) >=
                options.gap - 1e-6);
    }
  }
}

}  // namespace
}  // namespace planish
