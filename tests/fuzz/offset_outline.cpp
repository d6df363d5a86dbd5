// Allowances around any outline: as far from it as asked, and never through each other.

#include <algorithm>
#include <array>
#include <numbers>

#include <planish/pattern/allowance.h>

#include "fuzz/bytes_to_outline.h"
#include "fuzz/check.h"
#include "oracle/outline_distance.h"

using namespace planish;

namespace {

/// The least and the most that an allowance may be wide.
struct Widths {
  double least = 0.0, most = 0.0;
};

Widths widths_of(const Allowance& allowance) {
  Widths widths{allowance.width, allowance.width};
  for (const auto& loop : allowance.edge_widths) {
    for (const double width : loop)
      widths = {std::min(widths.least, width), std::max(widths.most, width)};
  }
  return widths;
}

double reach_of(const Allowance& allowance) {
  if (allowance.corners == Corners::round) return 1.0;
  return allowance.corners == Corners::square
             ? std::numbers::sqrt2
             : std::max(allowance.mitre_limit, std::numbers::sqrt2);
}

Allowance allowance_from(fuzz::Bytes& bytes, const PieceOutline& outline) {
  Allowance allowance{.width = 0.25 * static_cast<double>(bytes.whole(1, 200))};
  allowance.corners =
      std::array{Corners::mitre, Corners::square, Corners::round}[bytes.whole(0, 2)];
  allowance.mitre_limit = 1.0 + 0.05 * static_cast<double>(bytes.whole(0, 100));
  allowance.holes = bytes.flag();
  if (bytes.whole(0, 3) == 0) {
    for (const Polygon& loop : outline.loops) {
      allowance.edge_widths.emplace_back();
      for (std::size_t k = 0; k < loop.size(); ++k)
        allowance.edge_widths.back().push_back(0.5 * static_cast<double>(bytes.byte() % 32));
    }
  }
  return allowance;
}

void check_distances(const PieceOutline& outline, const Allowance& allowance,
                     const std::vector<Polygon>& cut) {
  const Widths widths = widths_of(allowance);
  const auto range = oracle::distances(cut, outline.loops);
  const bool all_grow = allowance.holes || outline.loops.size() == 1;
  fuzz::check(!all_grow || range.least > widths.least - 0.0051, "allowances are as wide as asked");
  fuzz::check(range.most < reach_of(allowance) * widths.most + 1e-3,
              "allowances reach no farther than their limit");
  fuzz::check(!oracle::any_cross(cut), "lines do not cross");
  fuzz::check(signed_area(cut.front()) > 0.0, "outer lines run counter-clockwise");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Bytes bytes(data, size);
  const auto [outline, is_simple] = fuzz::outline_from(bytes);
  const Allowance allowance = allowance_from(bytes, outline);
  fuzz::allow_refusal([&, &outline = outline, is_simple = is_simple] {
    const std::vector<Polygon> cut = offset_outline(outline, allowance);
    for (const Polygon& loop : cut) {
      for (const Vec2 p : loop)
        fuzz::check(fuzz::is_finite(p), "allowances are finite");
    }
    if (is_simple) check_distances(outline, allowance, cut);
  });
  return 0;
}
