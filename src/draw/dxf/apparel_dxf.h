#pragma once

#include <string>

#include <planish/draw/format_drawing.h>

namespace planish {

/// The drawing for apparel programs: format_dxf() with a profile that has pieces.
std::string format_apparel_dxf(const Drawing& drawing, const DxfOptions& options);

}  // namespace planish
