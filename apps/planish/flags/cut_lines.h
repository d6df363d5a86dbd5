#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <planish/core/error.h>
#include <planish/mesh/surface_line.h>

#include "shell/command.h"

namespace planish::cli {

/// Lines that --cut asks for on a mesh.
struct RequestedLines {
  std::vector<SurfaceLine> lines;
  std::vector<std::string> names;      ///< of each, for notes: "lines.obj:3", "plane x=0"
  std::vector<SourceLocation> places;  ///< of each, for errors
  std::vector<std::string> notes = {};
};

/// The lines of all values of --cut: files, planes ("plane x=0"), creases
/// ("creases 30deg"), a cut graph ("open").
/// @param patch in the coordinates of its file
/// @throws UsageError for words that are none of these, Error as read_cut_lines()
RequestedLines requested_lines(const Patch& patch, const Arguments& arguments);

}  // namespace planish::cli
