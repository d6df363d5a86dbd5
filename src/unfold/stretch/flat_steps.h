#pragma once

#include <vector>

#include "unfold/disk/disk.h"
#include "unfold/stretch/symmetric_dirichlet.h"

namespace planish {

/// Which coordinates of a flat disk move. Turning and shifting cost no energy, so the first border
/// vertex stays, and the one half way around stays on its line with it (the disk is turned to make
/// that the x axis).
class Unknowns {
 public:
  explicit Unknowns(const Disk& disk) : column_(2 * disk.vertex_count, 0) {
    const Index anchor = disk.border.front();
    column_[2 * anchor] = column_[2 * anchor + 1] = k_fixed;
    column_[2 * opposite(disk) + 1] = k_fixed;
    for (int& column : column_) {
      if (column != k_fixed) column = count_++;
    }
  }

  static Index opposite(const Disk& disk) { return disk.border[disk.border.size() / 2]; }
  static constexpr int k_fixed = -1;
  int count() const { return count_; }
  /// Of x (0) or y (1) of a vertex; k_fixed where it stays.
  int column(Index v, int axis) const { return column_[2 * v + axis]; }

 private:
  std::vector<int> column_;
  int count_ = 0;
};

/// The flat disk turned and shifted to where Unknowns holds it.
std::vector<Vec2> turn_to_axis(const Disk& disk, std::vector<Vec2> flat);

/// @pre the triangle is not flipped
inline TriangleEnergy energy_of(const Disk& disk, std::size_t t, const std::vector<Vec2>& flat) {
  const Triangle& tri = disk.triangles[t];
  return {disk.rest[t], flat[tri[0]], flat[tri[1]], flat[tri[2]]};
}

/// Of all triangles; infinite where one has no positive area.
double total_energy(const Disk& disk, const std::vector<Vec2>& flat);

/// The share of a step at which the first triangle loses its area; infinite if none does.
double step_to_first_flip(const Disk& disk, const std::vector<Vec2>& flat,
                          const std::vector<Vec2>& step);

/// The positions after a share of a step.
std::vector<Vec2> moved(std::vector<Vec2> flat, double share, const std::vector<Vec2>& step);

}  // namespace planish
