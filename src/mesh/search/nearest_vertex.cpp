#include "mesh/search/nearest_vertex.h"

#include <algorithm>
#include <limits>

#include "geometry/box.h"

namespace planish {

namespace {

double along(Vec3 p, int axis) {
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

}  // namespace

NearestVertex::NearestVertex(const TriMesh& mesh, const std::vector<Vec3>& places) : mesh_(mesh) {
  std::vector<unsigned char> used(mesh.positions.size(), 0);
  for (const Triangle& triangle : mesh.triangles) {
    for (const Index v : triangle)
      used[v] = 1;
  }
  Box box;
  for (const Vec3 p : places)
    box.add(p);
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (used[v] == 0) continue;
    vertices_.push_back(static_cast<Index>(v));
    box.add(mesh.positions[v]);
  }
  scale_ = unit_scale(box);
  split(0, vertices_.size(), 0);
}

void NearestVertex::split(std::size_t begin, std::size_t end, int axis) {
  if (end - begin < 2) return;
  const auto at = [&](std::size_t i) { return vertices_.begin() + static_cast<std::ptrdiff_t>(i); };
  const std::size_t middle = begin + (end - begin) / 2;
  std::nth_element(at(begin), at(middle), at(end), [&](Index v, Index w) {
    const double x = along(mesh_.positions[v], axis), y = along(mesh_.positions[w], axis);
    return x != y ? x < y : v < w;
  });
  split(begin, middle, (axis + 1) % 3);
  split(middle + 1, end, (axis + 1) % 3);
}

Index NearestVertex::of(Vec3 place) const {
  Candidate best{std::numeric_limits<double>::infinity(), std::numeric_limits<Index>::max()};
  search(0, vertices_.size(), 0, place, best);
  return best.vertex;
}

// Equally far vertices may stand on both sides, so a side is left out only if it is farther.
void NearestVertex::search(std::size_t begin, std::size_t end, int axis, Vec3 place,
                           Candidate& best) const {
  if (begin == end) return;
  const std::size_t middle = begin + (end - begin) / 2;
  const Vec3 p = mesh_.positions[vertices_[middle]];
  const Vec3 apart = scale_ * place - scale_ * p;
  best = std::min(best, {dot(apart, apart), vertices_[middle]});
  const double beyond = along(apart, axis);
  const int next = (axis + 1) % 3;
  if (beyond < 0.0) {
    search(begin, middle, next, place, best);
    if (beyond * beyond <= best.square) search(middle + 1, end, next, place, best);
  } else {
    search(middle + 1, end, next, place, best);
    if (beyond * beyond <= best.square) search(begin, middle, next, place, best);
  }
}

}  // namespace planish
