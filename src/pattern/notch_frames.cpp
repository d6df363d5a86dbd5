#include "pattern/notch_frames.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "pattern/curves/corners.h"
#include "pattern/polygon/plane.h"
#include "pattern/polygon/polygon_rays.h"

namespace planish {

namespace {

constexpr double k_most_reach = 2.5;  // allowances from a place to its cut line
constexpr double k_on_line = 0.01;    // millimetres: a place of the cut line, but for chords
constexpr double k_same_way = 1e-6;   // millimetres
constexpr double k_rounding = 1e-3;   // millimetres that the cut line may be inside the seam
constexpr double k_least_bend = 5.0 * std::numbers::pi / 180.0;  // of a corner that ends a seam

Vec2 unit_or_x(Vec2 v) {
  return norm(v) > 0.0 ? 1.0 / norm(v) * v : Vec2{1.0, 0.0};
}

NotchFrame frame_along(Vec2 seam, Vec2 direction) {
  const Vec2 along = unit_or_x(direction);
  return {seam, along, {-along.y, along.x}};
}

/// The nearest place of a closed line.
struct NearestPlace {
  double way = 0.0;
  double distance = std::numeric_limits<double>::infinity();
};

NearestPlace nearest_place(const Polygon& loop, const BorderWalk& walk, Vec2 place) {
  NearestPlace nearest;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2 a = loop[i], edge = loop[(i + 1) % loop.size()] - a;
    const double squared = dot(edge, edge);
    const double share = squared > 0.0 ? std::clamp(dot(place - a, edge) / squared, 0.0, 1.0) : 0.0;
    const double distance = norm(place - (a + share * edge));
    if (!(distance < nearest.distance)) continue;
    nearest = {walk.way_to(i) + share * std::sqrt(squared), distance};
  }
  return nearest;
}

double distance_to(std::span<const Polygon> loops, Vec2 place) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Polygon& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i)
      nearest = std::min(nearest, distance_to_segment(place, loop[i], loop[(i + 1) % loop.size()]));
  }
  return nearest;
}

/// How far loops run along a ray from its place on, edge by edge; 0 where they leave it at once.
double run_along(std::span<const Polygon> loops, Vec2 place, Vec2 direction) {
  std::vector<std::pair<double, double>> runs;  // of the edges on the ray, as ways along it
  for (const Polygon& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec2 a = loop[i] - place, b = loop[(i + 1) % loop.size()] - place;
      const double off = std::max(std::abs(cross(direction, a)), std::abs(cross(direction, b)));
      const auto [from, to] = std::minmax({dot(direction, a), dot(direction, b)});
      if (off <= k_on_line && to > from + k_on_line) runs.emplace_back(from, to);
    }
  }
  std::sort(runs.begin(), runs.end());
  double end = 0.0;
  for (const auto& [from, to] : runs) {
    if (from <= end + k_on_line) end = std::max(end, to);
  }
  return end;
}

/// Whether the other side of a slit lies at a place, so near that it is no jag of its own side.
bool is_faced(std::span<const Polygon> loops, const NotchFrame& frame, double near) {
  for (const Polygon& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec2 a = loop[i], edge = loop[(i + 1) % loop.size()] - a;
      if (!are_opposite(frame.along, edge)) continue;
      if (distance_to_segment(frame.seam, a, a + edge) <= near) return true;
    }
  }
  return false;
}

/// The shorter way around.
double ways_apart(double a, double b, double length) {
  const double apart = std::abs(std::remainder(a - b, length));
  return std::min(apart, length - apart);
}

}  // namespace

NotchFrames::NotchFrames(const PieceOutline& outline, std::span<const Polygon> cut,
                         const Allowance& allowance, const NotchSizes& sizes)
    : outline_(outline),
      cut_(cut),
      allowance_(allowance),
      sizes_(sizes),
      has_allowance_(
          !std::equal(cut.begin(), cut.end(), outline.loops.begin(), outline.loops.end())) {
  walks_.reserve(outline.loops.size());
  corners_.reserve(outline.loops.size());
  for (const Polygon& loop : outline.loops) {
    const BorderWalk& walk = walks_.emplace_back(loop);
    std::vector<Corner>& corners = corners_.emplace_back();
    for (const std::size_t point : corners_of(loop))
      corners.push_back({walk.way_to(point), point});
  }
}

/// Of a place that belongs to one side, every bend is a corner, as a seam may end there.
std::optional<NotchFrames::Corner> NotchFrames::corner_at(const NotchSeat& seat) const {
  const BorderWalk& walk = walks_[seat.loop];
  const auto is_here = [&](double way) {
    return ways_apart(way, seat.way, walk.length()) <= k_same_way;
  };
  for (const Corner& corner : corners_[seat.loop]) {
    if (is_here(corner.way)) return corner;
  }
  if (seat.side == SeatSide::both) return std::nullopt;
  const Polygon& loop = outline_.loops[seat.loop];
  for (std::size_t point = 0; point < loop.size(); ++point) {
    if (!is_here(walk.way_to(point))) continue;
    const double half = 0.5 * sizes_.width;
    const Vec2 before = loop[point] - walk.at(seat.way - half);
    const Vec2 after = walk.at(seat.way + half) - loop[point];
    if (!(norm(before) > 0.0) || !(norm(after) > 0.0)) return std::nullopt;
    if (std::abs(turn_between(before, after)) < k_least_bend) return std::nullopt;
    return Corner{walk.way_to(point), point};
  }
  return std::nullopt;
}

NotchFrames::Between NotchFrames::between_corners(std::size_t loop, double way) const {
  const double length = walks_[loop].length();
  Between between = {way - length, way + length};
  for (const Corner& corner : corners_[loop]) {
    const double ahead = corner.way - way;
    const double on = ahead > k_same_way ? ahead : ahead + length;
    const double behind = on - length < -k_same_way ? on - length : on - 2.0 * length;
    between.after = std::min(between.after, way + on);
    between.before = std::max(between.before, way + behind);
  }
  return between;
}

double NotchFrames::width_at(std::size_t loop, std::size_t edge) const {
  if (!allowance_.edge_widths.empty()) return allowance_.edge_widths[loop][edge];
  return loop == 0 || allowance_.holes ? allowance_.width : 0.0;
}

/// Of the edge of the place and those beside it.
double NotchFrames::widest_near(const NotchSeat& seat) const {
  const BorderWalk& walk = walks_[seat.loop];
  const std::size_t count = outline_.loops[seat.loop].size();
  std::size_t edge = 0;
  while (edge + 1 < count && walk.way_to(edge + 1) <= seat.way)
    ++edge;
  double widest = 0.0;
  for (const std::size_t k : {edge + count - 1, edge, edge + 1})
    widest = std::max(widest, width_at(seat.loop, k % count));
  return widest;
}

/// The seam's direction as it is from some way back to some way ahead.
NotchFrame NotchFrames::across(const NotchSeat& seat, double back, double ahead) const {
  const BorderWalk& walk = walks_[seat.loop];
  return frame_along(walk.at(seat.way), walk.at(seat.way + ahead) - walk.at(seat.way - back));
}

/// Half way between both sides of a place, so that jags do not turn notches. At the tip of a slit
/// the direction is that of the slit.
NotchFrame NotchFrames::halving(const NotchSeat& seat) const {
  const BorderWalk& walk = walks_[seat.loop];
  const double half = std::min(0.5 * sizes_.width, 0.125 * walk.length());
  const Vec2 at = walk.at(seat.way), from = walk.at(seat.way - half);
  const Vec2 to = walk.at(seat.way + half);
  constexpr double k_closed = 0.05;  // of the length walked: both sides run beside each other
  if (norm(to - from) > k_closed * half) return frame_along(at, to - from);
  const Vec2 out = unit_or_x(0.5 * (from + to) - at);
  return frame_along(at, {-out.y, out.x});
}

/// Whether a place of the cut line lies beside the stretch of border around the seat.
bool NotchFrames::is_beside(const NotchSeat& seat, Vec2 hit, double most) const {
  NearestPlace nearest;
  bool is_own_loop = false;
  for (std::size_t k = 0; k < outline_.loops.size(); ++k) {
    const NearestPlace some = nearest_place(outline_.loops[k], walks_[k], hit);
    if (!(some.distance < nearest.distance)) continue;
    nearest = some;
    is_own_loop = k == seat.loop;
  }
  return is_own_loop && ways_apart(nearest.way, seat.way, walks_[seat.loop].length()) <= most;
}

/// Whether the border is not crossed again, but for its jags, before the cut line is met.
bool NotchFrames::leaves_freely(const NotchFrame& frame, double reach, double jag) const {
  return first_hit(outline_.loops, frame.seam, -1.0 * frame.inward, jag) > reach - k_rounding;
}

/// The frame with its reach; nothing where it meets no cut line of its own.
/// @param runs_beside_line the cut line may run along the ray, so that only its end tells
std::optional<NotchFrame> NotchFrames::met(const NotchSeat& seat, NotchFrame frame, double width,
                                           bool runs_beside_line) const {
  const double jag = std::min(0.5 * width, 0.5 * sizes_.width);
  const auto is_own = [&](double reach) {
    return reach <= k_most_reach * width && leaves_freely(frame, reach, jag) &&
           is_beside(seat, frame.seam - reach * frame.inward, k_most_reach * width + sizes_.width);
  };
  if (!runs_beside_line) {
    frame.reach = first_hit(cut_, frame.seam, -1.0 * frame.inward, -k_rounding);
    if (is_own(frame.reach)) return frame;
  }
  frame.reach = width;
  if (distance_to(cut_, frame.seam - width * frame.inward) > k_on_line) return std::nullopt;
  return is_own(width) ? std::optional(frame) : std::nullopt;
}

/// Outside of the piece and half way to the border beyond at most, so that nothing but what fills
/// a dart is marked; in a slit with no room for it half a millimetre long.
NotchFrame NotchFrames::standing_on_seam(NotchFrame frame) const {
  constexpr double k_jag = 0.05, k_least = 0.5;
  const double free = is_faced(outline_.loops, frame, k_jag)
                          ? 0.0
                          : first_hit(outline_.loops, frame.seam, -1.0 * frame.inward, k_jag);
  frame.reach = std::min(sizes_.depth, std::max(0.5 * free, k_least));
  frame.on_seam = true;
  return frame;
}

/// Beside an edge without an allowance, as a fold, that of the other edge ends at the line of that
/// edge: so does the notch.
std::optional<NotchFrame> NotchFrames::along_bare_edge(const NotchSeat& seat, Vec2 inward,
                                                       Vec2 other, double width) const {
  NotchFrame frame = frame_along(walks_[seat.loop].at(seat.way), {inward.y, -inward.x});
  frame.reach = run_along(cut_, frame.seam, -1.0 * frame.inward);
  if (frame.reach > k_on_line && frame.reach <= k_most_reach * width) return frame;
  const double sine = std::abs(cross(inward, other));
  frame.reach = sine > 0.0 ? width / sine : k_no_hit;
  if (!(frame.reach <= k_most_reach * width)) return std::nullopt;
  if (distance_to(cut_, frame.seam - frame.reach * frame.inward) > k_on_line) return std::nullopt;
  return frame;
}

NotchFrame NotchFrames::at_corner(const NotchSeat& seat, const Corner& corner) const {
  const std::size_t count = outline_.loops[seat.loop].size();
  const double half = 0.5 * sizes_.width;
  const Between between = between_corners(seat.loop, corner.way);
  const NotchFrame before = across(seat, std::min(half, corner.way - between.before), 0.0);
  const NotchFrame after = across(seat, 0.0, std::min(half, between.after - corner.way));
  const double width_before = width_at(seat.loop, (corner.point + count - 1) % count);
  const double width_after = width_at(seat.loop, corner.point);
  const bool both_wide = width_before > 0.0 && width_after > 0.0;
  const auto try_side = [&](SeatSide side) -> std::optional<NotchFrame> {
    const double width = side == SeatSide::before ? width_before : width_after;
    if (!(width > 0.0)) return std::nullopt;
    return met(seat, side == SeatSide::before ? before : after, width, !both_wide);
  };
  const auto try_between = [&]() -> std::optional<NotchFrame> {
    if (!both_wide) return std::nullopt;
    return met(seat, halving(seat), std::max(width_before, width_after), false);
  };
  const bool is_own_before = seat.side == SeatSide::before;
  const SeatSide own = is_own_before ? SeatSide::before : SeatSide::after;
  const SeatSide other = is_own_before ? SeatSide::after : SeatSide::before;
  std::optional<NotchFrame> found;
  if (width_before > 0.0 && !both_wide)
    found = along_bare_edge(seat, after.along, before.along, width_before);
  if (width_after > 0.0 && !both_wide)
    found = along_bare_edge(seat, -1.0 * before.along, after.along, width_after);
  if (!found && seat.side != SeatSide::both) found = try_side(own);
  const bool stands_out = turn_between(before.along, after.along) > 0.0;
  if (!found && (seat.side == SeatSide::both || !stands_out)) found = try_between();
  if (!found) found = try_side(other);
  if (!found) found = try_side(own);
  if (!found && seat.side != SeatSide::both) found = try_between();
  if (found) return *found;
  const NotchFrame middle = halving(seat);
  if (!both_wide) return middle;  // the width is 0, and so is what there is for a notch
  return standing_on_seam(
      stands_out && seat.side != SeatSide::both ? (is_own_before ? before : after) : middle);
}

/// Where nothing but a fold has no width: along the fold, as half way between both sides of the
/// whole piece.
std::optional<NotchFrame> NotchFrames::at_end_of_fold(const NotchSeat& seat) const {
  if (allowance_.edge_widths.empty()) return std::nullopt;
  const auto corner = corner_at(seat);
  if (!corner) return std::nullopt;
  const std::size_t count = outline_.loops[seat.loop].size();
  const bool fold_is_before = width_at(seat.loop, (corner->point + count - 1) % count) == 0.0;
  const bool fold_is_after = width_at(seat.loop, corner->point) == 0.0;
  if (fold_is_before == fold_is_after) return std::nullopt;
  const double half = 0.5 * sizes_.width;
  const Vec2 inward =
      fold_is_after ? across(seat, 0.0, half).along : -1.0 * across(seat, half, 0.0).along;
  return frame_along(walks_[seat.loop].at(seat.way), {inward.y, -inward.x});
}

NotchFrame NotchFrames::at(const NotchSeat& seat) const {
  if (!has_allowance_) return at_end_of_fold(seat).value_or(halving(seat));
  if (const auto corner = corner_at(seat)) return at_corner(seat, *corner);
  const Between between = between_corners(seat.loop, seat.way);
  const double half = std::min(0.5 * sizes_.width, 0.125 * walks_[seat.loop].length());
  const NotchFrame frame = across(seat, std::min(half, seat.way - between.before),
                                  std::min(half, between.after - seat.way));
  const double width = widest_near(seat);
  if (!(width > 0.0)) return frame;
  if (const auto found = met(seat, frame, width, false)) return *found;
  return standing_on_seam(frame);
}

/// Of a corner beside an edge without an allowance, as the end of a fold, the other edge.
NotchSeat NotchFrames::beside_bare_edge(NotchSeat seat) const {
  const auto corner = seat.side == SeatSide::both ? corner_at(seat) : std::nullopt;
  if (!corner) return seat;
  const std::size_t count = outline_.loops[seat.loop].size();
  const bool wide_before = width_at(seat.loop, (corner->point + count - 1) % count) > 0.0;
  const bool wide_after = width_at(seat.loop, corner->point) > 0.0;
  if (wide_before != wide_after) seat.side = wide_before ? SeatSide::before : SeatSide::after;
  return seat;
}

std::vector<NotchSeat> NotchFrames::pair_around(const NotchSeat& place) const {
  const NotchSeat seat = has_allowance_ ? beside_bare_edge(place) : place;
  const double aside = 0.5 * sizes_.spacing;
  double middle = seat.way;
  if (seat.side != SeatSide::both) {
    const auto corner = corner_at(seat);
    Between between = between_corners(seat.loop, seat.way);
    if (corner && seat.side == SeatSide::before) between.after = seat.way;
    if (corner && seat.side == SeatSide::after) between.before = seat.way;
    if (between.after - between.before >= sizes_.spacing)
      middle = std::clamp(middle, between.before + aside, between.after - aside);
  }
  return {{seat.loop, middle - aside, seat.side}, {seat.loop, middle + aside, seat.side}};
}

}  // namespace planish
