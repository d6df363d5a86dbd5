#pragma once

// Options of methods, anywhere in their ranges, from bytes.

#include <cmath>
#include <string_view>

#include <planish/core/range.h>
#include <planish/evolve/method.h>

#include "fuzz/bytes.h"

namespace planish::fuzz {

/// For describe(): about every other option gets a value, the others keep their own.
struct OptionFiller {
  Bytes& bytes;
  double most_whole = 8.0;  ///< numbers of steps are kept small, for time

  void operator()(std::string_view, double& value, const char*, Range range) const {
    if (!bytes.flag()) return;
    const double drawn = bytes.within(range.min, range.max);
    if (!std::isnan(drawn)) value = drawn;
  }
  void operator()(std::string_view, int& value, const char*, Range range) const {
    if (!bytes.flag()) return;
    value =
        static_cast<int>(bytes.whole(static_cast<std::size_t>(range.min),
                                     static_cast<std::size_t>(std::fmin(range.max, most_whole))));
  }
  void operator()(std::string_view, BorderFreedom& border, const char*) const {
    constexpr double most_distance = 1e3;
    if (!bytes.flag()) return;
    border.rule = bytes.flag() ? BorderFreedom::Rule::slide : BorderFreedom::Rule::within;
    border.distance = bytes.within(0.0, most_distance);
  }
  template <class Enum>
  void operator()(std::string_view, Enum& value, const char*) const {
    const auto& names = names_of(value);
    value = names[bytes.whole(0, names.size() - 1)].first;
  }
};

}  // namespace planish::fuzz
