#pragma once

#include <functional>
#include <span>
#include <vector>

#include "unfold/stretch/flat_edges.h"
#include "unfold/stretch/least_stretch.h"
#include "unfold/stretch/stretch_system.h"

namespace planish {

/// Spreads the stretch of a pattern of least stretch, so that its peaks fall: first the strain that
/// edges of 99 % of the area do not exceed, with it the largest of all edges that can follow
/// (docs/unfold.md, "Spreading the stretch"). The rms strain rises to `most_rms` at most, no
/// triangle flips, and a border that does not cross itself stays so.
/// @param system of the disk: what it holds, like lengths of the border, stays held
/// @param least of minimise_stretch(), or match_border() where the border keeps its lengths
/// @param most_rms a share of length, at least that of `least`
/// @param after_step called after each step; what it throws is passed on
/// @return `least` itself where spreading gains nothing; iterations count from those of `least`
LeastStretch spread_stretch(const Disk& disk, StretchSystem& system,
                            std::span<const FlatEdge> edges, LeastStretch least, double most_rms,
                            const std::function<void()>& after_step);

/// Lowers the rms strain of the edges of a pattern of least stretch to `most_rms`, or as far as it
/// gets: the symmetric Dirichlet energy, which least stretch has least, counts shear more
/// (docs/unfold.md, "A limit of the rms"). No triangle flips, and a border that does not cross
/// itself stays so. Parameters as of spread_stretch().
/// @return `least` itself where it is there already
LeastStretch lower_rms(const Disk& disk, StretchSystem& system, std::span<const FlatEdge> edges,
                       LeastStretch least, double most_rms,
                       const std::function<void()>& after_step);

/// The root mean square of strains, each weighed by the area that its edge stands for.
double rms_strain(std::span<const FlatEdge> edges, std::span<const double> strains);

}  // namespace planish
