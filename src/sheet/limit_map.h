#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>

#include <planish/draw/color.h>
#include <planish/sheet/pattern_sheet.h>
#include <planish/unfold/strain.h>

namespace planish {

/// Bands of a map of the limit used up: ten of 10 % each, and one for what is beyond the limit.
inline constexpr int k_limit_bands = 11;

/// The limits that maps show strain beside, shares of length; infinite where there is none.
struct MapLimit {
  double stretch = k_no_limit, compression = k_no_limit;
  std::string words = {};  ///< "5 %, for every edge"

  static constexpr double k_no_limit = std::numeric_limits<double>::infinity();
  /// That of this strain.
  double of(double strain) const { return strain < 0.0 ? stretch : compression; }
  /// How much of its limit a stretch uses up, in units of a compression of the same size.
  double weight_of_stretch() const;
};

/// Of the limits for single edges, for every one or for those on 99 % of the area, the smaller.
/// Nothing where there is none; a limit of the rms is for no place.
std::optional<MapLimit> limit_of_edges(std::span<const LimitCheck> checks);

/// The limit in words: "5 %, for every edge".
std::string limit_words(const LimitCheck& limit);

/// The band of a strain, 0 to 10; the last exactly where its size is above its limit. NaN counts as
/// no strain.
int limit_band(double strain, const MapLimit& limit);

/// The colour of a band: the pale map's at its middle, and k_beyond_limit.
Color limit_band_color(int band);

}  // namespace planish
