// Laying any pieces on sheets: all of them, and none nearer to another than the gap.

#include <array>
#include <cmath>

#include <planish/pattern/nest.h>

#include "fuzz/bytes_to_outline.h"
#include "fuzz/check.h"
#include "oracle/outline_gap.h"

using namespace planish;

namespace {

NestOptions options_from(fuzz::Bytes& bytes) {
  NestOptions options{.width = 50.0 + 10.0 * static_cast<double>(bytes.byte()), .tries = 2};
  if (bytes.flag()) options.length = 50.0 + 10.0 * static_cast<double>(bytes.byte());
  options.gap = 0.25 * static_cast<double>(bytes.byte() % 64);
  options.margin = 0.5 * static_cast<double>(bytes.byte() % 32);
  options.step = 0.5 * static_cast<double>(bytes.byte() % 40);
  options.turns =
      std::array{Turns::none, Turns::half, Turns::quarter, Turns::free}[bytes.whole(0, 3)];
  options.in_holes = bytes.flag();
  return options;
}

oracle::Loops loops_of(const NestPiece& piece, const NestPlacement& placement) {
  oracle::Loops loops = piece.outline.loops;
  for (auto& loop : loops) {
    for (Vec2& p : loop)
      p = placement(p);
  }
  return loops;
}

void check_nesting(const std::vector<NestPiece>& pieces, const NestOptions& options,
                   const Nesting& nesting, bool all_simple) {
  std::size_t copies = 0;
  for (const NestPiece& piece : pieces)
    copies += static_cast<std::size_t>(piece.quantity);
  fuzz::check(nesting.placements.size() == copies, "every copy is laid");
  fuzz::check(std::isfinite(nesting.used_length) && nesting.used_share() <= 1.0 + 1e-9,
              "no more is used than there is");
  std::vector<oracle::Loops> laid;
  for (const NestPlacement& placement : nesting.placements) {
    fuzz::check(fuzz::is_finite(placement.shift) && placement.sheet < nesting.sheets,
                "copies are on sheets");
    laid.push_back(loops_of(pieces[placement.piece], placement));
    const oracle::OutlineBox box = oracle::outline_box(laid.back());
    const double m = options.margin - 1e-6;
    fuzz::check(box.low.x >= m && box.low.y >= m && box.high.y <= options.width - m,
                "the margin stays free");
    fuzz::check(!options.length || box.high.x <= *options.length - m, "sheets end");
    for (std::size_t j = 0; all_simple && j + 1 < laid.size(); ++j) {
      if (nesting.placements[j].sheet != placement.sheet) continue;
      fuzz::check(
          oracle::gap_between(laid.back(), laid[j], options.gap + 1.0) >= options.gap - 1e-6,
          "no piece is nearer to another one than the gap");
    }
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Bytes bytes(data, size);
  const NestOptions options = options_from(bytes);
  std::vector<NestPiece> pieces;
  bool all_simple = true;
  for (std::size_t count = bytes.whole(0, 4); count > 0; --count) {
    auto [outline, is_simple] = fuzz::outline_from(bytes);
    all_simple = all_simple && is_simple;
    const int quantity = static_cast<int>(bytes.whole(0, 4));
    pieces.push_back({outline, quantity, 0.1 * static_cast<double>(bytes.whole(0, 3600))});
  }
  fuzz::allow_refusal([&] {
    const auto nesting = nest(pieces, options);
    check_nesting(pieces, options, nesting, all_simple);
  });
  return 0;
}
