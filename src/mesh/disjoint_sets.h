#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace planish {

/// Numbers from 0 on in sets that grow together. A set is known by its smallest number.
template <class Number>
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), Number{0});
  }
  /// The smallest number of the set.
  Number first_of(Number number) {
    while (parent_[number] != number)
      number = parent_[number] = parent_[parent_[number]];
    return number;
  }
  void join(Number a, Number b) {
    const auto [low, high] = std::minmax({first_of(a), first_of(b)});
    parent_[high] = low;
  }

 private:
  std::vector<Number> parent_;
};

}  // namespace planish
