#pragma once

#include <string>

#include <planish/draw/drawing.h>

namespace planish {

/// The drawing as HPGL for plotters and cutters, 40 units per millimetre, so coordinates to
/// 0.025 mm. Each layer that is visible and has lines takes a pen, from pen 1 on; closed lines end
/// where they began; text is drawn as strokes. HPGL has no areas: what is filled and has no outline
/// is left out. Widths, colours and dashes are the pen's, not the file's. Plotters with 16-bit
/// coordinates reach 819 mm. The same drawing gives the same bytes.
std::string write_plt(const Drawing& drawing);

}  // namespace planish
