#pragma once

#include <span>
#include <string>
#include <vector>

#include <planish/io/model.h>
#include <planish/mesh/repair.h>

namespace planish {

/// Where the sides of a wall lie of which one was taken.
struct WallSides {
  std::string name;  ///< of the part or piece
  double thickness = 0.0;
  std::vector<Vec3> taken = {}, other = {};  ///< vertices
};

/// A part of a file while it is prepared: what has one name, or the whole file.
struct ModelPart {
  static constexpr Index none = RepairedMesh::none;

  std::string name;
  TriMesh mesh;
  std::vector<Index> triangles;  ///< of each triangle: the one of the file, or none
  std::vector<Index> vertices;   ///< of the first vertices: those of the file; the rest are new
  double area_share = 0.0;       ///< of the file's area
  bool is_one_piece = false;     ///< known to be one, connected by edges
  std::vector<WallSides> walls = {};  ///< of which a side was taken
};

/// Mends a part and takes of it what the options ask for, but for names. What is done is counted.
void prepare_part(ModelPart& part, const ModelOptions& options, ModelWork& work);

/// Walls of which each one's taken side meets the other side of the other one, on both sides: they
/// were taken on different sides of one sheet. A wall that lies on another meets it on one side.
std::vector<ModelWork::ClashingSides> find_clashing_sides(std::span<const ModelPart> parts);

}  // namespace planish
