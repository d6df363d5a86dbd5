#include "evolve/smooth/smooth_control.h"

#include <algorithm>
#include <cmath>

#include "core/math.h"

namespace planish {

namespace {

// As shares of length: a limit that leaves so little, or so much and more.
constexpr double k_tight = 1e-3, k_loose = 5e-3;
constexpr double k_most_delta = 0.1;
// Of sigma over the strain: where much strain cannot go, less would buy little of it with much.
constexpr double k_least_sigma = 0.3;
// Of the limit, so that steps end within it; and of the ceiling, which may be passed by a little.
constexpr double k_within = 1.03;
// Steps with the weights of the coarser level, until what lifting broke is mended.
constexpr int k_steps_lifted = 3;
// Where all strain is to go.
constexpr double k_strict_delta = 0.025, k_first_strict_sigma = 5e-4, k_last_strict_sigma = 1e-4;
constexpr int k_steps_first_strict = 10;

/// 0 where little strain may stay, 1 where much may.
double looseness(const StrainLimit& limit, const DescentStrain& at_first) {
  const double left = std::min(1.0, limit.share_of(at_first)) * at_first.rms;
  return std::clamp(math::log(left / k_tight) / math::log(k_loose / k_tight), 0.0, 1.0);
}

double between(double tight, double loose, double looseness) {
  return tight + looseness * (loose - tight);
}

}  // namespace

SmoothControl::SmoothControl(const StrainLimit& limit, const DescentStrain& at_first)
    : limit_(limit) {
  const double loose = looseness(limit, at_first);
  ceiling_ = between(1.2, 1.06, loose);
  least_delta_ = between(0.005, 0.0025, loose);
  weights_ = {2.0 * least_delta_, 0.02};
  if (loose >= 1.0) stage_ = Stage::led;
}

void SmoothControl::start_finer() {
  stage_ = Stage::lifted;
  steps_ = settled_ = 0;
  met_ = false;
}

void SmoothControl::start_strict() {
  stage_ = Stage::strict;
  steps_ = settled_ = 0;
  met_ = false;
  weights_ = {k_strict_delta, k_first_strict_sigma};
}

void SmoothControl::after(const SmoothDescent::Step& step, const DescentStrain& strain,
                          double bending) {
  constexpr int most_of_stage = 8;
  constexpr double small_fall = 0.05, settled_fall = 1e-2;
  const double fall = step.merit_before - step.merit;
  settled_ = fall < settled_fall * step.merit_before ? settled_ + 1 : 0;
  const bool stage_is_over = ++steps_ >= most_of_stage || fall < small_fall * step.merit_before;
  if (stage_ == Stage::loose && stage_is_over) {
    stage_ = Stage::closer;
    steps_ = 0;
    weights_.sigma = 0.005;
  } else if (stage_ == Stage::closer && stage_is_over) {
    stage_ = Stage::led;
  }
  if (stage_ == Stage::lifted && steps_ >= k_steps_lifted) stage_ = Stage::led;
  if (stage_ == Stage::strict && steps_ >= k_steps_first_strict) {
    weights_.sigma = k_last_strict_sigma;
    met_ = steps_ > k_steps_first_strict;
  }
  if (stage_ == Stage::led) lead(strain, bending);
}

void SmoothControl::lead(const DescentStrain& strain, double bending) {
  const double share = limit_.share_of(strain), excess = bending / ceiling_;
  const bool bends_too_much = excess > k_within, gives_way = weights_.delta >= k_most_delta;
  left_ = share * k_within < 1.0 && (gives_way || is_stuck(strain));
  is_smooth_ = !bends_too_much;
  met_ = is_smooth_ && (share * k_within >= 1.0 || left_);
  if (bends_too_much && gives_way)
    weights_.sigma *= std::min(std::sqrt(excess), 1.4);
  else
    weights_.sigma *= std::clamp(std::sqrt(share), 0.7, 1.4);
  weights_.sigma = std::max(weights_.sigma, k_least_sigma * strain.rms);
  // Closeness must not push strain out again that is still above its limit.
  const double nearest = share * k_within < 1.0 ? 1.0 : 0.85;
  weights_.delta = std::clamp(weights_.delta * std::clamp(math::pow(excess, 0.35), nearest, 1.18),
                              least_delta_, k_most_delta);
}

/// True where a smaller and smaller sigma takes no more strain out.
bool SmoothControl::is_stuck(const DescentStrain& strain) {
  constexpr double small_fall = 0.02;
  constexpr int many = 6;
  stuck_ = strain.rms > (1.0 - small_fall) * last_strain_ ? stuck_ + 1 : 0;
  last_strain_ = strain.rms;
  return stuck_ >= many;
}

}  // namespace planish
