#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "mesh/match/border_lines.h"
#include "mesh/match/boundary_correspondences.h"

namespace planish {

/// Two stretches of border that run along each other.
struct CurveChain {
  std::array<std::size_t, 2> loops{};  ///< numbers, the lower one first
  bool reversed = false;               ///< the second stretch runs against its loop
  bool closed = false;                 ///< it ends where it begins
  /// Places on both that lie beside each other, along the first loop; they go on over its end. A
  /// closed chain's last ones are its first ones, a turn later.
  std::vector<std::array<double, 2>> at;

  /// Length of one of them.
  double length(const BorderLines& borders, std::size_t side) const;
};

/// Puts places together to chains as long as they can be; what interrupts a chain is shorter than
/// some edges and than half of what it divides. Of two that are the same but for the order of
/// sides there is one.
std::vector<CurveChain> find_curve_chains(const BorderLines& borders,
                                          std::vector<BoundaryCorrespondence> places);

}  // namespace planish
