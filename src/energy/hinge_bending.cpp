#include "energy/hinge_bending.h"

#include <cmath>

#include <planish/measure/fairness.h>

#include "core/math.h"
#include "core/neumaier_sum.h"

namespace planish {

namespace {

constexpr std::size_t k_hinge_grain = 2048;

/// The edge and the normals of its two triangles, each twice the area long.
struct Frame {
  Vec3 edge, left, right;
};

Frame frame_of(const std::array<Index, 4>& stencil, const std::vector<Vec3>& x) {
  const Vec3 from = x[stencil[0]];
  const Vec3 edge = x[stencil[1]] - from;
  return {edge, cross(edge, x[stencil[2]] - from), cross(x[stencil[3]] - from, edge)};
}

/// Between the normals, positive where it is a valley seen from outside.
double angle_of(const Frame& frame) {
  const double sine = dot(cross(frame.right, frame.left), frame.edge) / norm(frame.edge);
  const double cosine = dot(frame.left, frame.right);
  return sine == 0.0 && cosine == 0.0 ? 0.0 : math::atan2(sine, cosine);
}

}  // namespace

HingeBending::HingeBending(const Patch& design, const std::vector<Vec3>& origin, double b0)
    : b0_(b0) {
  for (const Hinge& hinge : hinges_of(design)) {
    hinges_.push_back({hinge.from, hinge.to, hinge.left, hinge.right});
    first_angles_.push_back(angle_of(frame_of(hinges_.back(), origin)));
  }
  weights_.resize(hinges_.size());
}

void HingeBending::set_weights(const std::vector<Vec3>& x, ThreadPool& pool) {
  pool.for_ranges(size(), k_hinge_grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t h = begin; h < end; ++h) {
      const Frame frame = frame_of(hinges_[h], x);
      const double areas = 0.5 * (norm(frame.left) + norm(frame.right));
      weights_[h] = areas > 0.0 ? 3.0 * dot(frame.edge, frame.edge) / areas : 0.0;
    }
  });
}

double HingeBending::value(const std::vector<Vec3>& x, ThreadPool& pool, double kept) const {
  std::vector<double> parts(size());
  pool.for_ranges(size(), k_hinge_grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t h = begin; h < end; ++h) {
      const double t = angle_of(frame_of(hinges_[h], x)) - kept * first_angles_[h];
      parts[h] = weights_[h] * t * t;
    }
  });
  NeumaierSum sum;
  for (const double part : parts)
    sum.add(part);
  return sum.value() / b0_;
}

Summand<4> HingeBending::summand(std::size_t hinge, const std::vector<Vec3>& x, double kept) const {
  const auto& stencil = hinges_[hinge];
  const Frame frame = frame_of(stencil, x);
  const double left = dot(frame.left, frame.left), right = dot(frame.right, frame.right);
  const double square = dot(frame.edge, frame.edge);
  if (!(left > 0.0) || !(right > 0.0)) return {stencil};
  const double length = std::sqrt(square);
  // A tip that rises along its normal lessens the angle by the distance over its height.
  const Vec3 of_left = (length / left) * frame.left, of_right = (length / right) * frame.right;
  const Vec3 from = x[stencil[0]];
  const double foot_left = dot(x[stencil[2]] - from, frame.edge) / square;
  const double foot_right = dot(x[stencil[3]] - from, frame.edge) / square;
  const double weight = 2.0 * weights_[hinge] / b0_;
  const double turned = angle_of(frame) - kept * first_angles_[hinge];
  return {stencil,
          weight * turned,
          weight,
          {-(1.0 - foot_left) * of_left - (1.0 - foot_right) * of_right,
           -foot_left * of_left - foot_right * of_right, of_left, of_right}};
}

}  // namespace planish
