#pragma once

#include <string>

#include <planish/draw/format_drawing.h>

namespace planish {

/// The drawing as DXF R2000 (AC1015): format_dxf() of the generic profile in that version. Lines
/// become LWPOLYLINEs. Of an outline with fitted curves, lines and arcs become LWPOLYLINEs and
/// cubics with a common tangent one SPLINE; where one ends, the next one begins.
std::string format_dxf_r2000(const Drawing& drawing, const DxfOptions& options);

}  // namespace planish
