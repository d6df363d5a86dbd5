#pragma once

#include <vector>

#include <planish/flatten/product.h>

#include "shell/session.h"

namespace planish::cli {

/// Turns over the patches that are inside out against a neighbour along their seam, and names them
/// in a note. Seams along which two layers lie on each other, as of a facing on its panel, say
/// nothing of that.
/// @param tolerance of seams, as find_seams() has it
void turn_inside_out(std::vector<ProductPatch>& patches, double tolerance, Session& session);

}  // namespace planish::cli
