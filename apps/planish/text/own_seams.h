#pragma once

#include <planish/flatten/flatten.h>

#include "shell/session.h"

namespace planish::cli {

/// Whether two border vertices are at the same place, as those of an edge that is sewn to another
/// one are. Most patches have none, and need no search for seams.
bool meets_itself(const Patch& patch);

/// Says where two stretches of a patch's border that lie on each other on the model, and so are
/// sewn together, get unequally long in its pattern: by 0.5 mm and 0.5 % at least.
/// @param design with the vertices of the pattern
void note_unequal_seams(Session& session, const Patch& design, const UnfoldReport& report);

}  // namespace planish::cli
