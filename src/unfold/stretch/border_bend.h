#pragma once

#include <array>
#include <vector>

#include "unfold/disk/disk.h"

namespace planish {

/// What a border that keeps its lengths costs where it turns otherwise than it would by itself. A
/// line that is pressed together sideways costs less the finer it zigzags, so without this a seam
/// that is to be longer than least stretch makes it would get teeth as fine as the mesh.
///
///     B sum_i (t_i - r_i)^2 / l_i
///
/// with the turns t_i of the border at its vertices, those of another pattern r_i and half the
/// length of both edges l_i: the squared change of curvature along the border.
class BorderBend {
 public:
  /// B, of a disk of area 1. From 3e-5 to 3e-4 the strain of patterns differs by less than 0.2 % of
  /// itself.
  static constexpr double k_stiffness = 1e-4;

  /// A turn that costs: at the second of three border vertices that follow each other.
  struct Turn {
    Triangle vertices;
    double free = 0.0;    ///< r_i
    double weight = 0.0;  ///< B / l_i
  };

  /// Of the ends of edges that keep their length. Where an edge is shorter than a twentieth of the
  /// mean, what it turns by means nothing and costs nothing.
  /// @param like the pattern whose border turns at no cost
  BorderBend(const Disk& disk, const BorderLengths& lengths, const std::vector<Vec2>& like);

  const std::vector<Turn>& turns() const { return turns_; }

  double energy(const std::vector<Vec2>& flat) const;
  static double energy_of(const Turn& turn, const std::vector<Vec2>& flat);

  /// Of so many times the energy of one turn. The curvature leaves out second derivatives of the
  /// angle, and so is never negative: 2 weight times the gradient of the angle with itself.
  struct Derivatives {
    std::array<double, 6> gradient;  ///< by x and y of the three vertices, in turn
    std::array<std::array<double, 6>, 6> hessian;
  };
  static Derivatives derivatives(const Turn& turn, const std::vector<Vec2>& flat,
                                 double times = 1.0);

 private:
  std::vector<Turn> turns_;
};

}  // namespace planish
