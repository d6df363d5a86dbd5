#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <planish/core/vec.h>

#include "core/split_mix.h"

namespace planish {

/// Gives positions that are exactly equal one number, in the order of first use. -0.0 equals 0.0,
/// as it does everywhere else. A hash table with open addressing, at most half full.
class Welder {
 public:
  Welder() : slots_(1024, k_free) {}

  std::size_t size() const { return positions_.size(); }
  std::vector<Vec3> take() { return std::move(positions_); }

  /// The number of the vertex at a finite position.
  Index vertex(Vec3 position) {
    Index& slot = slot_of(position);
    if (slot != k_free) return slot;
    const auto added = static_cast<Index>(positions_.size());
    slot = added;
    positions_.push_back(position);
    if (2 * positions_.size() > slots_.size()) grow();
    return added;
  }

 private:
  static constexpr Index k_free = std::numeric_limits<Index>::max();

  Index& slot_of(Vec3 position) {
    const std::size_t mask = slots_.size() - 1;
    std::size_t at = hash(position) & mask;
    while (slots_[at] != k_free && positions_[slots_[at]] != position)
      at = (at + 1) & mask;
    return slots_[at];
  }

  std::uint64_t hash(Vec3 p) const {
    std::uint64_t h = seed_;
    for (const double c : {p.x, p.y, p.z})
      h = SplitMix::mixed(h ^ (c == 0.0 ? 0 : std::bit_cast<std::uint64_t>(c)));
    return h;
  }

  void grow() {
    slots_.assign(2 * slots_.size(), k_free);
    for (std::size_t i = 0; i < positions_.size(); ++i) {
      slot_of(positions_[i]) = static_cast<Index>(i);
    }
  }

  std::vector<Index> slots_;
  std::vector<Vec3> positions_;
  /// Differs from run to run where the system shuffles addresses, so that no file can be made in
  /// which all positions collide. Results do not depend on it.
  std::uint64_t seed_ = reinterpret_cast<std::uintptr_t>(slots_.data());
};

}  // namespace planish
