#pragma once

#include <optional>
#include <vector>

#include <planish/mesh/tri_mesh.h>
#include <planish/unfold/strain.h>
#include <planish/unfold/unfold.h>

namespace planish {

/// The strain of patterns of a patch as it came: what its material has to take if the surface is
/// not changed. As shares of length.
struct StrainAsDesigned {
  EdgeStrain least_stretch;  ///< of the pattern of least stretch
  /// Of all edges, smallest_limit(); nothing above k_most_searched vertices.
  std::optional<double> smallest_limit = {};
  /// One for each limit that was asked for: of the pattern that keeps them best.
  std::vector<StrainLimitCheck> limits = {};

  /// Patches with more vertices have no search for the smallest limit, which takes some 15 times as
  /// long as laying flat.
  static constexpr std::size_t k_most_searched = 100'000;
};

/// Lays a patch flat, with and without limits, and keeps the figures. Nothing when cancelled.
/// @param threads 0 for all cores; the result is the same for every number
/// @throws Error as unfold()
std::optional<StrainAsDesigned> strain_as_designed(const Patch& patch, const StrainLimits& limits,
                                                   unsigned threads = 0,
                                                   const OnUnfoldStep& on_step = {});

}  // namespace planish
