#pragma once

#include <optional>
#include <string>

#include <planish/core/unit.h>
#include <planish/unfold/unfold.h>

namespace planish::cli {

/// Lengths on the model as people read them.
class ShownLengths {
 public:
  /// In inches of a mesh in inches, else in mm.
  explicit ShownLengths(Unit unit);

  /// In model units, for verbs that do not know what these are.
  static ShownLengths in_model_units();

  /// Digits that make sense of a piece for cutting: "593.2", "7.77".
  /// @param length model units
  std::string number(double length) const;
  /// "mm", "in" or "model units"
  const std::string& unit() const { return unit_; }
  /// A thickness, in tenths: "2.0 mm"; with two digits below one.
  std::string thickness_text(double length) const;
  /// "7.77 mm"
  std::string text(double length) const { return number(length) + " " + unit_; }

 private:
  ShownLengths(double scale, std::string unit);

  double scale_;
  std::string unit_;
};

/// What to say of a pattern whose longer side is below 5 cm or above 5 m, as where the unit of the
/// mesh is not the one meant: its size, and units under which it would lie between. Nothing of
/// other patterns.
std::optional<std::string> unusual_size_text(const Pattern& pattern, Unit unit);

}  // namespace planish::cli
