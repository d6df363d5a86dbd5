#pragma once

#include <cstddef>
#include <map>
#include <string>

#include <planish/core/unit.h>
#include <planish/mesh/carry.h>
#include <planish/mesh/patch.h>

namespace planish::cli {

bool is_svg(const std::string& path);

/// What was drawn, in model units over a mesh.
struct ReadDrawing {
  DrawnLines drawn;
  std::map<std::string, std::size_t> left_out;  ///< elements that are no lines, by their kind
};

/// What was added to a pattern's sheet, on layers of its own, where it lies over the flat mesh.
/// @throws Error as read_svg(); malformed_file where nothing was added, and where the outline on
/// the
///   sheet is not that of the mesh
ReadDrawing drawing_on_sheet(const std::string& path, const Patch& flat, Unit unit);

/// The pattern that a drawing lies on: the flat mesh beside the file, as flatten writes it, where
/// it has the triangles of the patch; else the patch laid flat as it is.
/// @param scale model units of the patch times it are those of the run
/// @throws Error as unfold()
Patch pattern_below(const std::string& path, const Patch& patch, double scale);

}  // namespace planish::cli
