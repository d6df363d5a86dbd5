#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <planish/io/model.h>
#include <planish/mesh/tri_mesh.h>

namespace planish::cli {

/// A piece of what was read, at its place beside the others.
struct PlacedPiece {
  std::string name;
  TriMesh mesh;
  std::size_t group = 0;  ///< as ProductPatch has it
  bool is_taken = true;   ///< false: not used, but the others are compared with it
};

/// Which pieces of a run are inside out.
struct InsideOut {
  std::vector<std::size_t> turned;  ///< numbers of those to be turned over, increasing
  std::vector<std::string> notes;   ///< what to tell
};

/// Finds the pieces that are inside out against a neighbour along their seam, of all that were
/// read, and names those that are taken. Seams along which two layers lie on each other, as of a
/// facing on its panel, say nothing of that.
/// @param tolerance of seams, as find_seams() has it
/// @param strict nothing is to be turned; a note says so
InsideOut pieces_inside_out(std::span<const PlacedPiece> pieces, double tolerance, bool strict);

/// Turns the one piece of a model over where it is inside out against one that is left out.
/// Models of several pieces, and those of which nothing is left out, stay as they are.
/// @param options that the model was prepared with
/// @return what to tell
std::vector<std::string> turn_inside_out(Model& model, const ModelOptions& options);

}  // namespace planish::cli
