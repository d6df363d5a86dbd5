#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include <planish/core/vec.h>

#include "io/file/text_cursor.h"

namespace planish {

/// The spacing of 32-bit floats at the largest coordinate of places.
double step_of_floats(std::span<const Vec3> places);

/// The same where every coordinate is a 32-bit float that was written with more digits, and some
/// use the last of its own; else 0.
double step_of_widened_floats(std::span<const Vec3> places);

/// Finds out to how many decimals a text has its coordinates, from some of its vertices.
class DecimalSteps {
 public:
  /// Whether to add the coordinates of a vertex: all would cost time, and tell no more.
  static bool wants(std::size_t vertex) { return vertex < 256 || vertex % 64 == 0; }

  /// Adds the next three words.
  /// @param ahead a copy of the cursor of the reader
  void add(TextCursor ahead);

  /// The largest of the steps of the axes, each where its coordinates are largest: a power of ten.
  /// 0 where nothing shows that digits are missing: where they have as many as a double holds, or
  /// end as those of a design do, on the same few digits.
  double step() const;

 private:
  void add(std::size_t axis, std::string_view word);

  /// Of the numbers of the largest power of ten so far.
  struct Axis {
    int power = -1000;         ///< of the first digit
    int decimals = -1000;      ///< the most of a number
    unsigned last_digits = 0;  ///< a bit for each that numbers with so many decimals end on
  };
  std::array<Axis, 3> axes_;
};

}  // namespace planish
