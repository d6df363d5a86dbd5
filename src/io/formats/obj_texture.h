#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <planish/core/vec.h>
#include <planish/mesh/tri_mesh.h>

namespace planish {

/// A corner of a face, and where it lies in the texture; nothing where the file does not say it.
struct TexturedCorner {
  Index vertex = 0;
  std::optional<Vec2> place = {};
};

/// A face as the file has it.
struct TexturedFace {
  std::vector<TexturedCorner> corners;
  std::size_t line = 0;  ///< of the file
};

/// The faces of an OBJ file with its texture coordinates (vt).
struct ObjTexture {
  std::vector<Vec3> positions;
  std::vector<TexturedFace> faces;
};

/// @param name stands for the path in errors
/// @throws Error as parse_mesh(); misplaced_cut where the file has no texture coordinates
ObjTexture parse_obj_texture(std::string_view bytes, const std::string& name);

}  // namespace planish
