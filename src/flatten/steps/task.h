#pragma once

#include <optional>

#include <planish/flatten/flatten.h>

#include "flatten/steps/least_change.h"

namespace planish {

/// What the options of flatten() come to.
struct Task {
  const FlattenOptions& options;
  SearchEffort effort;
  StrainLimits limits;  ///< those asked for, or else those of the method
  Method method;        ///< asked for, or else the one for limits; with the limits as its own
  Stopping stopping;
  /// What a pattern has to keep for the work to be done: the limits, or where none is given and the
  /// surface is to stay smooth, a strain too small to measure. Nothing where another aim leads.
  StrainLimits aim;

  /// @param options must outlive it
  explicit Task(const FlattenOptions& options, const SearchEffort& effort = {});

  bool keeps_design() const { return options.keep_design || !options.may_change(); }
  /// How far the form may go for the least strain, or for limits, where no method was asked for
  /// that is led otherwise; model units.
  std::optional<double> tolerance() const;
  /// Whether a pattern may keep the limits where the estimate of the surface's strain does not:
  /// that says little of the largest strain, and the pattern has less rms than it tells.
  bool seeks_least_change() const;
  /// The method with limits of its own that are smaller by a factor.
  Method tightened(Method of_last_run, double factor) const;

 private:
  const Auto* auto_options() const { return std::get_if<Auto>(&method); }
};

/// Those asked for, or else those of the method.
StrainLimits limits_of(const FlattenOptions& options);

}  // namespace planish
