#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

#include <planish/core/vec.h>

namespace planish {

/// Numbers from 0 on in sets that grow together, each with whether it must be turned over to agree
/// with the smallest number of its set. (Disjoint sets that carry parity.)
class TurningSets {
 public:
  explicit TurningSets(std::size_t count) : parent_(count), turned_(count, 0) {
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }

  struct First {
    Index number;          ///< the smallest of the set
    unsigned char turned;  ///< relative to it
  };

  First first_of(Index number) {
    First result{number, 0};
    while (parent_[result.number] != result.number) {
      result.turned ^= turned_[result.number];
      result.number = parent_[result.number];
    }
    // Shorten the way for the next time.
    for (First at{number, result.turned}; parent_[at.number] != at.number;) {
      const Index next = parent_[at.number];
      const unsigned char rest = at.turned ^ turned_[at.number];
      parent_[at.number] = result.number;
      turned_[at.number] = at.turned;
      at = {next, rest};
    }
    return result;
  }

  /// Joins two numbers that agree (0) or clash (1); false where that contradicts what is known.
  bool join(Index a, Index b, unsigned char clash) {
    const First first_a = first_of(a), first_b = first_of(b);
    if (first_a.number == first_b.number) return (first_a.turned ^ first_b.turned) == clash;
    const auto [low, high] = std::minmax(first_a.number, first_b.number);
    parent_[high] = low;
    turned_[high] = first_a.turned ^ first_b.turned ^ clash;
    return true;
  }

 private:
  std::vector<Index> parent_;
  std::vector<unsigned char> turned_;
};

}  // namespace planish
