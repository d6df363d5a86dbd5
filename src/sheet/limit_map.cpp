#include "sheet/limit_map.h"

#include <algorithm>
#include <cmath>

#include <planish/draw/color.h>

#include "core/number_text.h"

namespace planish {

namespace {

constexpr int k_within = k_limit_bands - 1;  // bands up to the limit

bool is_of_stretch(StrainLimitKind kind) {
  return kind == StrainLimitKind::max_stretch || kind == StrainLimitKind::p99_stretch;
}

bool is_of_compression(StrainLimitKind kind) {
  return kind == StrainLimitKind::max_compression || kind == StrainLimitKind::p99_compression;
}

}  // namespace

double MapLimit::weight_of_stretch() const {
  constexpr double all = 1e6;  // where compression has no limit
  if (stretch == compression) return 1.0;
  return compression < k_no_limit ? compression / stretch : all;
}

std::optional<MapLimit> limit_of_edges(std::span<const StrainLimitCheck> checks) {
  const StrainLimitCheck* stretch = nullptr;
  const StrainLimitCheck* compression = nullptr;
  const auto look = [](const StrainLimitCheck*& smallest, const StrainLimitCheck& check) {
    if (smallest == nullptr || check.asked < smallest->asked) smallest = &check;
  };
  for (const StrainLimitCheck& check : checks) {
    if (check.kind == StrainLimitKind::rms) continue;
    if (!is_of_compression(check.kind)) look(stretch, check);
    if (!is_of_stretch(check.kind)) look(compression, check);
  }
  if (stretch == nullptr && compression == nullptr) return std::nullopt;
  MapLimit limit;
  if (stretch != nullptr) limit.stretch = stretch->asked;
  if (compression != nullptr) limit.compression = compression->asked;
  limit.words = limit_words(stretch != nullptr ? *stretch : *compression);
  if (stretch != nullptr && compression != nullptr && stretch != compression)
    limit.words += ", and " + limit_words(*compression);
  return limit;
}

std::string limit_words(const StrainLimitCheck& limit) {
  std::string share = fixed_text(100.0 * limit.asked, 6) + " %" +
                      (is_of_stretch(limit.kind)       ? " of stretch"
                       : is_of_compression(limit.kind) ? " of compression"
                                                       : "");
  switch (limit.kind) {
    case StrainLimitKind::max:
    case StrainLimitKind::max_stretch:
    case StrainLimitKind::max_compression:
      return share + ", for every edge";
    case StrainLimitKind::p99:
    case StrainLimitKind::p99_stretch:
    case StrainLimitKind::p99_compression:
      return share + ", on 99 % of the area";
    case StrainLimitKind::rms:
      return share + ", rms";
  }
  return share;
}

int limit_band(double strain, const MapLimit& limit) {
  const double size = std::abs(strain), most = limit.of(strain);
  if (size > most) return k_within;
  const double share = size / most;
  if (std::isnan(share)) return 0;
  return std::min(static_cast<int>(k_within * share), k_within - 1);
}

Color limit_band_color(int band) {
  if (band >= k_within) return k_beyond_limit;
  return color_at(ColorMap::pale, (band + 0.5) / k_within);
}

}  // namespace planish
