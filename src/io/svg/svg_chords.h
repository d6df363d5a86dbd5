#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <planish/core/vec.h>

#include "io/svg/svg_values.h"

namespace planish {

/// How far a chord may be from its curve, millimetres.
inline constexpr double k_chord_error = 0.01;

/// Makes polylines of shapes of SVG.
class SvgChords {
 public:
  /// @param to_mm from user units of the shape
  explicit SvgChords(const Affine& to_mm) : to_mm_(to_mm) {}

  void move_to(Vec2 p);
  void line_to(Vec2 p);
  void cubic_to(Vec2 c1, Vec2 c2, Vec2 p);
  void quadratic_to(Vec2 c, Vec2 p);
  /// @param turn of the ellipse's first axis, degrees
  void arc_to(Vec2 radii, double turn, bool large, bool sweep, Vec2 p);
  void close();

  /// Where the line is, user units.
  Vec2 at() const { return at_; }
  /// The polylines, millimetres; closed ones end in their first point, a single point is a dot.
  const std::vector<std::vector<Vec2>>& lines() const { return lines_; }
  /// Whether a curve would have too many chords, or a place is not finite.
  bool failed() const { return failed_; }

 private:
  void add(Vec2 mm);
  void add_curve(const Vec2 (&mm)[4]);

  Affine to_mm_;
  Vec2 at_, start_;
  bool closed_ = false;  // what follows begins a new line at the start of the last one
  bool failed_ = false;
  std::size_t points_ = 0;
  std::vector<std::vector<Vec2>> lines_;
};

/// Goes along the data of a path.
/// @return what is wrong with it; empty where nothing is
std::string add_path(std::string_view data, SvgChords& chords);

void add_ellipse(Vec2 middle, Vec2 radii, SvgChords& chords);

/// @param round radii of its corners, at most half its size
void add_rectangle(Vec2 corner, Vec2 size, Vec2 round, SvgChords& chords);

}  // namespace planish
