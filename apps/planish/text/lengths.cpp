#include "text/lengths.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/likely_units.h"
#include "shell/text.h"

namespace planish::cli {

namespace {

/// "0.593 mm", "593 mm", "12.3 m"
std::string metric_text(double millimetres) {
  const bool in_metres = millimetres >= 10'000.0;
  const double shown = in_metres ? 0.001 * millimetres : millimetres;
  const bool has_digits = 100.0 <= shown && shown < 1e6;
  return (has_digits ? fixed(shown, 0) : digits(shown, 3)) + (in_metres ? " m" : " mm");
}

}  // namespace

ShownLengths::ShownLengths(double scale, std::string unit)
    : scale_(scale), unit_(std::move(unit)) {}

ShownLengths::ShownLengths(Unit unit)
    : ShownLengths(unit == Unit::in ? 1.0 : millimetres_per(unit),
                   std::string(to_string(unit == Unit::in ? Unit::in : Unit::mm))) {}

ShownLengths ShownLengths::in_model_units() {
  return {1.0, "model units"};
}

std::string ShownLengths::number(double length) const {
  const double shown = scale_ * length;
  const bool is_plain = 100.0 <= shown && shown < 1e6 && unit_ != "model units";
  return is_plain ? fixed(shown, 1) : digits(shown, 3);
}

std::string ShownLengths::thickness_text(double length) const {
  const double shown = scale_ * length;
  return (shown < 1.0 ? digits(shown, 2) : fixed(shown, 1)) + " " + unit_;
}

std::optional<std::string> unusual_size_text(const Pattern& pattern, Unit unit) {
  const double longest = std::max(pattern.width, pattern.height);
  const double millimetres = longest * millimetres_per(unit);
  const bool is_usual = k_small_piece <= millimetres && millimetres <= k_large_piece;
  if (is_usual || !(millimetres > 0.0)) return std::nullopt;
  std::string text = "the pattern is " + metric_text(millimetres) + " long";
  std::string others;
  for (const Unit likely : likely_units(longest, unit)) {
    others += (others.empty() ? "with " : ", with ") + std::string("--unit ") +
              std::string(to_string(likely)) + " it would be " +
              metric_text(longest * millimetres_per(likely));
  }
  return text + (others.empty() ? "; if the mesh is not in " + std::string(to_string(unit)) +
                                      ", give its unit with --unit"
                                : "; " + others);
}

}  // namespace planish::cli
