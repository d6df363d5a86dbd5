#include "evolve/auto/smooth/smooth_control.h"

#include <algorithm>
#include <cmath>

#include "core/math.h"
#include "evolve/auto/shared/tuning.h"

namespace planish {

using namespace tuning::prefer_smooth;

namespace {

/// 0 where little strain may stay, 1 where much may.
double looseness(const StrainLimits& limit, const DescentStrain& at_first) {
  const double left = std::min(1.0, headroom(limit, at_first)) * at_first.rms;
  return std::clamp(math::log(left / k_tight) / math::log(k_loose / k_tight), 0.0, 1.0);
}

double between(double tight, double loose, double looseness) {
  return tight + looseness * (loose - tight);
}

/// The first delta over the least: where much strain has to go, closeness begins weak.
double first_delta(double strain_over_limit, double looseness, bool flat) {
  const double loose = std::clamp(k_first_delta * strain_over_limit * strain_over_limit,
                                  k_first_delta, k_most_first_delta);
  return between(flat ? k_first_delta_flat : k_first_delta, loose, looseness);
}

/// Of delta in a step. @param excess bending over its ceiling
double factor_by_bending(double excess) {
  return math::pow(excess, k_delta_exponent);
}

}  // namespace

SmoothControl::SmoothControl(const Aims& aims, const DescentStrain& at_first)
    : limit_(aims.limit),
      bounded_(aims.max_bending > 0.0),
      follows_deviation_(aims.border_reach && !bounded_),
      bending_settled_(!bounded_) {
  const double loose = looseness(limit_, at_first),
               reach = std::min(1.0, aims.border_reach.value_or(0.0) / k_far_border);
  ceiling_ = between(k_tight_ceiling, k_loose_ceiling, loose);
  least_delta_ =
      between(between(k_tight_delta, k_tight_delta_far_border, reach), k_loose_delta, loose);
  double first = least_delta_ * first_delta(1.0 / headroom(limit_, at_first), loose, aims.flat);
  usual_delta_ = first;
  if (bounded_) {
    const double bound = aims.max_bending / (aims.flat ? k_room_for_polish : k_nearly);
    first = std::clamp(first * ceiling_ / bound, k_least_first_delta, k_most_delta);
    ceiling_ = bound;
    least_delta_ = k_bounded_delta;
  }
  weights_ = {first, k_first_sigma, k_loose_form * loose};
  if (loose >= 1.0) stage_ = Stage::led;
}

void SmoothControl::start_finer(double least_delta_factor) {
  least_delta_factor_ = least_delta_factor;
  stage_ = Stage::lifted;
  steps_ = settled_ = 0;
  met_ = false;
}

void SmoothControl::start_strict() {
  stage_ = Stage::strict;
  steps_ = settled_ = 0;
  met_ = false;
  weights_ = {bounded_ ? weights_.delta : k_strict_delta, k_first_strict_sigma, 0.0};
}

void SmoothControl::after(const SmoothDescent::Step& step, const DescentStrain& strain,
                          double bending, double deviation) {
  const double fall = step.merit_before - step.merit;
  const double little =
      step.parts > 1 && stage_ != Stage::strict ? k_settled_fall_along_lines : k_settled_fall;
  settled_ = fall < little * step.merit_before ? settled_ + step.parts : 0;
  steps_ += stage_ == Stage::strict ? step.parts : 1;
  const bool stage_is_over = steps_ >= k_most_of_stage || fall < k_stage_fall * step.merit_before;
  if (stage_ == Stage::loose && stage_is_over) {
    stage_ = Stage::closer;
    steps_ = 0;
    weights_.sigma = k_closer_sigma;
  } else if (stage_ == Stage::closer && stage_is_over) {
    stage_ = Stage::led;
  }
  if (stage_ == Stage::lifted && steps_ >= k_steps_lifted) stage_ = Stage::led;
  if (stage_ == Stage::strict && bounded_) lead_strict(strain, bending);
  if (stage_ == Stage::strict && steps_ >= k_steps_first_strict) {
    met_ = weights_.sigma == k_last_strict_sigma;
    weights_.sigma = k_last_strict_sigma;
  }
  if (stage_ == Stage::led) lead(strain, bending, deviation);
}

void SmoothControl::lead(const DescentStrain& strain, double bending, double deviation) {
  const double share = headroom(limit_, strain), excess = bending / ceiling_;
  const bool bends_too_much = excess > k_nearly, furthest = weights_.delta >= k_most_delta;
  const bool strained = share * k_nearly < 1.0;
  const bool keeps_form = weights_.form > 0.0;
  const bool stuck = strained && (keeps_form || !furthest) && is_stuck(strain);
  const bool gave_way = !bounded_ || weights_.delta >= usual_delta_;
  left_ = strained && !keeps_form && (furthest || (stuck && gave_way));
  if (keeps_form && (stuck || (bends_too_much && furthest)))
    weights_.form = weights_.form > k_least_form ? k_form_fall * weights_.form : 0.0;
  is_smooth_ = !bends_too_much;
  met_ = is_smooth_ && (!strained || left_);
  if (bends_too_much && furthest && !keeps_form)
    weights_.sigma *= std::min(std::sqrt(excess), k_most_factor);
  else
    weights_.sigma *= std::clamp(std::sqrt(share), k_least_factor, k_most_factor);
  const double least_sigma = k_least_sigma * strain.rms;
  const bool closeness_wins = strained && !gave_way && weights_.sigma < least_sigma;
  weights_.sigma = std::max(weights_.sigma, least_sigma);
  // Closeness must not push strain out again that is still above its limit.
  const double least = closeness_wins ? k_most_delta_factor : strained ? 1.0 : least_delta_factor_;
  double factor = factor_by_bending(excess);
  if (follows_deviation_)
    factor = std::max(factor, k_delta_of_deviation * deviation / weights_.delta);
  lead_delta(excess, factor, least);
}

/// Delta grows where closeness keeps too much strain.
void SmoothControl::lead_strict(const DescentStrain& strain, double bending) {
  const double left = strain.rms / weights_.sigma;
  const double least = left > k_much_left     ? k_most_delta_factor
                       : left > k_little_left ? 1.0
                                              : least_delta_factor_;
  const double excess = bending / ceiling_;
  lead_delta(excess, factor_by_bending(excess), least);
}

/// @param excess bending over its ceiling
void SmoothControl::lead_delta(double excess, double factor, double least_factor) {
  weights_.delta =
      std::clamp(weights_.delta * std::clamp(factor, least_factor, k_most_delta_factor),
                 least_delta_, k_most_delta);
  const bool furthest = weights_.delta >= k_most_delta,
             strain_forbids_less = stage_ == Stage::strict && least_factor >= 1.0,
             nearest = strain_forbids_less || left_ || weights_.delta <= least_delta_;
  bending_settled_ =
      !bounded_ || furthest || (excess <= k_nearly && (nearest || excess * k_nearly >= 1.0));
}

/// True where a smaller and smaller sigma takes no more strain out.
bool SmoothControl::is_stuck(const DescentStrain& strain) {
  stuck_ = strain.rms > (1.0 - k_stuck_fall) * last_strain_ ? stuck_ + 1 : 0;
  last_strain_ = strain.rms;
  return stuck_ >= k_stuck_steps;
}

}  // namespace planish
