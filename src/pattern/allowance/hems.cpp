#include "pattern/allowance/hems.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numbers>
#include <string>
#include <utility>

#include <planish/core/error.h>

#include "core/number_text.h"
#include "pattern/allowance/bare_ends.h"
#include "pattern/allowance/flap.h"
#include "pattern/polygon/plane.h"

namespace planish {

namespace {

/// A hem by its ends, the piece on its left.
struct Hem {
  Vec2 from, to;
  double width = 0.0;
  double reach_before = 0.0, reach_behind = 0.0;  ///< of the flap, beyond its ends
  std::size_t loop = 0, first = 0, count = 0;     ///< points and edges of the outline

  Vec2 along() const { return 1.0 / norm(to - from) * (to - from); }
  /// Into the piece.
  Vec2 inwards() const { return -1.0 * outwards(along()); }
  CreaseLine crease() const { return {from, along()}; }
};

/// How far a flap may reach beyond an end of its hem: as far as other allowances do at a corner.
/// Where the border goes on straight, its own allowance does too.
double reach_at(Vec2 before, Vec2 end, Vec2 behind, double width, double widest) {
  constexpr double k_straight = 5.0 * std::numbers::pi / 180.0, k_overlap = 0.05;
  const double turn = std::abs(turn_between(end - before, behind - end));
  return turn > k_straight ? 2.0 * widest : k_overlap * width;
}

double widest_of(const Allowance& allowance) {
  double widest = 0.0;
  for (const std::vector<double>& widths : allowance.edge_widths) {
    for (const double width : widths)
      widest = std::max(widest, width);
  }
  return widest;
}

std::vector<Hem> hems_of(const PieceOutline& outline, const Allowance& allowance) {
  std::map<int, Hem> hems;
  for (std::size_t k = 0; k < allowance.hems.size(); ++k) {
    const std::vector<int>& numbers = allowance.hems[k];
    const std::size_t n = numbers.size();
    for (std::size_t i = 0; i < n; ++i) {
      if (numbers[i] == 0 || !(allowance.edge_widths[k][i] > 0.0)) continue;
      Hem& hem = hems[numbers[i]];
      hem.loop = k;
      hem.width = allowance.edge_widths[k][i];
      ++hem.count;
      if (numbers[(i + n - 1) % n] != numbers[i]) hem.first = i;
    }
  }
  std::vector<Hem> result;
  const double widest = widest_of(allowance);
  for (auto& [number, hem] : hems) {
    const Polygon& loop = outline.loops[hem.loop];
    const std::size_t n = loop.size();
    const auto point = [&](std::size_t k) { return loop[k % n]; };
    hem.from = point(hem.first);
    hem.to = point(hem.first + hem.count);
    hem.reach_before =
        reach_at(point(hem.first + n - 1), hem.from, point(hem.first + 1), hem.width, widest);
    hem.reach_behind = reach_at(point(hem.first + hem.count + n - 1), hem.to,
                                point(hem.first + hem.count + 1), hem.width, widest);
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
    depth = std::max(depth, hem.crease().height(p));
  if (depth < hem.width) {
    refuse(outline, ErrorCode::option_out_of_range,
           "a hem is " + fixed_text(hem.width, 1) + " mm wide, and the piece behind it only " +
               fixed_text(depth, 1) + " mm");
  }
}

/// What is folded over of one line of the piece.
Polygon flap_of(const Hem& hem, Polygon line) {
  const Vec2 along = hem.along(), in = hem.inwards();
  const EndLine bounds[] = {{hem.from, along},
                            {hem.from + hem.width * in, -1.0 * along},
                            {hem.from - hem.reach_before * along, -1.0 * in},
                            {hem.to + hem.reach_behind * along, in}};
  return mirrored(left_of(std::move(line), bounds), hem.crease());
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

PieceOutline with_straight_hems(PieceOutline outline, const Allowance& allowance) {
  for (const Hem& hem : hems_of(outline, allowance)) {
    check_hem(outline, hem);
    Polygon& loop = outline.loops[hem.loop];
    straighten(hem.first, (hem.first + hem.count) % loop.size(), loop);
  }
  return outline;
}

std::vector<Polygon> with_hems(const PieceOutline& outline, const Allowance& allowance,
                               std::vector<Polygon> lines) {
  const std::vector<Polygon> before = lines;
  for (const Hem& hem : hems_of(outline, allowance)) {
    for (const Polygon& line : before) {
      if (!(signed_area(line) > 0.0)) continue;
      Polygon flap = flap_of(hem, line);
      Polygon strip = strip_over(hem.crease(), flap);
      if (strip.empty() || !(signed_area(flap) > 0.0)) continue;
      lines.push_back(std::move(flap));
      lines.push_back(std::move(strip));
    }
  }
  return lines.size() == before.size() ? lines : united_flaps(lines);
}

}  // namespace planish
