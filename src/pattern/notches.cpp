#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include <planish/core/error.h>
#include <planish/core/fields.h>
#include <planish/pattern/notches.h>

#include "core/number_text.h"
#include "pattern/border_walk.h"
#include "pattern/polygon_rays.h"

namespace planish {

namespace {

/// A place of the seam, by its loop and the way along it.
struct Seat {
  std::size_t loop = 0;
  double way = 0.0;
};

/// A notch on its cut line.
struct Frame {
  Vec2 seam;           ///< the place on the seam
  Vec2 along;          ///< the direction of the seam, length 1
  Vec2 inward;         ///< at right angles, to the left
  double reach = 0.0;  ///< from the seam out to the cut line
};

std::string name_of(const PieceOutline& outline, const Notch& notch) {
  const std::string piece = "piece \"" + outline.piece + "\": the notch at ";
  if (const auto* vertex = std::get_if<Index>(&notch.place)) {
    return piece + "vertex " + std::to_string(*vertex);
  }
  return piece + number_text(std::get<double>(notch.place)) + " of the border";
}

[[noreturn]] void fail(const PieceOutline& outline, const Notch& notch, const std::string& what) {
  ErrorPlace place;
  if (const auto* vertex = std::get_if<Index>(&notch.place)) place.first = *vertex;
  throw Error(ErrorCode::misplaced_notch, name_of(outline, notch) + what, place);
}

Seat seat_of(const PieceOutline& outline, const Notch& notch,
             const std::vector<BorderWalk>& walks) {
  if (const auto* share = std::get_if<double>(&notch.place)) {
    if (*share >= 0.0 && *share <= 1.0) return {0, *share * walks[0].length()};
    fail(outline, notch, " is off the border: shares are from 0 to 1");
  }
  const Index vertex = std::get<Index>(notch.place);
  for (std::size_t k = 0; k < outline.vertices.size(); ++k) {
    const auto& loop = outline.vertices[k];
    const auto found = std::find(loop.begin(), loop.end(), vertex);
    if (found != loop.end()) {
      return {k, walks[k].way_to(static_cast<std::size_t>(found - loop.begin()))};
    }
  }
  fail(outline, notch, " is off the border: this vertex is not on it");
}

/// The seam's direction as it is over the width of a notch, so that jags do not turn notches.
Frame frame_at(const BorderWalk& walk, double way, double width) {
  const double half = std::min(0.5 * width, 0.125 * walk.length());
  Vec2 chord = walk.at(way + half) - walk.at(way - half);
  if (!(norm(chord) > 0.0)) chord = {1.0, 0.0};
  const Vec2 along = 1.0 / norm(chord) * chord;
  return {walk.at(way), along, {-along.y, along.x}};
}

bool has_allowance(const PieceOutline& outline, std::span<const Polygon> cut) {
  return !std::equal(cut.begin(), cut.end(), outline.loops.begin(), outline.loops.end());
}

void check_depth(const PieceOutline& outline, const Notch& notch, const Frame& frame, double depth,
                 bool with_allowance) {
  const std::string deep = " is " + fixed_text(depth, 3) + " mm deep and would reach ";
  if (with_allowance && !(depth <= frame.reach + 1e-6)) {
    fail(outline, notch,
         deep + "through the seam, which is " + fixed_text(frame.reach, 3) + " mm from the cut");
  }
  if (!with_allowance && first_hit(outline.loops, frame.seam, frame.inward, 1e-3) <= depth) {
    fail(outline, notch, deep + "out of the piece");
  }
}

/// Where a V begins: on the cut line, half its width to the side.
Vec2 base(const Frame& frame, std::span<const Polygon> cut, double aside, double depth) {
  const Vec2 from = frame.seam + aside * frame.along;
  double reach = first_hit(cut, from, -1.0 * frame.inward, frame.reach - depth);
  if (!(reach <= frame.reach + depth)) reach = frame.reach;
  return from - reach * frame.inward;
}

void append_notch(NotchKind kind, const Frame& frame, std::span<const Polygon> cut,
                  const NotchSizes& sizes, std::vector<Polygon>& lines) {
  const Vec2 start = frame.seam - frame.reach * frame.inward;
  const Vec2 tip = start + sizes.depth * frame.inward;
  const double half = 0.5 * sizes.width;
  if (kind == NotchKind::v) {
    lines.push_back(
        {base(frame, cut, -half, sizes.depth), tip, base(frame, cut, half, sizes.depth)});
    return;
  }
  lines.push_back({start, tip});
  if (kind == NotchKind::t) lines.push_back({tip - half * frame.along, tip + half * frame.along});
}

void check_sizes(const NotchSizes& sizes) {
  constexpr Range range = {.min = 0.01, .max = 1000.0};
  check_range("notch depth", sizes.depth, range);
  check_range("notch width", sizes.width, range);
  check_range("notch spacing", sizes.spacing, range);
}

std::vector<BorderWalk> walks_along(const PieceOutline& outline) {
  std::vector<BorderWalk> walks;
  walks.reserve(outline.loops.size());
  for (const Polygon& loop : outline.loops)
    walks.emplace_back(loop);
  return walks;
}

}  // namespace

std::string_view to_string(NotchKind kind) {
  switch (kind) {
    case NotchKind::slit:
      return "slit";
    case NotchKind::v:
      return "v";
    case NotchKind::t:
      return "t";
  }
  return "unknown";
}

std::vector<Polygon> notch_lines(const PieceOutline& outline, std::span<const Polygon> cut,
                                 std::span<const Notch> notches, const NotchSizes& sizes) {
  check_sizes(sizes);
  const std::vector<BorderWalk> walks = walks_along(outline);
  const bool with_allowance = has_allowance(outline, cut);
  std::vector<Polygon> lines;
  for (const Notch& notch : notches) {
    const Seat seat = seat_of(outline, notch, walks);
    const double aside = notch.is_double ? 0.5 * sizes.spacing : 0.0;
    for (const double way : {seat.way - aside, seat.way + aside}) {
      Frame frame = frame_at(walks[seat.loop], way, sizes.width);
      if (with_allowance) {
        // A seam without an allowance of its own lies on the cut line, but for rounding.
        const double hit = first_hit(cut, frame.seam, -1.0 * frame.inward, -1e-3);
        frame.reach = hit == k_no_hit ? 0.0 : hit;
      }
      check_depth(outline, notch, frame, sizes.depth, with_allowance);
      append_notch(notch.kind, frame, cut, sizes, lines);
      if (!notch.is_double) break;
    }
  }
  return lines;
}

}  // namespace planish
