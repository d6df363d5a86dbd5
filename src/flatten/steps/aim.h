#pragma once

#include <planish/flatten/flatten.h>

namespace planish {

/// The method that is asked for, or else the one that changes the form where that is needed.
Method how_of(const FlattenOptions& options);

/// Those asked for, or else those of the method.
StrainLimits limits_of(const FlattenOptions& options);

/// What a pattern has to keep for the work to be done: the limits, or where none is given and the
/// surface is to stay smooth, a strain too small to measure. Nothing where another aim leads.
StrainLimits aim_of(const StrainLimits& limits, const Method& method, const Stopping& stopping);

/// The method with the limits as its own. Auto ends when its estimate of the strain keeps them.
Method aimed_at(const StrainLimits& limits, Method method);

/// The method with tighter limits of its own.
Method tightened(Method method, const StrainLimits& aim, double share);

}  // namespace planish
