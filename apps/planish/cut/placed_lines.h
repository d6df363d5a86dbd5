#pragma once

#include <span>
#include <string>
#include <vector>

#include <planish/core/context.h>
#include <planish/mesh/patch.h>
#include <planish/mesh/surface_line.h>

#include "shell/command.h"

namespace planish::cli {

/// One value of a flag, divided at its blanks: what it asks for, then of what.
struct LineWords {
  std::string value;               ///< whole, for errors
  std::vector<std::string> words;  ///< one at least
};

/// "line x,y,z x,y,z ...": shortest ways between the places nearest to the points. A place may also
/// be the number of a vertex.
/// @throws UsageError for what is no place; Error index_out_of_range, as geodesic()
SurfaceLine shortest_line(const Patch& patch, const LineWords& asked, const Arguments& arguments);

/// "straight x,y,z x,y,z [LENGTH]": goes straight on from the first place towards the second one;
/// without a length so far as this is through space.
/// @throws as shortest_line()
SurfaceLine straight_line(const Patch& patch, const LineWords& asked, const Arguments& arguments);

/// "ring x,y,z" or "ring 340": ring_at().
/// @throws as shortest_line(); Error misplaced_cut where there is none
SurfaceLine ring_line(const Patch& patch, const LineWords& asked, const Arguments& arguments);

/// The plane that "x=0" or "y=12mm" names, in the coordinates of the file.
/// @param flag,kind what stands before it, for errors: "--cut" and "plane "
/// @throws UsageError; Error option_out_of_range
Plane axis_plane(const std::string& flag, const std::string& kind, const std::string& text,
                 const Arguments& arguments);

}  // namespace planish::cli
