#pragma once

#include <string>
#include <vector>

namespace planish {

/// A tick of an axis and what it says, UTF-8.
struct Tick {
  double value;
  std::string text;
};

/// A logarithmic axis that begins and ends at a tick.
struct LogAxis {
  double low, high;
  std::vector<Tick> ticks;  ///< increasing, two at least

  /// The share of the way from low to high, 0 to 1.
  double place_of(double value) const;
};

/// An axis over [low, high], both positive, with about three to eight ticks: powers of ten where
/// the range is wide, 1, 2 and 5 times these where it is less, evenly spaced numbers where it is
/// narrow.
LogAxis log_axis(double low, double high);

}  // namespace planish
