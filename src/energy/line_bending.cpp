#include "energy/line_bending.h"

#include <utility>

#include "core/neumaier_sum.h"

namespace planish {

LineBending::LineBending(std::vector<SecondDifference> differences, double length)
    : differences_(std::move(differences)) {
  if (!differences_.empty())
    weight_ = 1.0 / (static_cast<double>(differences_.size()) * length * length);
}

double LineBending::value(const std::vector<Vec3>& moves) const {
  NeumaierSum sum;
  for (const SecondDifference& difference : differences_) {
    const Vec3 f = difference.of(moves);
    sum.add(weight_ * dot(f, f));
  }
  return sum.value();
}

}  // namespace planish
