#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include <planish/measure/limit_check.h>
#include <planish/mesh/tri_mesh.h>
#include <planish/panels/suggest_panels.h>

namespace planish {

/// A surface and where the corners of its triangles lie in the plane.
struct UvMap {
  TriMesh mesh;
  std::vector<std::array<Vec2, 3>> corners;  ///< of each triangle
};

/// Reads an OBJ file with texture coordinates. Some programs write both sides of a cut: borders at
/// equal places are joined (weld()), so that the cut is where the texture jumps.
/// @throws Error as read_mesh(); misplaced_cut for a corner without a texture coordinate
UvMap read_uv_map(const std::filesystem::path& path);

/// The panels laid flat as suggest_panels() does without match_seams, side by side.
/// @throws Error unfold_failed for a panel without a pattern
UvMap uv_map_of(const PanelSuggestion& found, const StrainLimits& limits);

/// The bytes of an OBJ file: each panel a group, its texture coordinates, and the seams as lines.
std::string format_panels(const PanelSuggestion& found, const UvMap& map);

}  // namespace planish
