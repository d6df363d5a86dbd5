#include "flatten/strain_limit_text.h"

#include <charconv>

namespace planish {

namespace {

std::string rounded(double value, int digits) {
  char text[40];
  const auto end =
      std::to_chars(text, text + sizeof text, value, std::chars_format::general, digits).ptr;
  return {text, end};
}

std::string percent(double share, int digits) {
  return rounded(100.0 * share, digits) + " %";
}

/// So many digits that limit and strain do not read the same where one is above the other.
int digits_for(double limit, double strain) {
  int digits = 3;
  while (strain > limit && digits < 16 && rounded(strain, digits) == rounded(limit, digits))
    ++digits;
  return digits;
}

std::string place_text(const LimitCheck& check) {
  return "from vertex " + std::to_string(check.edge[0]) + " to " + std::to_string(check.edge[1]) +
         ", near (" + rounded(check.at.x, 4) + ", " + rounded(check.at.y, 4) + ", " +
         rounded(check.at.z, 4) + ")";
}

}  // namespace

std::string_view bounded_part(Criterion what) {
  const std::string_view name = to_string(what);
  for (const std::string_view part : {"stretch", "compression"}) {
    if (name.ends_with(part)) return part;
  }
  return "strain";
}

std::string side_words(Criterion what) {
  const std::string part(bounded_part(what));
  return part == "strain" ? "" : " of " + part;
}

std::string scope_words(Criterion what) {
  if (what == Criterion::rms_strain) return " (rms)";
  return is_of_area(what) ? " on 99 % of the area" : "";
}

bool is_of_area(Criterion what) {
  return to_string(what).starts_with("p99");
}

std::string strain_limit_text(const LimitCheck& check) {
  const int digits = digits_for(check.limit, check.value);
  const bool is_rms = check.what == Criterion::rms_strain;
  std::string text =
      "The limit of " + percent(check.limit, digits) + " for the " +
      (is_rms ? "rms of the strain"
              : std::string(bounded_part(check.what)) +
                    (is_of_area(check.what) ? " on 99 % of the area" : " of every edge")) +
      (check.met ? " is kept" : " is not kept") + ": the pattern has " +
      percent(check.value, digits);
  if (check.met || is_rms) return text + ".";
  return text + ", most at the edge " + place_text(check) + "; " + percent(check.share_beyond, 2) +
         " of the area is beyond the limit.";
}

std::string strain_limits_text(std::span<const LimitCheck> checks) {
  std::string text;
  for (const LimitCheck& check : checks)
    text += (text.empty() ? "" : " ") + strain_limit_text(check);
  return text;
}

}  // namespace planish
