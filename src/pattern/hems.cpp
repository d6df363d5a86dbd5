#include "pattern/hems.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include <planish/core/error.h>

#include "core/number_text.h"
#include "pattern/bare_ends.h"
#include "pattern/polygon/plane.h"
#include "pattern/polygon/winding_union.h"

namespace planish {

namespace {

/// A hem by its ends, the piece on its left.
struct Hem {
  Vec2 from, to;
  double width = 0.0;
  std::size_t loop = 0, first = 0, count = 0;  ///< points and edges of the outline

  Vec2 along() const { return 1.0 / norm(to - from) * (to - from); }
  /// Into the piece.
  Vec2 inwards() const { return -1.0 * outwards(along()); }
  /// How far a place is on the side of the piece.
  double height(Vec2 p) const { return cross(along(), p - from); }
};

std::vector<Hem> hems_of(const PieceOutline& outline, const Allowance& allowance) {
  std::map<int, Hem> hems;
  for (std::size_t k = 0; k < allowance.hems.size(); ++k) {
    const std::vector<int>& numbers = allowance.hems[k];
    const std::size_t n = numbers.size();
    for (std::size_t i = 0; i < n; ++i) {
      if (numbers[i] == 0 || !(allowance.edge_widths[k][i] > 0.0)) continue;
      Hem& hem =
          hems.try_emplace(numbers[i], Hem{{}, {}, allowance.edge_widths[k][i], k}).first->second;
      ++hem.count;
      if (numbers[(i + n - 1) % n] != numbers[i]) hem.first = i;
    }
  }
  std::vector<Hem> result;
  for (auto& [number, hem] : hems) {
    const Polygon& loop = outline.loops[hem.loop];
    hem.from = loop[hem.first];
    hem.to = loop[(hem.first + hem.count) % loop.size()];
    result.push_back(hem);
  }
  return result;
}

[[noreturn]] void refuse(const PieceOutline& outline, ErrorCode code, const std::string& what) {
  throw Error(code, "piece \"" + outline.piece + "\": " + what);
}

void check_hem(const PieceOutline& outline, const Hem& hem) {
  constexpr double k_straight = 0.5, k_share = 0.001;
  const Polygon& loop = outline.loops[hem.loop];
  const double length = norm(hem.to - hem.from);
  double bow = length > 0.0 ? 0.0 : std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i <= hem.count && length > 0.0; ++i) {
    const Vec2 p = loop[(hem.first + i) % loop.size()];
    bow = std::max(bow, distance_to_segment(p, hem.from, hem.to));
  }
  if (bow > std::max(k_straight, k_share * length)) {
    refuse(outline, ErrorCode::misplaced_allowance,
           "a hem is " +
               (std::isfinite(bow) ? fixed_text(bow, 1) + " mm off the line" : "not open") +
               " between its ends, and material folds along a straight line only: give a plain "
               "allowance there");
  }
  double depth = 0.0;
  for (const Vec2 p : outline.loops.front())
    depth = std::max(depth, hem.height(p));
  if (depth < hem.width) {
    refuse(outline, ErrorCode::option_out_of_range,
           "a hem is " + fixed_text(hem.width, 1) + " mm wide, and the piece behind it only " +
               fixed_text(depth, 1) + " mm");
  }
}

/// What is folded over of one line of the piece.
/// @param reach along the hem, beyond its ends
Polygon flap_of(const Hem& hem, Polygon line, double reach) {
  const Vec2 along = hem.along(), in = hem.inwards();
  const EndLine bounds[] = {{hem.from, along},
                            {hem.from + hem.width * in, -1.0 * along},
                            {hem.from - reach * along, -1.0 * in},
                            {hem.to + reach * along, in}};
  line = left_of(std::move(line), bounds);
  for (Vec2& p : line)
    p = p - 2.0 * hem.height(p) * in;
  std::reverse(line.begin(), line.end());
  return line;
}

/// A strip over the line of the hem, so that rounding leaves no gap there.
Polygon strip_over(const Hem& hem, const Polygon& flap) {
  constexpr double k_near = 1e-4, k_half = 0.001;  // millimetres
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Vec2 p : flap) {
    if (std::abs(hem.height(p)) > k_near) continue;
    low = std::min(low, dot(hem.along(), p - hem.from));
    high = std::max(high, dot(hem.along(), p - hem.from));
  }
  if (!(low < high)) return {};
  const Vec2 a = hem.from + low * hem.along(), b = hem.from + high * hem.along();
  const Vec2 in = k_half * hem.inwards();
  return {a - in, b - in, b + in, a + in};
}

}  // namespace

Allowance without_hems(Allowance allowance) {
  for (std::size_t k = 0; k < allowance.hems.size(); ++k) {
    for (std::size_t i = 0; i < allowance.hems[k].size(); ++i) {
      if (allowance.hems[k][i] == 0) continue;
      allowance.edge_widths[k][i] = 0.0;
      allowance.folds[k][i] = 1;
    }
  }
  return allowance;
}

std::vector<Polygon> with_hems(const PieceOutline& outline, const Allowance& allowance,
                               std::vector<Polygon> lines) {
  const std::vector<Polygon> before = lines;
  double widest = 0.0;
  for (const std::vector<double>& widths : allowance.edge_widths) {
    for (const double width : widths)
      widest = std::max(widest, width);
  }
  for (const Hem& hem : hems_of(outline, allowance)) {
    check_hem(outline, hem);
    for (const Polygon& line : before) {
      if (!(signed_area(line) > 0.0)) continue;
      Polygon flap = flap_of(hem, line, 2.0 * widest);
      Polygon strip = strip_over(hem, flap);
      if (strip.empty() || !(signed_area(flap) > 0.0)) continue;
      lines.push_back(std::move(flap));
      lines.push_back(std::move(strip));
    }
  }
  return lines.size() == before.size() ? lines : winding_union(lines);
}

}  // namespace planish
