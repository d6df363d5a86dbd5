#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace planish {

/// Numbers from 0 on in sets that grow together. A set is known by its smallest number.
template <class Number>
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) {
    parent_.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
      parent_.push_back(static_cast<Number>(i));
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
