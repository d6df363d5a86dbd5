#pragma once

#include <cmath>

namespace planish {

/// Sums with the rounding errors carried along (Neumaier): as if the sum were made in twice the
/// digits, so that energies of successive sweeps can be compared to the last digit.
class NeumaierSum {
 public:
  void add(double x) {
    const double total = sum_ + x;
    lost_ += std::abs(sum_) >= std::abs(x) ? (sum_ - total) + x : (x - total) + sum_;
    sum_ = total;
  }
  void add(const NeumaierSum& other) {
    add(other.sum_);
    lost_ += other.lost_;
  }
  double value() const { return sum_ + lost_; }

 private:
  double sum_ = 0.0, lost_ = 0.0;
};

}  // namespace planish
