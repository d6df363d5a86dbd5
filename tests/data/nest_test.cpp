// Layouts of the patterns of real patches, of the folder that PLANISH_TEST_DATA tells.

#include <planish/io/read_mesh.h>
#include <planish/pattern/nest.h>
#include <planish/unfold/unfold.h>

#include <gtest/gtest.h>

#include "oracle/outline_gap.h"
#include "support/test_patches.h"

namespace planish {
namespace {

/// What is cut of each patch that has a pattern, brought to sizes between 200 and 600 mm.
std::vector<NestPiece> real_pieces() {
  std::vector<NestPiece> pieces;
  for (const PatchFacts& facts : patches()) {
    if (facts.vertices > 6'000) continue;  // slow to unfold
    const TriMesh mesh = read_mesh(facts.path).mesh;
    const Patch surface(mesh);
    if (surface.border_loops().size() != 1) continue;
    const Pattern pattern = unfold(surface);
    std::vector<Vec2> positions;
    const double length = 200.0 + 80.0 * static_cast<double>(pieces.size() % 6);
    for (const Vec2 p : pattern.positions)
      positions.push_back(length / pattern.width * p);
    NestPiece piece{piece_outline(surface.border_loops(), positions, facts.name),
                    1 + static_cast<int>(pieces.size() % 2)};
    piece.angle = 17.0 * static_cast<double>(pieces.size());
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

TEST(Patches, LieApartOnSheets) {
  const std::vector<NestPiece> pieces = real_pieces();
  if (pieces.empty()) return;
  for (const Turns turns : {Turns::half, Turns::free}) {
    const NestOptions options{.gap = 4.0, .margin = 10.0, .turns = turns, .tries = 4};
    const auto nesting = nest(pieces, options);
    std::vector<oracle::Loops> laid;
    for (const NestPlacement& placement : nesting.placements) {
      laid.push_back(pieces[placement.piece].outline.loops);
      for (auto& loop : laid.back()) {
        for (Vec2& p : loop)
          p = placement(p);
      }
      for (std::size_t j = 0; j + 1 < laid.size(); ++j)
        EXPECT_GE(oracle::gap_between(laid.back(), laid[j], 5.0), 4.0 - 1e-6);
    }
    EXPECT_GT(nesting.used_share(), 0.6);
    RecordProperty("share_" + std::string(to_string(turns)), std::to_string(nesting.used_share()));
  }
}

}  // namespace
}  // namespace planish
