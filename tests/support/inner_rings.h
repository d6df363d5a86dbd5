#pragma once

#include <cstddef>
#include <vector>

#include <planish/mesh/patch.h>

#include "evolve/state/vertex_coloring.h"

namespace planish::meshes {

/// The rings of the inner vertices of a mesh, inner ones numbered first.
class InnerRingsOf {
 public:
  explicit InnerRingsOf(const TriMesh& mesh) {
    const Patch surface(mesh);
    const auto inner = surface.inner_vertices();
    vertex_of_.assign(inner.begin(), inner.end());
    std::vector<Index> number(mesh.positions.size(), static_cast<Index>(mesh.positions.size()));
    for (std::size_t i = 0; i < inner.size(); ++i)
      number[inner[i]] = static_cast<Index>(i);
    for (const Index v : inner) {
      for (const Index w : surface.ring(v))
        vertices_.push_back(number[w]);
      start_.push_back(vertices_.size());
    }
  }

  InnerRings view() const { return {start_, vertices_}; }
  /// The mesh's number.
  Index vertex_of(Index v) const { return vertex_of_[v]; }

 private:
  std::vector<Index> vertex_of_;
  std::vector<std::size_t> start_{0};
  std::vector<Index> vertices_;
};

}  // namespace planish::meshes
