#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace planish {

/// The order around closed loops whose places lie in one list, a loop behind the other.
class LoopOrder {
 public:
  LoopOrder() = default;

  /// @param sizes how many places each loop has
  explicit LoopOrder(std::span<const std::size_t> sizes) {
    for (const std::size_t size : sizes) {
      const std::size_t begin = next_.size();
      begins_.push_back(begin);
      for (std::size_t k = 0; k < size; ++k) {
        next_.push_back(begin + (k + 1) % size);
        previous_.push_back(begin + (k + size - 1) % size);
      }
    }
    begins_.push_back(next_.size());
  }

  std::size_t size() const { return next_.size(); }
  std::size_t count() const { return begins_.size() - 1; }
  std::size_t next(std::size_t k) const { return next_[k]; }
  std::size_t previous(std::size_t k) const { return previous_[k]; }
  /// The places of a loop are from begin() to end().
  std::size_t begin(std::size_t loop) const { return begins_[loop]; }
  std::size_t end(std::size_t loop) const { return begins_[loop + 1]; }

 private:
  std::vector<std::size_t> next_, previous_, begins_;
};

}  // namespace planish
