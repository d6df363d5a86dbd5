#include <algorithm>
#include <string>
#include <vector>

#include "core/figure_text.h"
#include "core/likely_units.h"
#include "flatten/verdict.h"

namespace planish {

namespace {

// Millimetres: hulls and sails are longer than most pieces.
constexpr double k_absurdly_large = 20'000.0;

/// Of the pattern, millimetres.
double longer_side(const UnfoldReport& unfold) {
  return millimetres_per(unfold.unit) * std::max(unfold.pattern.width, unfold.pattern.height);
}

}  // namespace

bool is_absurdly_small(const UnfoldReport& unfold) {
  constexpr double smallest = 5.0;  // mm
  const double size = longer_side(unfold);
  return size > 0.0 && size < smallest;
}

std::string unit_question(const UnfoldReport& unfold) {
  const double size = longer_side(unfold);
  if (!is_absurdly_small(unfold) && size <= k_absurdly_large) return {};
  const std::string start = "The pattern is " + significant_text(size, 2) + "\u00A0mm long: is ";
  const std::vector<Unit> likely = likely_units(size / millimetres_per(unfold.unit), unfold.unit);
  if (likely.empty()) {
    return start + "the model's unit really " + std::string(to_string(unfold.unit)) + "?";
  }
  const std::string name(to_string(likely.front()));
  return start + "the model in " + name + "? Then give --unit " + name + ".";
}

}  // namespace planish
