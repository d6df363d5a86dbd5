#pragma once

#include <optional>

#include "evolve/auto/shared/descent_strain.h"
#include "evolve/auto/shared/tuning.h"
#include "evolve/auto/smooth/smooth_descent.h"

namespace planish {

/// Which weights the steps of SmoothDescent take, and when they are over (docs/methods/smooth.md):
/// strain is taken out slowly, then sigma is led by the strain and delta by the bending, until
/// strain is at its limit and bending at most at its ceiling. If that cannot be, the share of the
/// design's angles that bending is counted from falls, and at 0 more strain is left. Where the
/// border may move, delta is at least a multiple of the deviation. Where a bound of bending is
/// given, delta falls until the surface bends as much as that.
class SmoothControl {
 public:
  struct Aims {
    StrainLimits limit = {};
    bool flat = false;                        ///< all strain is to go in the end
    double max_bending = 0.0;                 ///< over the design's; 0: the usual ceiling
    std::optional<double> border_reach = {};  ///< as of SmoothDescent
  };

  /// @param at_first of the design
  SmoothControl(const Aims& aims, const DescentStrain& at_first);

  /// Of the next step.
  SmoothWeights weights() const { return weights_; }
  /// Follows a step.
  /// @param strain,bending,deviation after it, as of SmoothDescent
  void after(const SmoothDescent::Step& step, const DescentStrain& strain, double bending,
             double deviation);
  /// From here on as from what a coarser level has found.
  /// @param least_delta_factor by which delta falls at most in a step
  void start_finer(double least_delta_factor = tuning::prefer_smooth::k_least_delta_factor);

  /// From here on strain goes on to nothing, as smoothly as it can.
  void start_strict();

  /// Both aims hold and steps gain little more, or the most steps to nothing were made.
  bool is_over() const {
    using namespace tuning::prefer_smooth;
    const int most = bounded_ ? k_most_strict_steps_bounded : k_most_strict_steps;
    return (met_ && bending_settled_ && settled_ >= k_settled_steps) ||
           (stage_ == Stage::strict && steps_ >= most);
  }
  /// True if a bound of bending is given.
  bool is_bounded() const { return bounded_; }
  /// True if the bending of the last step is within the ceiling, nearly.
  bool is_smooth() const { return is_smooth_; }
  /// True if strain beyond the limit is left, as only crumples would take it out.
  bool leaves_strain() const { return left_; }

 private:
  enum class Stage { loose, closer, lifted, led, strict };

  void lead(const DescentStrain& strain, double bending, double deviation);
  void lead_strict(const DescentStrain& strain, double bending);
  void lead_delta(double excess, double factor, double least_factor);
  bool is_stuck(const DescentStrain& strain);

  StrainLimits limit_;
  bool bounded_, follows_deviation_;
  double ceiling_, least_delta_, usual_delta_;
  double least_delta_factor_ = tuning::prefer_smooth::k_least_delta_factor;
  SmoothWeights weights_;
  Stage stage_ = Stage::loose;
  int steps_ = 0, settled_ = 0;
  int stuck_ = 0;
  double last_strain_ = 0.0;
  bool is_smooth_ = false, met_ = false, left_ = false;
  bool bending_settled_;
};

}  // namespace planish
