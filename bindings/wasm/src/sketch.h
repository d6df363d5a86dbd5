#pragma once

#include <span>
#include <string>
#include <vector>

#include <planish/core/vec.h>
#include <planish/mesh/tri_mesh.h>

#include "mesh/split.h"

namespace planish::wasm {

/// A piece of a sketch, laid flat.
struct SketchPiece {
  std::string name;
  TriMesh surface;            ///< as it is in space, model units
  TriMesh pattern;            ///< with z = 0, model units; empty where the piece has no pattern yet
  std::vector<float> strain;  ///< signed_strains() of its triangles; 0 without a pattern
};

/// What lines make of a model.
struct SketchPieces {
  std::vector<SketchPiece> pieces;
  std::string hint;  ///< what the program says of the lines, or why a piece has no pattern
};

/// A model on few of its vertices, quick to cut and to lay flat: its pieces are nearly those of the
/// program, with the names that it gives them.
class Sketch {
 public:
  /// @param paths of the model's files, one at least
  /// @throws Error as read_mesh() and prepare_model()
  explicit Sketch(std::span<const std::string> paths);

  /// Cuts as the words say, and lays each piece flat with the least stretch. A piece that the last
  /// call made too comes as it was then. A model of several files is not cut.
  /// @param words of `flatten`, with the model and its cuts
  /// @throws UsageError
  SketchPieces laid(const std::vector<std::string>& words);

 private:
  struct Part {
    std::string path;
    TriMesh mesh;
  };

  TriMesh cut(const Part& part, const std::vector<std::string>& words, SketchPieces& made) const;
  SketchPiece laid(NamedPatch part, std::string& hint) const;

  std::vector<Part> parts_;
  std::vector<SketchPiece> last_;
};

}  // namespace planish::wasm
