#pragma once

#include <string_view>

namespace planish {

/// What one unit of the model is. Mesh files do not say.
enum class Unit { mm, cm, m, in };

std::string_view to_string(Unit unit);
double millimetres_per(Unit unit);
/// @throws Error unknown_name naming the units that are known
Unit unit_named(std::string_view name);

}  // namespace planish
