#include "evolve/smooth/hinge_terms.h"

#include <cmath>

#include <planish/measure/fairness.h>

#include "core/careful_sum.h"
#include "core/math.h"

namespace planish {

namespace {

constexpr std::size_t k_hinge_grain = 2048;

/// The edge and the normals of its two triangles, each twice the area long.
struct Frame {
  Vec3 edge, left, right;
};

Frame frame_of(const std::array<Index, 4>& corners, const PatchState& state) {
  const Vec3 from = state.position(corners[0]);
  const Vec3 edge = state.position(corners[1]) - from;
  return {edge, cross(edge, state.position(corners[2]) - from),
          cross(state.position(corners[3]) - from, edge)};
}

/// Between the normals, positive where it is a valley seen from outside.
double angle_of(const Frame& frame) {
  const double sine = dot(cross(frame.right, frame.left), frame.edge) / norm(frame.edge);
  const double cosine = dot(frame.left, frame.right);
  return sine == 0.0 && cosine == 0.0 ? 0.0 : math::atan2(sine, cosine);
}

}  // namespace

HingeTerms::HingeTerms(const Patch& design, const PatchState& state) : state_(state) {
  const std::vector<Hinge> hinges = hinges_of(design);
  hinges_.reserve(hinges.size());
  for (const Hinge& hinge : hinges)
    hinges_.push_back({hinge.from, hinge.to, hinge.left, hinge.right});
  weights_.resize(hinges_.size());
  first_angles_.reserve(hinges_.size());
  for (std::size_t h = 0; h < size(); ++h)
    first_angles_.push_back(angle(h));
}

void HingeTerms::take_weights(ThreadPool& pool) {
  pool.for_ranges(size(), k_hinge_grain, [this](std::size_t begin, std::size_t end) {
    for (std::size_t h = begin; h < end; ++h) {
      const Frame frame = frame_of(hinges_[h], state_);
      const double areas = 0.5 * (norm(frame.left) + norm(frame.right));
      weights_[h] = areas > 0.0 ? 3.0 * dot(frame.edge, frame.edge) / areas : 0.0;
    }
  });
}

double HingeTerms::angle(std::size_t hinge) const {
  return angle_of(frame_of(hinges_[hinge], state_));
}

double HingeTerms::bending(ThreadPool& pool, double kept) const {
  std::vector<double> terms(size());
  pool.for_ranges(size(), k_hinge_grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t h = begin; h < end; ++h) {
      const double t = angle(h) - kept * first_angles_[h];
      terms[h] = weights_[h] * t * t;
    }
  });
  CarefulSum sum;
  for (const double term : terms)
    sum.add(term);
  return sum.value();
}

HingeTerms::Slope HingeTerms::slope(std::size_t hinge) const {
  const auto& corners = hinges_[hinge];
  const Frame frame = frame_of(corners, state_);
  const double left = dot(frame.left, frame.left), right = dot(frame.right, frame.right);
  const double square = dot(frame.edge, frame.edge);
  if (!(left > 0.0) || !(right > 0.0)) return {};
  const double length = std::sqrt(square);
  // A tip that rises along its normal lessens the angle by the distance over its height.
  const Vec3 of_left = (length / left) * frame.left, of_right = (length / right) * frame.right;
  const Vec3 from = state_.position(corners[0]);
  const double foot_left = dot(state_.position(corners[2]) - from, frame.edge) / square;
  const double foot_right = dot(state_.position(corners[3]) - from, frame.edge) / square;
  return {angle_of(frame),
          {-(1.0 - foot_left) * of_left - (1.0 - foot_right) * of_right,
           -foot_left * of_left - foot_right * of_right, of_left, of_right}};
}

}  // namespace planish
