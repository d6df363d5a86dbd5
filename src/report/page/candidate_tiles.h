#pragma once

#include <string>

#include <planish/flatten/flatten.h>

namespace planish {

/// The surfaces that a run computed as tiles: each shaded, with the outline of its pattern at one
/// scale and a sentence on stretch, move and form; the one that was written is marked. HTML.
std::string candidate_tiles(const FlattenReport& report);

}  // namespace planish
