#pragma once

#include <optional>
#include <span>
#include <vector>

#include <planish/measure/fairness.h>
#include <planish/mesh/patch.h>

namespace planish {

/// The longest wave that smoothed_positions() takes out, in mean edges.
inline constexpr double k_longest_wave = 20.0;

/// The positions of all vertices when short waves are taken out of a surface: the noise of a scan,
/// not its form. Solves
///
///   (M + t L^T M^-1 L) x = M x0,  t = (wave / 2 pi)^4,
///
/// L the inner rows of the cotangent Laplacian, M a third of the area of the triangles around each
/// vertex: the wave is halved, one twice as long keeps 94 %. Border vertices stay where they are.
/// By conjugate gradients to about five digits of the move, in steps that grow with the square of
/// the wave.
/// @param wave a length in model units; two mean edges where there is none
/// @throws Error option_out_of_range: at least 0 and at most k_longest_wave mean edges
std::vector<Vec3> smoothed_positions(const Patch& patch, std::optional<double> wave = {});

/// B0: what bending is measured by beside a design: that of the smoothed design, so that noise does
/// not count for form; where needles make that more, that of the design as it is. 0 for a plane
/// (below k_no_bending). No unit.
double design_bending(const Patch& patch);

/// As measure_fairness(design, after), of which design_bending(design) is much of the work.
/// @param b0 design_bending(design); up to k_no_bending for a plane
Fairness measure_fairness(const Patch& design, double b0, std::span<const Vec3> after);

/// The same but for the change of the form.
Fairness fairness_beside(const Patch& design, double b0, std::span<const Vec3> after);

}  // namespace planish
