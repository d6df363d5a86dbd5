#pragma once

#include <string>

#include <planish/mesh/patch.h>

#include "shell/command.h"

namespace planish::cli {

/// --scale, for verbs that work on a model.
Flag scale_flag();

/// What coordinates of files are multiplied with: --scale, 1 without it.
/// @throws UsageError for what is no number, Error option_out_of_range
double scale_from(const Arguments& arguments);

/// The mesh with all coordinates multiplied.
/// @param path of its file, for errors
/// @throws Error non_finite_coordinate
TriMesh scaled(TriMesh mesh, double scale, const std::string& path);

/// The mesh in the coordinates of its file, in which drawings over it are.
TriMesh as_in_file(TriMesh mesh, const Arguments& arguments);
/// The same of a patch.
Patch as_in_file(const Patch& patch, const Arguments& arguments);

}  // namespace planish::cli
