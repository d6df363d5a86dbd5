#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <planish/mesh/patch.h>
#include <planish/mesh/surface_line.h>

namespace planish::wasm {

/// x, y, z of all vertices, model units.
std::vector<float> coordinates_of(const TriMesh& mesh);
/// Three vertices of each triangle.
std::vector<Index> corners_of(const TriMesh& mesh);

/// How nearly a surface is its own mirror image.
struct SymmetryFound {
  Plane plane;                ///< its normal has length 1; model units
  double share = 0.0;         ///< Symmetry::largest, of the diagonal
  bool is_symmetric = false;  ///< whether that counts as symmetric
};

/// The surface of a model as the verbs of the program work on it, kept while lines are drawn on it.
/// Several files are the parts of one product.
class Surface {
 public:
  /// Reads and mends the model. Parts get the unit of the first one that states its own.
  /// @param paths of its files, one at least
  /// @throws Error as read_mesh() and prepare_model()
  explicit Surface(std::span<const std::string> paths);

  const TriMesh& mesh() const { return patch_.mesh(); }
  /// How many pieces the files have.
  std::size_t pieces() const { return pieces_; }
  /// That the files state, as flags have it; empty where it states none.
  std::string_view unit() const { return unit_; }

  /// The line that `--cut "line ..."` draws through these places: shortest ways between them.
  /// @param places x, y, z of each, model units; two at least
  /// @return x, y, z of its points, model units
  /// @throws Error as geodesic()
  std::vector<double> line(std::span<const double> places) const;
  /// @throws Error as find_symmetry()
  SymmetryFound symmetry() const;

 private:
  Patch patch_;
  std::size_t pieces_ = 0;
  std::string_view unit_;
};

/// A piece that the program laid flat.
struct LaidPiece {
  TriMesh surface;            ///< as it is in space, model units
  TriMesh pattern;            ///< with z = 0, the unit of the pattern's mesh
  std::vector<float> strain;  ///< signed_strains() of its triangles
};

/// @param surface,pattern files that `flatten` wrote: processed.obj and flat.obj
/// @throws Error as read_mesh(); malformed_file where they have other triangles
LaidPiece laid_piece(const std::string& surface, const std::string& pattern);

}  // namespace planish::wasm
