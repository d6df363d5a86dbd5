#pragma once

#include <vector>

#include "energy/turn_bending.h"
#include "unfold/disk/disk.h"

namespace planish {

/// A border whose edges keep lengths, but those that are free, and which bends at a cost. A line
/// that is pressed together sideways costs less the finer it zigzags, so without this a seam that
/// is to be longer than least stretch makes it would get teeth as fine as the mesh.
struct HeldBorder {
  /// Weight of the squared change of curvature along the border, of a disk of area 1. From 3e-5 to
  /// 3e-4 the strain of patterns differs by less than 0.2 % of itself.
  static constexpr double k_stiffness = 1e-4;

  /// @param like the pattern whose border turns at no cost
  HeldBorder(const Disk& disk, BorderLengths wanted, const std::vector<Vec2>& like);

  BorderLengths lengths;
  /// Of the ends of edges that keep their length. Where an edge is shorter than a twentieth of the
  /// mean, what it turns by means nothing and costs nothing.
  TurnBending bend;
  /// The disk's vertices in order of elimination. What a turn costs couples the vertices beside it,
  /// past those that part them in the disk's own order, where factors would be several times as
  /// large.
  std::vector<Index> order;
};

}  // namespace planish
