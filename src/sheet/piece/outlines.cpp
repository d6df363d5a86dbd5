#include "sheet/piece/outlines.h"

namespace planish {

std::vector<std::vector<Index>> outlines(const HalfEdges& mesh,
                                         const std::function<bool(std::size_t)>& in_part) {
  const auto is_inside = [&](Index h) { return h != HalfEdges::none && in_part(h / 3); };
  std::vector<bool> done(mesh.size(), false);
  std::vector<std::vector<Index>> loops;
  for (Index first = 0; first < mesh.size(); ++first) {
    if (done[first] || !is_inside(first) || is_inside(mesh.twin(first))) continue;
    std::vector<Index>& loop = loops.emplace_back();
    for (Index h = first; !done[h];) {
      done[h] = true;
      loop.push_back(mesh.from(h));
      // Turn about the end of h through the triangles of the part until one ends it.
      h = HalfEdges::next(h);
      while (is_inside(mesh.twin(h)))
        h = HalfEdges::next(mesh.twin(h));
    }
  }
  return loops;
}

}  // namespace planish
