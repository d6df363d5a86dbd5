#pragma once

#include <vector>

#include "core/thread_pool.h"
#include "unfold/disk/disk.h"

namespace planish {

/// Lays the disk flat conformally with the border keeping its lengths, after Sawhney and Crane
/// (Boundary First Flattening, 2017): solve for the logarithm u of the scale with u = 0 at the
/// border, turn the border by its normal derivative, close the curve, extend into the inside. Exact
/// where the disk is flattenable. Triangles may be flipped where it is far from it. Empty where the
/// matrix cannot be factored. @pre no holes
std::vector<Vec2> conformal_start(const Disk& disk, ThreadPool& pool);

/// Lays the disk flat with no triangle flipped, however far it is from flattenable (Tutte 1963):
/// the border on a circle, every inner vertex at the mean of its neighbours. Area 1. @pre no holes
std::vector<Vec2> tutte_start(const Disk& disk, ThreadPool& pool);

}  // namespace planish
