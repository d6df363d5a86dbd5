#include <stdexcept>

#include <planish/mesh/connectivity.h>
#include <planish/mesh/inspect.h>

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

}  // namespace

Connectivity::Connectivity(const TriMesh& mesh) {
  auto rings = build_rings(mesh);
  if (!rings) {
    require(inspect(mesh), Purpose::measure);
    throw std::logic_error("inspect() finds nothing wrong with a mesh that has no rings");
  }
  loops_ = find_border_loops(*rings);
  ring_start_ = std::move(rings->start);
  rings_ = std::move(rings->vertices);
  border_ = std::move(rings->border);
  for (std::size_t v = 0; v < border_.size(); ++v) {
    if (is_inner(static_cast<Index>(v))) inner_.push_back(static_cast<Index>(v));
  }
}

}  // namespace planish
