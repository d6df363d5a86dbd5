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

/// The plane that "x=0" or "y=12mm" names, in the coordinates of the file.
/// @param flag,kind what stands before it, for errors: "--cut" and "plane "
/// @throws UsageError; Error option_out_of_range
Plane axis_plane(const std::string& flag, const std::string& kind, const std::string& text,
                 const Arguments& arguments);

/// Whether a value of --cut is `open`.
bool asks_to_open(const Arguments& arguments);

/// Whether a value of --cut is `auto`: the surface is divided into panels.
bool asks_for_panels(const Arguments& arguments);

/// Whether a value of --cut is anything else.
bool asks_for_lines(const Arguments& arguments);

/// The lines of all values of --cut but `open` and `auto`: rows, files, and what words ask for,
/// docs/lines.md.
/// @param patch in the coordinates of its file
/// @param path of that file
/// @throws Error misplaced_cut, or as read_cut_lines(); UsageError
RequestedLines requested_lines(const Patch& patch, const std::string& path,
                               const Arguments& arguments);

}  // namespace planish::cli
