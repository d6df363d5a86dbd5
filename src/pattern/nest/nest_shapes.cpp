#include "pattern/nest/nest_shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <planish/core/error.h>

#include "core/number_text.h"
#include "pattern/polygon/loop_box.h"

namespace planish {

namespace {

constexpr double k_fit_slack = 1e-7;         // millimetres that a piece may be too large
constexpr double k_columns_a_piece = 150.0;  // of the middling piece
constexpr double k_most_columns = 20'000.0;  // of the largest
constexpr double k_largest_number = 1e7;     // millimetres

double in_one_turn(double degrees) {
  const double angle = std::fmod(degrees, 360.0);
  const double positive = angle < 0.0 ? angle + 360.0 : angle;
  return positive < 360.0 ? positive : 0.0;
}

/// Against the grain, in degrees.
std::vector<double> turns_of(const NestPiece& piece, const NestOptions& options) {
  switch (std::min(piece.turns.value_or(options.turns), options.turns)) {
    case Turns::none:
      return {0.0};
    case Turns::half:
      return {0.0, 180.0};
    case Turns::quarter:
      return {0.0, 90.0, 180.0, 270.0};
    case Turns::free:
      break;
  }
  std::vector<double> angles;
  angles.reserve(24);
  for (int turn = 0; turn < 24; ++turn)
    angles.push_back(15.0 * turn);
  return angles;
}

/// In which the piece may be turned, in degrees, at least 0 and less than 360.
std::vector<double> angles_of(const NestPiece& piece, const NestOptions& options) {
  if (piece.fold) return {in_one_turn(*piece.fold)};
  std::vector<double> angles = turns_of(piece, options);
  for (double& angle : angles)
    angle = in_one_turn(piece.angle + angle);
  return angles;
}

std::vector<Polygon> turned(const PieceOutline& outline, double angle) {
  const NestPlacement turn{.angle = angle};
  std::vector<Polygon> loops = outline.loops;
  for (Polygon& loop : loops) {
    for (Vec2& p : loop)
      p = turn(p);
  }
  return loops;
}

/// Without lines around holes, which go clockwise.
void fill_holes(std::vector<Polygon>& loops) {
  const auto is_hole = [](const Polygon& loop) { return signed_area(loop) < 0.0; };
  if (!std::all_of(loops.begin(), loops.end(), is_hole)) std::erase_if(loops, is_hole);
}

/// The length along the sheet of pieces that fill their boxes, with the gap.
struct BoxLength {
  double length = 0.0, area = 0.0;  ///< of all copies
};

std::vector<BoxLength> box_lengths(std::span<const NestPiece> pieces, const NestOptions& options) {
  constexpr double k_full = 0.98;  // of its box
  std::vector<BoxLength> lengths;
  for (const NestPiece& piece : pieces) {
    if (piece.quantity == 0) continue;
    const double area = std::abs(signed_area(piece.outline.loops.front()));
    for (const double angle : angles_of(piece, options)) {
      const Vec2 size = loop_box(turned(piece.outline, angle)).size();
      if (area < k_full * size.x * size.y) continue;
      const double length = size.x + options.gap;
      const auto found = std::find_if(lengths.begin(), lengths.end(), [&](const BoxLength& other) {
        return std::abs(other.length - length) < k_fit_slack;
      });
      if (found == lengths.end())
        lengths.push_back({length, piece.quantity * area});
      else
        found->area += piece.quantity * area;
    }
  }
  return lengths;
}

bool is_multiple(double length, double step) {
  constexpr double k_exact = 1e-9;  // millimetres: a hundred in a row stay within the slack
  return std::abs(length - std::round(length / step) * step) < k_exact;
}

bool fits(Vec2 size, const NestOptions& options) {
  const double width = width_of(options) + k_fit_slack;
  const double length = options.length ? *options.length - 2.0 * options.margin + k_fit_slack
                                       : std::numeric_limits<double>::infinity();
  return size.x <= length && size.y <= width;
}

std::string size_text_of(Vec2 size) {
  return fixed_text(size.x, 1) + " x " + fixed_text(size.y, 1) + " mm";
}

[[noreturn]] void refuse_size(const NestPiece& piece, const NestOptions& options, Vec2 size) {
  const std::string sheet = options.length ? "sheets of " + fixed_text(*options.length, 1) + " x " +
                                                 fixed_text(options.width, 1)
                                           : "a roll of width " + fixed_text(options.width, 1);
  const std::string margin =
      options.margin > 0.0 ? " with margins of " + fixed_text(options.margin, 1) + " mm" : "";
  const std::string advice = piece.turns.value_or(options.turns) == Turns::free
                                 ? ""
                                 : ", or let pieces be turned more freely";
  throw Error(ErrorCode::piece_too_large,
              "piece \"" + piece.outline.piece + "\" is " + size_text_of(size) +
                  ", length by width, and fits on no place of " + sheet + " mm" + margin +
                  "; take wider sheets, or divide the piece" + advice);
}

}  // namespace

double column_step(std::span<const NestPiece> pieces, const NestOptions& options) {
  double area = 0.0, copies = 0.0, longest = 0.0;
  for (const NestPiece& piece : pieces) {
    if (piece.quantity == 0) continue;
    const Vec2 size = loop_box(piece.outline.loops).size();
    if (!(size.x + size.y < k_largest_number)) {
      throw Error(ErrorCode::too_large, "piece \"" + piece.outline.piece +
                                            "\" is larger than pieces that can be laid on sheets");
    }
    area += piece.quantity * size.x * size.y;
    copies += piece.quantity;
    longest = std::max(longest, norm(size));
  }
  if (!(copies > 0.0)) return 1.0;
  const double wanted =
      options.step > 0.0 ? options.step : std::sqrt(area / copies) / k_columns_a_piece;
  return std::max(wanted, longest / k_most_columns);
}

std::optional<double> step_of_boxes(std::span<const NestPiece> pieces, const NestOptions& options,
                                    double step) {
  const std::vector<BoxLength> lengths = box_lengths(pieces, options);
  if (lengths.empty()) return std::nullopt;
  const auto largest =
      std::max_element(lengths.begin(), lengths.end(),
                       [](const BoxLength& a, const BoxLength& b) { return a.area < b.area; });
  const double least = std::ceil(largest->length / step);
  for (double count = least; count <= 2.0 * least; count += 1.0) {
    const double some = largest->length / count;
    if (std::all_of(lengths.begin(), lengths.end(),
                    [&](const BoxLength& box) { return is_multiple(box.length, some); }))
      return some;
  }
  return largest->length / least;
}

bool all_fit(std::span<const NestPiece> pieces, const NestOptions& options) {
  return std::all_of(pieces.begin(), pieces.end(), [&](const NestPiece& piece) {
    const std::vector<double> angles = angles_of(piece, options);
    return piece.quantity == 0 || std::any_of(angles.begin(), angles.end(), [&](double angle) {
             return fits(loop_box(turned(piece.outline, angle)).size(), options);
           });
  });
}

std::vector<TurnedPiece> turned_pieces(const NestPiece& piece, const NestOptions& options,
                                       double step) {
  std::vector<TurnedPiece> result;
  Vec2 narrowest{0.0, std::numeric_limits<double>::infinity()};
  for (const double angle : angles_of(piece, options)) {
    TurnedPiece candidate{.angle = angle};
    std::vector<Polygon> loops = turned(piece.outline, candidate.angle);
    const LoopBox box = loop_box(loops);
    if (box.size().y < narrowest.y) narrowest = box.size();
    if (!fits(box.size(), options)) continue;
    for (Polygon& loop : loops) {
      for (Vec2& p : loop)
        p = p - box.low;
    }
    if (!options.in_holes) fill_holes(loops);
    candidate.low = box.low;
    candidate.size = box.size();
    candidate.columns = column_spans(loops, step, 0.0);
    candidate.grown = column_spans(loops, step, options.gap);
    result.push_back(std::move(candidate));
  }
  if (result.empty()) refuse_size(piece, options, narrowest);
  return result;
}

}  // namespace planish
