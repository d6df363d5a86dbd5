#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <random>
#include <set>
#include <utility>

#include <planish/core/error.h>
#include <planish/pattern/nest.h>

#include <gmock/gmock.h>

#include "oracle/outline_gap.h"
#include "support/watched_job.h"

namespace planish {
namespace {

using testing::HasSubstr;

NestPiece nest_piece(const std::string& name, std::vector<Polygon> loops, int quantity = 1) {
  return {{name, std::move(loops)}, quantity};
}

NestPiece box_piece(const std::string& name, double length, double width, int quantity = 1) {
  return nest_piece(name, {{{0.0, 0.0}, {length, 0.0}, {length, width}, {0.0, width}}}, quantity);
}

/// Ragged rings, some of them deeply waved, off the origin, some with a hole.
std::vector<NestPiece> ragged_pieces(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  std::vector<NestPiece> pieces;
  for (std::size_t i = 0; i < count; ++i) {
    const double radius = 20.0 + 100.0 * share(random), flat = 0.3 + share(random);
    const double depth = 0.6 * share(random), phase = 7.0 * share(random);
    const int corners = 5 + static_cast<int>(120.0 * share(random));
    const Vec2 middle = {500.0 * share(random), -300.0 * share(random)};
    Polygon ring, hole;
    for (int k = 0; k < corners; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / corners;
      const double r =
          radius * (1.0 + depth * std::sin(3.0 * angle + phase) + 0.05 * share(random));
      ring.push_back(middle + Vec2{flat * r * std::cos(angle), r * std::sin(angle)});
      hole.push_back(middle + Vec2{0.3 * flat * r * std::cos(angle), -0.3 * r * std::sin(angle)});
    }
    std::vector<Polygon> loops = {ring};
    if (i % 4 == 0) loops.push_back(hole);
    pieces.push_back(nest_piece("ragged " + std::to_string(i), loops, 1 + static_cast<int>(i) % 3));
    pieces.back().angle = 360.0 * share(random);
  }
  return pieces;
}

oracle::Loops placed_loops(const NestPiece& piece, const NestPlacement& placement) {
  oracle::Loops loops = piece.outline.loops;
  for (auto& loop : loops) {
    for (Vec2& p : loop)
      p = placement(p);
  }
  return loops;
}

void expect_all_laid(const std::vector<NestPiece>& pieces, const Nesting& nesting) {
  std::set<std::pair<std::size_t, int>> copies;
  for (const NestPlacement& placement : nesting.placements)
    EXPECT_TRUE(copies.insert({placement.piece, placement.copy}).second);
  std::size_t wanted = 0;
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    for (int copy = 0; copy < pieces[p].quantity; ++copy, ++wanted)
      EXPECT_TRUE(copies.contains({p, copy})) << p << " " << copy;
  }
  EXPECT_EQ(copies.size(), wanted);
}

/// All that nest() promises, measured on the outlines themselves.
void expect_sound(const std::vector<NestPiece>& pieces, const NestOptions& options,
                  const Nesting& nesting) {
  expect_all_laid(pieces, nesting);
  std::vector<oracle::Loops> loops;
  double farthest = 0.0;
  const double m = options.margin - 1e-6;
  for (const NestPlacement& placement : nesting.placements) {
    loops.push_back(placed_loops(pieces[placement.piece], placement));
    const oracle::OutlineBox box = oracle::outline_box(loops.back());
    EXPECT_GE(box.low.x, m);
    EXPECT_GE(box.low.y, m);
    EXPECT_LE(box.high.y, options.width - m);
    EXPECT_LT(placement.sheet, nesting.sheets);
    if (options.length) {
      EXPECT_LE(box.high.x, *options.length - m);
    }
    if (placement.sheet + 1 == nesting.sheets) farthest = std::max(farthest, box.high.x);
  }
  EXPECT_NEAR(nesting.used_length, farthest + options.margin, 1e-6);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (nesting.placements[i].sheet != nesting.placements[j].sheet) continue;
      EXPECT_GE(oracle::gap_between(loops[i], loops[j], options.gap + 1.0), options.gap - 1e-6)
          << i << " " << j;
    }
  }
}

TEST(Nest, LaysHalvesOnTheFoldOfTheCloth) {
  std::vector<NestPiece> pieces = ragged_pieces(6, 5);
  // Its fold is the side at x = 40, from the bottom up; the piece is left of it.
  pieces.push_back(box_piece("half", 40.0, 120.0, 2));
  pieces.back().fold = -90.0;
  pieces.back().angle = 10.0;
  const NestOptions options{.width = 400.0, .gap = 6.0, .margin = 15.0, .folded = true};
  const Nesting nesting = nest(pieces, options);
  expect_all_laid(pieces, nesting);
  double lowest_of_others = options.width;
  for (const NestPlacement& placement : nesting.placements) {
    const NestPiece& piece = pieces[placement.piece];
    const oracle::OutlineBox box = oracle::outline_box(placed_loops(piece, placement));
    EXPECT_LE(box.high.y, options.width - options.margin + 1e-6);
    EXPECT_GE(box.low.x, options.margin - 1e-6);
    if (!piece.fold) {
      lowest_of_others = std::min(lowest_of_others, box.low.y);
      continue;
    }
    const Vec2 from = placement({40.0, 0.0}), to = placement({40.0, 120.0});
    EXPECT_NEAR(from.y, 0.0, 1e-9);
    EXPECT_NEAR(to.y, 0.0, 1e-9);
    EXPECT_NEAR(to.x - from.x, 120.0, 1e-9);
    EXPECT_NEAR(box.high.y, 40.0, 1e-9) << "the piece is above its fold";
  }
  EXPECT_NEAR(lowest_of_others, options.gap, 1e-6) << "beside the fold the gap, and no margin";
}

TEST(Nest, RefusesAHalfThatIsWiderThanTheFoldedCloth) {
  NestPiece half = box_piece("half", 40.0, 120.0);
  half.fold = -90.0;
  EXPECT_EQ(nest({&half, 1}, {.width = 41.0, .folded = true}).placements.size(), 1U);
  EXPECT_THROW(nest({&half, 1}, {.width = 39.0, .folded = true, .turns = Turns::free}), Error);
}

TEST(Nest, KeepsPiecesApartAndOnTheSheetInAnyTurns) {
  for (const Turns turns : {Turns::none, Turns::half, Turns::quarter, Turns::free}) {
    for (const double gap : {0.0, 0.7, 12.0}) {
      const auto pieces = ragged_pieces(9, 3 * static_cast<unsigned>(turns) + 1);
      NestOptions options{.width = 500.0, .gap = gap, .margin = gap, .turns = turns, .tries = 5};
      options.in_holes = gap > 0.0;
      expect_sound(pieces, options, nest(pieces, options));
      options.length = 420.0;
      options.step = 7.0;
      const Nesting several = nest(pieces, options);
      EXPECT_GT(several.sheets, 1U);
      expect_sound(pieces, options, several);
    }
  }
}

TEST(Nest, TurnsPiecesOnlyAsTheyMayBe) {
  const auto pieces = ragged_pieces(10, 5);
  const auto turned_by = [&](Turns turns) {
    std::set<double> angles;
    const NestOptions options{.width = 500.0, .turns = turns, .tries = 4};
    const auto nesting = nest(pieces, options);
    for (const NestPlacement& placement : nesting.placements) {
      const double turn = placement.angle - pieces[placement.piece].angle;
      angles.insert(std::round(1e6 * (turn < -1e-6 ? turn + 360.0 : turn)) / 1e6);
      EXPECT_GE(placement.angle, 0.0);
      EXPECT_LT(placement.angle, 360.0);
    }
    return angles;
  };
  EXPECT_THAT(turned_by(Turns::none), testing::ElementsAre(0.0));
  EXPECT_THAT(turned_by(Turns::half), testing::ElementsAre(0.0, 180.0));
  EXPECT_THAT(turned_by(Turns::quarter), testing::IsSubsetOf({0.0, 90.0, 180.0, 270.0}));
  for (const double angle : turned_by(Turns::free))
    EXPECT_NEAR(std::remainder(angle, 15.0), 0.0, 1e-6);
}

TEST(Nest, WastesNothingOnBoxesThatFit) {
  const std::vector<NestPiece> pieces = {box_piece("box", 200.0, 100.0, 12)};
  const Nesting nesting = nest(pieces, {.width = 300.0, .gap = 0.0, .step = 2.0});
  EXPECT_NEAR(nesting.used_length, 800.0, 1e-6);
  EXPECT_NEAR(nesting.used_share(), 1.0, 1e-8);
  // With gaps each box takes no more than its own, the gap and a step.
  const Nesting apart = nest(pieces, {.width = 310.0, .gap = 5.0, .step = 2.0});
  EXPECT_LE(apart.used_length, 4 * (200.0 + 5.0 + 2.0));
  expect_sound(pieces, {.width = 310.0, .gap = 5.0}, apart);
  const Nesting turned = nest(std::vector<NestPiece>{box_piece("box", 100.0, 300.0, 3)},
                              {.width = 100.0, .gap = 0.0, .turns = Turns::quarter});
  EXPECT_NEAR(turned.used_length, 900.0, 6.0);
}

TEST(Nest, FillsHolesOfOtherPiecesWhereAsked) {
  const std::vector<NestPiece> pieces = {
      nest_piece("frame", {{{0.0, 0.0}, {300.0, 0.0}, {300.0, 300.0}, {0.0, 300.0}},
                           {{50.0, 50.0}, {50.0, 250.0}, {250.0, 250.0}, {250.0, 50.0}}}),
      box_piece("inside", 180.0, 90.0, 2)};
  const Nesting beside = nest(pieces, {.width = 300.0, .gap = 5.0});
  EXPECT_GE(beside.used_length, 300.0 + 5.0 + 180.0);
  const NestOptions options{.width = 300.0, .gap = 5.0, .in_holes = true};
  const Nesting nesting = nest(pieces, options);
  EXPECT_NEAR(nesting.used_length, 300.0, 1e-6);
  EXPECT_NEAR(beside.piece_area, nesting.piece_area, 1e-6);
  EXPECT_NEAR(nesting.piece_area, 300.0 * 300.0 - 200.0 * 200.0 + 2 * 180.0 * 90.0, 1e-6);
  expect_sound(pieces, options, nesting);
}

TEST(Nest, TurnsTheGrainAlongTheSheet) {
  NestPiece piece = box_piece("strap", 30.0, 400.0);
  piece.angle = -90.0;
  const Nesting nesting =
      nest(std::vector<NestPiece>{piece}, {.width = 100.0, .turns = Turns::none});
  EXPECT_EQ(nesting.placements.at(0).angle, 270.0);
  EXPECT_NEAR(nesting.used_length, 400.0, 1e-9);
}

TEST(Nest, UsesSeveralSheetsWherePiecesHaveAnEnd) {
  const std::vector<NestPiece> pieces = {box_piece("plate", 400.0, 300.0, 5)};
  const NestOptions options{.width = 620.0, .length = 500.0, .gap = 10.0, .margin = 5.0};
  const Nesting nesting = nest(pieces, options);
  EXPECT_EQ(nesting.sheets, 3U);
  EXPECT_NEAR(nesting.used_length, 410.0, 1e-6);
  EXPECT_NEAR(nesting.sheet_area, 620.0 * (2 * 500.0 + 410.0), 1e-3);
  expect_sound(pieces, options, nesting);
}

TEST(Nest, GivesTheSameResultEveryTime) {
  const auto pieces = ragged_pieces(8, 9);
  const NestOptions options{.width = 600.0, .turns = Turns::free, .tries = 8};
  const Nesting first = nest(pieces, options), second = nest(pieces, options);
  ASSERT_EQ(first.placements.size(), second.placements.size());
  for (std::size_t i = 0; i < first.placements.size(); ++i) {
    EXPECT_EQ(first.placements[i].shift, second.placements[i].shift);
    EXPECT_EQ(first.placements[i].angle, second.placements[i].angle);
  }
}

TEST(Nest, NeedsNoMoreWithMoreTries) {
  const auto pieces = ragged_pieces(12, 4);
  double last = 1e9;
  for (const int tries : {1, 4, 30}) {
    const double used = nest(pieces, {.width = 500.0, .tries = tries}).used_length;
    EXPECT_LE(used, last);
    last = used;
  }
}

TEST(Nest, NeedsNoMoreWithMoreTurns) {
  for (unsigned seed = 1; seed < 6; ++seed) {
    for (const std::optional<double> length : {std::optional<double>(), std::optional(420.0)}) {
      const auto pieces = ragged_pieces(10, seed);
      std::pair<std::size_t, double> last = {1000, 0.0};
      for (const Turns turns : {Turns::none, Turns::half, Turns::quarter, Turns::free}) {
        const Nesting nesting =
            nest(pieces, {.width = 500.0, .length = length, .turns = turns, .step = 3.0});
        const std::pair needed = {nesting.sheets, nesting.used_length};
        EXPECT_LE(needed, last) << seed << " " << to_string(turns);
        last = needed;
      }
    }
  }
}

TEST(Nest, RefusesByNameWhatFitsOnNoSheet) {
  const std::vector<NestPiece> pieces = {box_piece("small", 10.0, 10.0),
                                         box_piece("sail", 900.0, 1600.0)};
  const auto message = [&](const NestOptions& options) {
    try {
      nest(pieces, options);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::piece_too_large);
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(message({.width = 1500.0}), HasSubstr("piece \"sail\" is 900 x 1600 mm"));
  EXPECT_THAT(message({.width = 1500.0}), HasSubstr("roll of width 1500 mm"));
  EXPECT_EQ(message({.width = 1500.0, .turns = Turns::quarter}), "");
  EXPECT_THAT(message({.width = 1500.0, .length = 1000.0, .turns = Turns::quarter}),
              HasSubstr("sheets of 1000 x 1500 mm"));
  EXPECT_EQ(message({.width = 1600.0}), "");
  EXPECT_THAT(message({.width = 1600.0, .margin = 1.0}), HasSubstr("margins of 1 mm"));
}

ErrorCode code_of_nest(const std::vector<NestPiece>& pieces, const NestOptions& options) {
  try {
    nest(pieces, options);
  } catch (const Error& error) {
    return error.code();
  }
  return ErrorCode::file_not_found;
}

TEST(Nest, RefusesOptionsAndPiecesThatMakeNoSense) {
  const std::vector<NestPiece> box = {box_piece("box", 10.0, 10.0)};
  EXPECT_EQ(code_of_nest(box, {.width = 0.0}), ErrorCode::option_out_of_range);
  EXPECT_EQ(code_of_nest(box, {.width = 100.0, .gap = -1.0}), ErrorCode::option_out_of_range);
  EXPECT_EQ(code_of_nest(box, {.width = 100.0, .margin = 51.0}), ErrorCode::option_out_of_range);
  EXPECT_EQ(code_of_nest(box, {.width = std::nan("")}), ErrorCode::option_out_of_range);
  EXPECT_EQ(code_of_nest({box_piece("flat", 10.0, 0.0)}, {}), ErrorCode::no_triangles);
  EXPECT_EQ(code_of_nest({box_piece("many", 10.0, 10.0, 10'001)}, {}), ErrorCode::too_large);
  EXPECT_EQ(code_of_nest({box_piece("huge", 1e8, 10.0)}, {}), ErrorCode::too_large);
  NestPiece piece = box_piece("box", 10.0, 10.0);
  for (const double nowhere : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    piece.outline.loops.front()[2].x = nowhere;
    EXPECT_EQ(code_of_nest({piece}, {}), ErrorCode::non_finite_coordinate);
  }
  piece.outline.loops = {{{1e300, 0.0}, {1.1e300, 0.0}, {1e300, 10.0}}};
  EXPECT_EQ(code_of_nest({piece}, {}), ErrorCode::too_large);
}

TEST(Nest, LaysNothingWhereNothingIsAsked) {
  const std::vector<NestPiece> none = {nest_piece("none", {}, 0)};
  const Nesting nesting = nest(none);
  EXPECT_TRUE(nesting.placements.empty());
  EXPECT_EQ(nesting.sheets, 0U);
  EXPECT_EQ(nesting.used_share(), 0.0);
}

TEST(Nest, ReportsRisingProgressAndCanBeCancelled) {
  const auto pieces = ragged_pieces(4, 2);
  expect_cancellable(
      [&](const Context& context) { nest(pieces, {.width = 500.0, .tries = 5}, context); });
}

struct ExactSheet {
  double length, width, gap;
  int count;
  NestOptions sheet;
};

TEST(Nest, FillsASheetThatBoxesFitExactly) {
  const std::vector<ExactSheet> cases = {
      {100, 100, 5.0, 9, {.width = 310.0, .length = 310.0}},
      {300, 200, 0.0, 8, {.width = 800.0, .length = 600.0}},
      {300, 200, 0.0, 8, {.width = 600.0, .length = 800.0, .turns = Turns::quarter}},
      {300, 200, 7.0, 9, {.width = 614.0, .length = 914.0}},
      {33.3, 71.7, 0.7, 30, {.width = 6 * 71.7 + 5 * 0.7, .length = 5 * 33.3 + 4 * 0.7}},
      {100, 100, 5.0, 9, {.width = 330.0, .length = 330.0, .margin = 10.0}},
      {100, 60, 3.0, 200, {.width = 20 * 63.0 - 3.0, .length = 10 * 103.0 - 3.0}}};
  for (ExactSheet exact : cases) {
    exact.sheet.gap = exact.gap;
    const std::vector<NestPiece> pieces = {
        box_piece("box", exact.length, exact.width, exact.count)};
    const Nesting nesting = nest(pieces, exact.sheet);
    EXPECT_EQ(nesting.sheets, 1U) << exact.length << " x " << exact.width;
    expect_sound(pieces, exact.sheet, nesting);
  }
}

TEST(Nest, FillsASheetWithBoxesOfTwoSizes) {
  const std::vector<NestPiece> pieces = {box_piece("large", 200, 200, 2),
                                         box_piece("small", 100, 100, 4)};
  const NestOptions sheet{.width = 400.0, .length = 300.0, .gap = 0.0};
  const Nesting nesting = nest(pieces, sheet);
  EXPECT_EQ(nesting.sheets, 1U);
  expect_sound(pieces, sheet, nesting);
}

}  // namespace
}  // namespace planish
