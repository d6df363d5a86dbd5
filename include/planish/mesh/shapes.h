#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include <planish/mesh/tri_mesh.h>

namespace planish {

/// A built-in patch made by formula.
struct Shape {
  std::string_view name;         ///< as make_shape() takes it
  std::string_view description;  ///< a few words
  /// True where the triangle mesh itself can be laid flat without stretch.
  bool flattenable;
};

/// All built-in patches: panel, saddle, dome, cylinder, cone, tangent.
std::span<const Shape> shapes();

/// Makes the named patch with about the asked number of vertices (within a row of its grid),
/// jittered like a real mesh, in millimetres, a few hundred across. The same name and number always
/// give the same mesh.
/// @param vertices 100 to 10'000'000
/// @throws Error unknown_name, option_out_of_range
TriMesh make_shape(std::string_view name, std::size_t vertices);

}  // namespace planish
