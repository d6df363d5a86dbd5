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

std::string place_text(const StrainLimitCheck& check) {
  return "from vertex " + std::to_string(check.edge[0]) + " to " + std::to_string(check.edge[1]) +
         ", near (" + rounded(check.at.x, 4) + ", " + rounded(check.at.y, 4) + ", " +
         rounded(check.at.z, 4) + ")";
}

/// What the limit is for, and what the pattern has of that.
std::string_view scope_of(StrainLimitKind kind) {
  switch (kind) {
    case StrainLimitKind::max:
      return "the strain of every edge";
    case StrainLimitKind::p99:
      return "the strain on 99 % of the area";
    case StrainLimitKind::rms:
      return "the rms of the strain";
    case StrainLimitKind::max_stretch:
      return "the stretch of every edge";
    case StrainLimitKind::p99_stretch:
      return "the stretch on 99 % of the area";
    case StrainLimitKind::max_compression:
      return "the compression of every edge";
    case StrainLimitKind::p99_compression:
      return "the compression on 99 % of the area";
  }
  return {};
}

}  // namespace

std::string strain_limit_text(const StrainLimitCheck& check) {
  const int digits = digits_for(check.asked, check.reached);
  std::string text = "The limit of " + percent(check.asked, digits) + " for " +
                     std::string(scope_of(check.kind)) +
                     (check.kept() ? " is kept" : " is not kept") + ": the pattern has " +
                     percent(check.reached, digits);
  if (check.kept() || check.kind == StrainLimitKind::rms) return text + ".";
  return text + ", most at the edge " + place_text(check) + "; " + percent(check.share_beyond, 2) +
         " of the area is beyond the limit.";
}

std::string strain_limits_text(std::span<const StrainLimitCheck> checks) {
  std::string text;
  for (const StrainLimitCheck& check : checks)
    text += (text.empty() ? "" : " ") + strain_limit_text(check);
  return text;
}

}  // namespace planish
