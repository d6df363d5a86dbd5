#pragma once

#include <string>
#include <vector>

#include <planish/core/error.h>
#include <planish/mesh/patch.h>
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

/// The lines of all values of --cut: rows, files, planes, creases, a cut graph.
/// @throws Error misplaced_cut, or as read_cut_lines(); UsageError
RequestedLines requested_lines(const Patch& patch, const Arguments& arguments);

}  // namespace planish::cli
