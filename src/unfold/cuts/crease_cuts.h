#pragma once

#include <planish/mesh/patch.h>

#include "unfold/cuts/reduced_paths.h"

namespace planish {

/// Where a mesh with sharp creases is to be cut so that its faces, which the creases divide, lie
/// flat: along creases, but for one straight part of a crease from each face to another, the
/// longest ones, which stay whole. Faces of less than 1 % of the area count as parts of others.
/// Nothing where creases divide nothing, or too much, or where less than half of the angle defects
/// lies on them, as on bodies that are round elsewhere.
/// @param least_hinge a straight part shorter than this, over the root of the area of the smaller
///   face beside it, is cut too, and divides the mesh
Chains crease_cuts(const Patch& patch, double least_hinge);

}  // namespace planish
