#include "core/likely_units.h"

#include <algorithm>
#include <array>
#include <utility>

namespace planish {

namespace {

/// How much less likely than metres a unit is: most programs that do not model in millimetres do so
/// in metres, MakeHuman in decimetres.
constexpr std::array<std::pair<Unit, double>, 5> k_units_by_use = {
    {{Unit::m, 1.0}, {Unit::cm, 1.35}, {Unit::dm, 1.65}, {Unit::mm, 2.2}, {Unit::in, 7.0}}};

/// By which factor a piece differs from one of a middle size.
double oddity(double millimetres) {
  constexpr double middle = 400.0;
  return std::max(millimetres / middle, middle / millimetres);
}

}  // namespace

std::vector<Unit> likely_units(double longest, Unit unit) {
  std::vector<std::pair<double, Unit>> found;
  for (const auto& [other, rarity] : k_units_by_use) {
    const double size = millimetres_per(other) * longest;
    const bool is_usual = k_small_piece <= size && size <= k_large_piece;
    if (other != unit && is_usual) found.emplace_back(rarity * oddity(size), other);
  }
  std::sort(found.begin(), found.end());
  std::vector<Unit> units;
  units.reserve(found.size());
  for (const auto& [score, other] : found)
    units.push_back(other);
  return units;
}

}  // namespace planish
