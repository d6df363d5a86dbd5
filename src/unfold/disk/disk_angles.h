#pragma once

#include <vector>

#include <Eigen/Core>

#include "unfold/disk/inner_system.h"

namespace planish {

/// What the corners of a disk's triangles add up to.
struct DiskAngles {
  std::vector<SideWeights> half_cotangents;  ///< of the corners, which are opposite the sides
  Eigen::VectorXd sums;                      ///< of the corners' angles, by vertex
};

DiskAngles disk_angles(const Disk& disk);

/// The logarithm of the scale of the conformal map into the plane that keeps lengths at the border.
/// @pre laplacian is that of the half cotangents, and solvable
Eigen::VectorXd log_scale(const InnerSystem& laplacian, const DiskAngles& angles);

}  // namespace planish
