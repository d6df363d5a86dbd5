#include "flatten/product/piece_verdict.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string_view>
#include <utility>

#include "core/figure_text.h"
#include "core/number_text.h"
#include "flatten/verdict.h"

namespace planish {

namespace {

/// A value beside its limit, which must not read the same where one is beyond the other.
struct TwoFigures {
  std::string limit, value;
};

template <class AsText>
TwoFigures told_apart(double limit, double value, const AsText& as_text) {
  constexpr int k_usual = 3, k_most = 15;
  int digits = k_usual;
  const bool is_rounding = std::abs(limit - value) <= 1e-9 * std::abs(limit);
  while (!is_rounding && limit != value && digits < k_most &&
         as_text(limit, digits) == as_text(value, digits))
    ++digits;
  return {as_text(limit, digits), as_text(value, digits)};
}

/// Without zeros at the end: a limit reads as it was typed.
std::string short_number(double value, int digits) {
  std::string text = significant_text(value, digits);
  if (text.find('.') == std::string::npos || text.find("\u00D7") != std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string percent(double share, int digits) {
  constexpr double not_measurable = 1e-6;
  if (std::abs(share) < not_measurable) share = 0.0;
  return short_number(100.0 * share, digits) + "\u00A0%";
}

std::string limit_words(std::string_view name, const TwoFigures& figures, bool met,
                        std::string_view scope = {}) {
  return std::string(name) + " of " + figures.limit + std::string(scope) +
         (met ? " kept: " : " missed: ") + figures.value;
}

/// In millimetres, or inches of a model in inches.
std::string length(double value, int digits, Unit unit) {
  if (unit == Unit::in) return short_number(value, digits) + "\u00A0in";
  return short_number(millimetres_per(unit) * value, digits) + "\u00A0mm";
}

PieceCheck check_of(const LimitCheck& limit, Unit unit) {
  const auto as_length = [unit](double value, int digits) { return length(value, digits, unit); };
  const auto degrees = [](double value, int digits) { return short_number(value, digits) + "°"; };
  const auto radians = [](double value, int digits) {
    return short_number(value, digits) + "\u00A0rad";
  };
  const auto ratio = [](double value, int digits) { return short_number(value, digits); };
  const auto check = [&](PieceCheckOf what, std::string_view name, const auto& as_text,
                         std::string_view scope = {}) {
    const TwoFigures figures = told_apart(limit.limit, limit.value, as_text);
    return PieceCheck{what, limit.met, limit_words(name, figures, limit.met, scope)};
  };
  switch (limit.what) {
    case LimitOf::strain:
      return check(PieceCheckOf::strain, "strain limit", percent);
    case LimitOf::p99_strain:
      return check(PieceCheckOf::strain, "strain limit", percent, " on 99\u00A0% of the area");
    case LimitOf::rms_strain:
      return check(PieceCheckOf::strain, "strain limit", percent, " rms");
    case LimitOf::deviation:
      return check(PieceCheckOf::deviation, "deviation limit", as_length);
    case LimitOf::angle:
      return check(PieceCheckOf::angle, "smallest-angle limit", degrees);
    case LimitOf::defect:
      return check(PieceCheckOf::defect, "e_max target", radians);
    case LimitOf::bending:
      return check(PieceCheckOf::bending, "bending limit", ratio);
  }
  return {};
}

/// Without a limit of strain, a changed surface is to lie flat.
void add_stretch(const FinishedPatch& finished, std::vector<PieceCheck>& checks) {
  const bool has_limit = std::any_of(checks.begin(), checks.end(), [](const PieceCheck& check) {
    return check.what == PieceCheckOf::strain || check.what == PieceCheckOf::rejected;
  });
  const EdgeStrain& strain = finished.unfold.strain;
  if (has_limit || finished.deviation.max == 0.0 || is_too_small_to_measure(strain)) return;
  checks.push_back({PieceCheckOf::strain, false,
                    "does not lie flat without stretch, and no limit was asked for"});
}

void add_faults(const Pattern& pattern, std::vector<PieceCheck>& checks) {
  if (pattern.overlaps)
    checks.push_back({PieceCheckOf::overlap, false, "the pattern overlaps itself"});
  const std::size_t flipped = pattern.flipped_triangles;
  if (flipped == 0) return;
  checks.push_back({PieceCheckOf::flipped_triangles, false,
                    count_text(flipped) + (flipped == 1 ? " triangle is" : " triangles are") +
                        " flipped over in the pattern"});
}

}  // namespace

std::string_view to_string(PieceCheckOf what) {
  switch (what) {
    case PieceCheckOf::failure:
      return "failure";
    case PieceCheckOf::rejected:
      return "rejected";
    case PieceCheckOf::strain:
      return "strain";
    case PieceCheckOf::deviation:
      return "deviation";
    case PieceCheckOf::angle:
      return "angle";
    case PieceCheckOf::defect:
      return "defect";
    case PieceCheckOf::bending:
      return "bending";
    case PieceCheckOf::form:
      return "form";
    case PieceCheckOf::overlap:
      return "overlap";
    case PieceCheckOf::flipped_triangles:
      return "flipped_triangles";
    case PieceCheckOf::size:
      return "size";
  }
  return {};
}

std::vector<PieceCheck> piece_checks(const PatchResult& piece) {
  if (piece.failure) return {{PieceCheckOf::failure, false, "failed: " + piece.failure->message}};
  if (!piece.finished) return {{PieceCheckOf::failure, false, "not done"}};
  const FinishedPatch& finished = *piece.finished;
  std::vector<PieceCheck> checks;
  if (is_absurdly_small(finished.unfold))
    checks.push_back({PieceCheckOf::size, false, unit_question(finished.unfold)});
  if (finished.rejected) {
    checks.push_back({PieceCheckOf::rejected, false,
                      "evolving would have stretched the pattern more, to " +
                          percent(finished.rejected->rms, 3) + " rms: the design was kept"});
  }
  for (const LimitCheck& limit : finished.limits)
    checks.push_back(check_of(limit, finished.unfold.unit));
  add_stretch(finished, checks);
  if (!finished.form_faults.empty())
    checks.push_back({PieceCheckOf::form, false, "the form " + finished.form_faults});
  add_faults(finished.unfold.pattern, checks);
  std::stable_partition(checks.begin(), checks.end(),
                        [](const PieceCheck& check) { return !check.met; });
  return checks;
}

bool is_met(const PatchResult& piece) {
  const std::vector<PieceCheck> checks = piece_checks(piece);
  return std::all_of(checks.begin(), checks.end(),
                     [](const PieceCheck& check) { return check.met; });
}

std::string near_borders_name(const ProductReport& report, const NearBorders& near) {
  const std::string& first = report.patches[near.patches[0]].name;
  if (near.patches[0] == near.patches[1]) return "two sides of " + first;
  return first + " - " + report.patches[near.patches[1]].name;
}

std::string easing_text(const ProductReport& report, const MeasuredSeam& seam) {
  const auto side_name = [&](std::size_t side) {
    const auto& sides = seam.seam.sides;
    if (sides[0].patch == sides[1].patch)
      return std::string(side == 0 ? "the first side" : "the second side");
    return report.patches[sides[side].patch].name;
  };
  const auto words = [&](const std::optional<std::size_t>& longer, double difference) {
    if (!longer) return std::string();
    return side_name(*longer) + " is " + decimals_text(difference, 2) + "\u00A0mm longer";
  };
  const std::string in_pattern = words(seam.longer(), seam.difference().value_or(0.0));
  const std::string on_model = words(seam.longer_on_model(), seam.difference_on_model());
  if (in_pattern.empty()) return on_model.empty() ? "" : on_model + " on the model";
  if (in_pattern == on_model) return in_pattern + " in the pattern and on the model";
  return in_pattern + " in the pattern" +
         (on_model.empty() ? "" : "; " + on_model + " on the model");
}

std::vector<std::size_t> missed_first(const ProductReport& report) {
  std::vector<std::size_t> numbers(report.patches.size());
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  const auto failed = std::stable_partition(
      numbers.begin(), numbers.end(), [&](std::size_t p) { return !report.patches[p].finished; });
  std::stable_partition(failed, numbers.end(),
                        [&](std::size_t p) { return !is_met(report.patches[p]); });
  return numbers;
}

}  // namespace planish
