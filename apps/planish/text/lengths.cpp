#include "text/lengths.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "shell/text.h"

namespace planish::cli {

namespace {

// Of the longer side of a pattern, in mm.
constexpr double k_small_pattern = 50.0;
constexpr double k_large_pattern = 5'000.0;

/// The likeliest first: programs that model in other units than mm mostly do so in m.
constexpr std::array k_likely_units = {Unit::m, Unit::cm, Unit::dm, Unit::in, Unit::mm};

bool is_usual(double millimetres) {
  return k_small_pattern <= millimetres && millimetres <= k_large_pattern;
}

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

std::optional<std::string> unusual_size_text(const Pattern& pattern, Unit unit) {
  const double longest = std::max(pattern.width, pattern.height);
  const double millimetres = longest * millimetres_per(unit);
  if (is_usual(millimetres) || !(millimetres > 0.0)) return std::nullopt;
  std::string text = "the pattern is " + metric_text(millimetres) + " long";
  std::string others;
  for (const Unit likely : k_likely_units) {
    const double length = longest * millimetres_per(likely);
    if (likely == unit || !is_usual(length)) continue;
    others += (others.empty() ? "with " : ", with ") + std::string("--unit ") +
              std::string(to_string(likely)) + " it would be " + metric_text(length);
  }
  return text + (others.empty() ? "; if the mesh is not in " + std::string(to_string(unit)) +
                                      ", give its unit with --unit"
                                : "; " + others);
}

}  // namespace planish::cli
