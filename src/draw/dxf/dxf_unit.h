#pragma once

#include <string>
#include <string_view>

#include <planish/core/unit.h>

namespace planish {

/// A DXF file of ours, which is in millimetres, in another unit: all lengths are divided, to
/// 0.00001 of the unit, and the header and the texts of apparel profiles say the unit.
/// @throws Error unknown_name for a unit other than mm and in
std::string dxf_in_unit(std::string dxf, Unit unit);

}  // namespace planish
