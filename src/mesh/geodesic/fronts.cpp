#include "mesh/geodesic/fronts.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "mesh/half_edges.h"

namespace planish {

namespace {

constexpr double k_unreached = std::numeric_limits<double>::infinity();

/// When a plane wave that reaches a at `first` and b at `second`, not before it, reaches c; along
/// the edges where it does not come through the side from a to b.
double reached_through(Vec3 c, Vec3 a, double first, Vec3 b, double second) {
  const Vec3 to_a = a - c, to_b = b - c;
  const double near = norm(to_a), far = norm(to_b), later = second - first;
  const double along = std::min(first + near, second + far);
  if (!(near > 0.0) || !(far > 0.0)) return along;
  const double cosine = dot(to_a, to_b) / (near * far), sine_squared = 1.0 - cosine * cosine;
  const double square = far * far + near * near - 2.0 * near * far * cosine;
  const double linear = 2.0 * near * later * (far * cosine - near);
  const double constant = near * near * (later * later - far * far * sine_squared);
  const double root = linear * linear - 4.0 * square * constant;
  if (!(root >= 0.0) || !(square > 0.0)) return along;
  const double time = (-linear + std::sqrt(root)) / (2.0 * square);
  const double share = near * (time - later) / time;
  if (!(later < time) || !(share > far * cosine) || !(share * cosine < far)) return along;
  return std::min(along, first + time);
}

}  // namespace

std::vector<double> distances_from(const Patch& patch, std::span<const Index> sources) {
  const HalfEdges half_edges(patch.mesh());
  const double scale = patch.unit_scale();
  const auto at = [&](Index v) { return scale * patch.positions()[v]; };
  std::vector<double> distance(patch.vertex_count(), k_unreached);
  std::vector<unsigned char> done(patch.vertex_count(), 0);
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto reach = [&](Index v, double time) {
    if (!(time < distance[v])) return;
    distance[v] = time;
    queue.emplace(time, v);
  };
  for (const Index v : sources)
    reach(v, 0.0);
  while (!queue.empty()) {
    const Index v = queue.top().second;
    queue.pop();
    if (done[v] != 0 || !half_edges.is_used(v)) continue;
    done[v] = 1;
    half_edges.for_each_neighbor(v, [&](Index w) { reach(w, distance[v] + norm(at(w) - at(v))); });
    half_edges.for_each_corner(v, [&](Index h) {
      const Index b = half_edges.to(h), c = half_edges.apex(h);
      for (const auto& [known, open] : {std::pair{b, c}, std::pair{c, b}}) {
        if (done[known] == 0 || done[open] != 0) continue;
        reach(open, reached_through(at(open), at(known), distance[known], at(v), distance[v]));
      }
    });
  }
  for (double& some : distance)
    some /= scale;
  return distance;
}

double front_length(const TriMesh& mesh, std::span<const double> distances, double at) {
  double length = 0.0;
  for (const Triangle& t : mesh.triangles) {
    std::vector<Vec3> ends;
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = t[k], w = t[(k + 1) % 3];
      if ((distances[v] < at) == (distances[w] < at)) continue;
      if (!std::isfinite(distances[v] + distances[w])) continue;
      const double share = (at - distances[v]) / (distances[w] - distances[v]);
      ends.push_back(mesh.positions[v] + share * (mesh.positions[w] - mesh.positions[v]));
    }
    if (ends.size() == 2) length += norm(ends[1] - ends[0]);
  }
  return length;
}

}  // namespace planish
