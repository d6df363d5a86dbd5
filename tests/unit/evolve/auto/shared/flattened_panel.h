#pragma once

#include <cstddef>

#include <planish/evolve/evolve.h>
#include <planish/mesh/shapes.h>

namespace planish {

/// The panel of that size made flattenable, to be disturbed.
inline TriMesh flattened_panel(std::size_t vertices) {
  TriMesh mesh = make_shape("panel", vertices);
  mesh.positions = evolve(Patch(mesh), Auto{.prefer = Prefer::near}).positions;
  return mesh;
}

}  // namespace planish
