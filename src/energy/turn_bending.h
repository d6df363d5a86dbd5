#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "energy/summand.h"

namespace planish {

/// What a line in the plane costs where it turns otherwise than in another layout,
///
///     E_b = sum of w (t - r)^2,
///
/// t the turns of the line at its vertices, r those there (docs/unfold.md, "No teeth").
class TurnBending {
 public:
  /// A turn at the second of three vertices that follow each other.
  struct Turn {
    std::array<Index, 3> vertices;
    double weight = 0.0;  ///< w
    double free = 0.0;    ///< r
  };

  /// @param turns their r is taken from `like`
  TurnBending(std::vector<Turn> turns, const std::vector<Vec2>& like);

  const std::vector<Turn>& turns() const { return turns_; }
  double value(const std::vector<Vec2>& flat) const;
  /// @param factor that the energy is multiplied by
  Summand<3, Vec2> summand(std::size_t turn, const std::vector<Vec2>& flat,
                           double factor = 1.0) const;

 private:
  std::vector<Turn> turns_;
};

}  // namespace planish
