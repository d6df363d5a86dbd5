#pragma once

#include <cstddef>
#include <cstdint>

namespace planish {

/// Numbers that look random and are the same everywhere: splitmix64 (Steele, Lea and Flood, *Fast
/// splittable pseudorandom number generators*, 2014).
class SplitMix {
 public:
  explicit SplitMix(std::uint64_t seed = 0) : state_(seed) {}

  /// What is added to the state for each number.
  static constexpr std::uint64_t k_step = 0x9e3779b97f4a7c15U;

  /// Every bit of the result depends on every bit of z.
  static constexpr std::uint64_t mixed(std::uint64_t z) {
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
  }
  /// From 0 to 1, 1 excluded.
  static constexpr double as_share(std::uint64_t z) {
    return static_cast<double>(z >> 11U) * 0x1p-53;
  }

  std::size_t below(std::size_t count) { return static_cast<std::size_t>(next() % count); }
  double share() { return as_share(next()); }

 private:
  std::uint64_t next() { return mixed(state_ += k_step); }

  std::uint64_t state_;
};

}  // namespace planish
