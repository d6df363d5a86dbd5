#pragma once

#include <string>
#include <vector>

#include <planish/io/model.h>
#include <planish/mesh/repair.h>

namespace planish {

/// A part of a file while it is prepared: what has one name, or the whole file.
struct ModelPart {
  static constexpr Index none = RepairedMesh::none;

  std::string name;
  TriMesh mesh;
  std::vector<Index> triangles;  ///< of each triangle: the one of the file, or none
  std::vector<Index> vertices;   ///< of the first vertices: those of the file; the rest are new
  double area_share = 0.0;       ///< of the file's area
  bool is_one_piece = false;     ///< known to be one, connected by edges
};

/// Mends a part and takes of it what the options ask for, but for names. What is done is counted.
void prepare_part(ModelPart& part, const ModelOptions& options, ModelWork& work);

}  // namespace planish
