#include "core/likely_units.h"

#include <array>

namespace planish {

namespace {

/// The likeliest first: programs that model in other units than mm mostly do so in m.
constexpr std::array k_by_use = {Unit::m, Unit::cm, Unit::dm, Unit::in, Unit::mm};

}  // namespace

std::vector<Unit> likely_units(double longest, Unit unit) {
  std::vector<Unit> units;
  for (const Unit other : k_by_use) {
    const double size = millimetres_per(other) * longest;
    if (other != unit && k_small_piece <= size && size <= k_large_piece) units.push_back(other);
  }
  return units;
}

}  // namespace planish
