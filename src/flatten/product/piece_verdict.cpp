#include "flatten/product/piece_verdict.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string_view>
#include <utility>

#include "core/figure_text.h"
#include "core/number_text.h"
#include "flatten/outcome.h"
#include "flatten/strain_limit_text.h"
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
  const auto check = [&](std::string_view name, const auto& as_text, std::string_view scope = {}) {
    const TwoFigures figures = told_apart(limit.limit, limit.value, as_text);
    return PieceCheck{limit.what, limit.met, limit_words(name, figures, limit.met, scope)};
  };
  switch (limit.what) {
    case Criterion::deviation:
      return check("deviation limit", as_length);
    case Criterion::angle:
      return check("smallest-angle limit", degrees);
    case Criterion::e_max:
      return check("e_max target", radians);
    case Criterion::bending:
      return check("bending limit", ratio);
    default:
      return check(std::string(bounded_part(limit.what)) + " limit", percent,
                   limit.what == Criterion::rms_strain ? " rms"
                   : is_of_area(limit.what)            ? " on 99\u00A0% of the area"
                                                       : "");
  }
}

std::string flipped_text(std::size_t count) {
  return count_text(count) + (count == 1 ? " triangle is" : " triangles are") +
         " flipped over in the pattern";
}

/// What is wrong where something else than a limit is missed.
std::string miss_text(Criterion what, const FinishedPatch& finished) {
  switch (what) {
    case Criterion::rejected:
      return "evolving would have stretched the pattern more, to " +
             percent(finished.rejected->rms, 3) + " rms: the design was kept";
    case Criterion::size:
      return unit_question(finished.unfold);
    case Criterion::stretched:
      return "does not lie flat without stretch, and no limit was asked for";
    case Criterion::overlap:
      return "the pattern overlaps itself";
    case Criterion::flipped_triangles:
      return flipped_text(finished.unfold.pattern.flipped_triangles);
    default:
      break;
  }
  const auto& faults = finished.form_faults;
  const auto fault = std::find_if(faults.begin(), faults.end(),
                                  [&](const FormFault& some) { return some.what == what; });
  return fault == faults.end() ? std::string() : "the form " + fault->text;
}

}  // namespace

std::vector<PieceCheck> piece_checks(const PatchResult& piece) {
  if (piece.failure) return {{Criterion::failure, false, "failed: " + piece.failure->message}};
  if (!piece.finished) return {{Criterion::failure, false, "not done"}};
  const FinishedPatch& finished = *piece.finished;
  std::vector<PieceCheck> checks;
  for (const LimitCheck& limit : finished.limits)
    checks.push_back(check_of(limit, finished.unfold.unit));
  for (const Criterion what : finished.outcome().missed) {
    if (what > Criterion::bending) checks.push_back({what, false, miss_text(what, finished)});
  }
  std::stable_partition(checks.begin(), checks.end(),
                        [](const PieceCheck& check) { return !check.met; });
  return checks;
}

EdgeStrain largest_strain(const ProductReport& report) {
  constexpr std::array k_figures = {&EdgeStrain::max,
                                    &EdgeStrain::rms,
                                    &EdgeStrain::p99,
                                    &EdgeStrain::max_stretch,
                                    &EdgeStrain::p99_stretch,
                                    &EdgeStrain::max_compression,
                                    &EdgeStrain::p99_compression};
  EdgeStrain most;
  for (const PatchResult& piece : report.patches) {
    if (!piece.finished) continue;
    for (double EdgeStrain::*figure : k_figures)
      most.*figure = std::max(most.*figure, piece.finished->unfold.strain.*figure);
  }
  return most;
}

std::string product_verdict(const ProductReport& report) {
  const PatchResult* worst = nullptr;
  bool has_limits = false, is_changed = false;
  for (const PatchResult& piece : report.patches) {
    if (!piece.finished) continue;
    const std::vector<LimitCheck>& limits = piece.finished->limits;
    has_limits = has_limits || std::any_of(limits.begin(), limits.end(), [](const auto& limit) {
                   return is_of_strain(limit.what);
                 });
    is_changed = is_changed || piece.finished->deviation.max != 0.0;
    const double p99 = piece.finished->unfold.strain.p99;
    if (worst == nullptr || p99 > worst->finished->unfold.strain.p99) worst = &piece;
  }
  if (worst == nullptr) return {};
  std::string form = is_changed ? "" : "No form was changed.";
  if (has_limits) return form;
  const EdgeStrain most = largest_strain(report);
  const std::string sheet = is_too_small_to_measure(most)
                                ? "Every piece lies flat but for a stretch too small to measure"
                                : sheet_needed_text(most) + ". " + worst->name +
                                      " stretches most. No limit of stretch was given";
  return sheet + "." + (form.empty() ? "" : " " + form);
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
                        [&](std::size_t p) { return !report.patches[p].outcome().usable(); });
  return numbers;
}

}  // namespace planish
