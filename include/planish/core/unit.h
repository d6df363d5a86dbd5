#pragma once

#include <string_view>

namespace planish {

/// What one unit of the model is. Mesh files do not say.
enum class Unit { mm, cm, dm, m, in };

/// "mm", "cm", "dm", "m" or "in".
std::string_view to_string(Unit unit);
/// 1, 10, 100, 1000 or 25.4.
double millimetres_per(Unit unit);
/// @throws Error unknown_name naming the units that are known
Unit unit_named(std::string_view name);

}  // namespace planish
