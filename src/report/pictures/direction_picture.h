#pragma once

#include <span>
#include <string>
#include <vector>

#include <planish/mesh/tri_mesh.h>

#include "draw/image.h"
#include "evolve/direction.h"

namespace planish {

/// A colour and what it means, plain text.
struct DirectionKey {
  Color color;
  std::string text;
};

/// A picture of the patch with its key.
struct DirectionPicture {
  std::string title;
  Image image;
  std::vector<DirectionKey> keys;
};

/// What each vertex is, and whether its Laplacian direction lowers the ring energy.
struct DirectionPictures {
  DirectionPicture classes, directions;
};

/// @param width of each, pixels
DirectionPictures direction_pictures(const TriMesh& mesh,
                                     std::span<const VertexDirection> directions, int width);

}  // namespace planish
