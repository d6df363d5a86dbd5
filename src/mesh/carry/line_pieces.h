#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "mesh/carry/place_on_triangle.h"

namespace planish {

/// Collects the parts of drawn lines that lie on a mesh.
class LinePieces {
 public:
  /// Goes on to a place on the triangle of the last one, or begins a part.
  void add(const PlaceOnTriangle& place) {
    open_.push_back(place);
    ++count_;
  }

  /// Ends the part; a single place is none.
  void end() {
    if (open_.size() > 1) pieces_.push_back(std::move(open_));
    open_.clear();
  }

  /// Makes the parts from number `first` on those of a closed line: where the mesh holds both its
  /// ends, which are one place, the last part goes on to the first.
  /// @param are_one whether two places are the same
  template <class AreOne>
  void close(std::size_t first, const AreOne& are_one) {
    if (pieces_.size() <= first) return;
    std::vector<PlaceOnTriangle>&begin = pieces_[first], &last = pieces_.back();
    if (!are_one(begin.front(), last.back())) return;
    last.back() = begin.front();
    if (pieces_.size() == first + 1) return;
    last.insert(last.end(), begin.begin() + 1, begin.end());
    pieces_.erase(pieces_.begin() + static_cast<std::ptrdiff_t>(first));
  }

  /// Ends the part as the line leaves the mesh.
  void leave(double length) {
    end();
    outside_ += length;
  }

  bool is_open() const { return !open_.empty(); }
  const PlaceOnTriangle& last() const { return open_.back(); }
  std::size_t count() const { return count_; }
  double outside() const { return outside_; }
  const std::vector<std::vector<PlaceOnTriangle>>& pieces() const { return pieces_; }

 private:
  std::vector<std::vector<PlaceOnTriangle>> pieces_;
  std::vector<PlaceOnTriangle> open_;
  std::size_t count_ = 0;
  double outside_ = 0.0;
};

}  // namespace planish
