#include <stdexcept>
#include <utility>

#include <planish/mesh/patch.h>

#include "mesh/edges.h"
#include "mesh/inspect_manifold.h"
#include "mesh/rings.h"

namespace planish {

namespace {

std::vector<std::vector<Index>> find_border_loops(const Rings& rings) {
  std::vector<std::vector<Index>> loops;
  std::vector<unsigned char> seen(rings.border.size(), 0);
  for (std::size_t v = 0; v < rings.border.size(); ++v) {
    if (rings.border[v] == 0 || seen[v] != 0) continue;
    std::vector<Index>& loop = loops.emplace_back();
    // An open ring begins at the next border vertex.
    for (auto at = static_cast<Index>(v); seen[at] == 0; at = rings.vertices[rings.start[at]]) {
      seen[at] = 1;
      loop.push_back(at);
    }
  }
  return loops;
}

std::shared_ptr<const Connectivity> connectivity_of(const TriMesh& mesh) {
  auto built = Connectivity::build(mesh);
  if (!built) {
    require(inspect(mesh), Purpose::measure);
    throw std::logic_error("inspect() finds nothing wrong with a mesh that has no rings");
  }
  return std::make_shared<const Connectivity>(*std::move(built));
}

}  // namespace

std::optional<Connectivity> Connectivity::build(const TriMesh& mesh) {
  auto rings = build_rings(mesh);
  if (!rings) return std::nullopt;
  Connectivity built;
  built.loops_ = find_border_loops(*rings);
  built.ring_start_ = std::move(rings->start);
  built.rings_ = std::move(rings->vertices);
  built.border_ = std::move(rings->border);
  for (std::size_t v = 0; v < built.border_.size(); ++v) {
    if (built.is_inner(static_cast<Index>(v))) built.inner_.push_back(static_cast<Index>(v));
  }
  return built;
}

Patch::Patch()
    : mesh_(std::make_shared<const TriMesh>()),
      connectivity_(std::make_shared<const Connectivity>()),
      inspection_(inspect(*mesh_)) {}

Patch::Patch(TriMesh mesh)
    : mesh_(std::make_shared<const TriMesh>(std::move(mesh))),
      connectivity_(connectivity_of(*mesh_)),
      inspection_(inspect_manifold(*mesh_, *connectivity_)),
      unit_scale_(planish::unit_scale(*mesh_)) {}

Patch::Patch(const Patch& other, std::vector<Vec3> positions)
    : mesh_(std::make_shared<const TriMesh>(TriMesh{std::move(positions), other.triangles()})),
      connectivity_(other.connectivity_),
      inspection_(inspect_moved(other.inspection_, *mesh_, *connectivity_)),
      unit_scale_(planish::unit_scale(*mesh_)) {}

Patch Patch::with_positions(std::vector<Vec3> positions) const {
  if (positions.size() != vertex_count())
    throw std::logic_error("with_positions() takes one position per vertex");
  return {*this, std::move(positions)};
}

std::vector<Edge> Patch::edges() const {
  std::vector<Edge> edges;
  edges.reserve(inspection_.topology.edges);
  for_each_edge(*connectivity_, [&](const Edge& edge) { edges.push_back(edge); });
  return edges;
}

}  // namespace planish
