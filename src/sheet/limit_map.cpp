#include "sheet/limit_map.h"

#include <algorithm>
#include <cmath>

#include <planish/draw/color.h>

#include "core/number_text.h"
#include "flatten/strain_limit_text.h"

namespace planish {

namespace {

constexpr int k_within = k_limit_bands - 1;  // bands up to the limit

}  // namespace

double MapLimit::weight_of_stretch() const {
  constexpr double all = 1e6;  // where compression has no limit
  if (stretch == compression) return 1.0;
  return compression < k_no_limit ? compression / stretch : all;
}

std::optional<MapLimit> limit_of_edges(std::span<const LimitCheck> checks) {
  const LimitCheck* stretch = nullptr;
  const LimitCheck* compression = nullptr;
  const auto look = [](const LimitCheck*& smallest, const LimitCheck& check) {
    if (smallest == nullptr || check.limit < smallest->limit) smallest = &check;
  };
  for (const LimitCheck& check : checks) {
    if (check.what == Criterion::rms_strain) continue;
    if (bounded_part(check.what) != "compression") look(stretch, check);
    if (bounded_part(check.what) != "stretch") look(compression, check);
  }
  if (stretch == nullptr && compression == nullptr) return std::nullopt;
  MapLimit limit;
  if (stretch != nullptr) limit.stretch = stretch->limit;
  if (compression != nullptr) limit.compression = compression->limit;
  limit.words = limit_words(stretch != nullptr ? *stretch : *compression);
  if (stretch != nullptr && compression != nullptr && stretch != compression)
    limit.words += ", and " + limit_words(*compression);
  return limit;
}

std::string limit_words(const LimitCheck& limit) {
  return fixed_text(100.0 * limit.limit, 6) + " %" + side_words(limit.what) +
         (limit.what == Criterion::rms_strain ? ", rms"
          : is_of_area(limit.what)            ? ", on 99 % of the area"
                                              : ", for every edge");
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
