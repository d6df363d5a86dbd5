#include "panels/piece/panel_mesh.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/neumaier_sum.h"
#include "geometry/angle_between.h"
#include "geometry/cotangents.h"
#include "mesh/disjoint_sets.h"
#include "mesh/edge_sides.h"
#include "mesh/match/symmetric_whole.h"
#include "solve/dissection.h"

namespace planish {

PanelMesh::PanelMesh(Patch patch) : patch_(std::move(patch)) {
  const std::vector<Vec3>& x = patch_.positions();
  NeumaierSum area;
  for (const Triangle& t : triangles()) {
    areas_.push_back(0.5 * norm(cross(x[t[1]] - x[t[0]], x[t[2]] - x[t[0]])));
    area.add(areas_.back());
    std::array<double, 3> angle{}, cot{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 a = x[t[(i + 1) % 3]] - x[t[i]], b = x[t[(i + 2) % 3]] - x[t[i]];
      angle[i] = angle_between(a, b);
      cot[i] = cotangent(a, b);
    }
    angles_.push_back(angle);
    cotangents_.push_back(cot);
  }
  scale_ = area.value() > 0.0 ? 1.0 / std::sqrt(area.value()) : 1.0;
  for (double& part : areas_)
    part *= scale_ * scale_;
  pair_sides();
  NeumaierSum length;
  for (PanelEdge& edge : edges_) {
    edge.length = scale_ * norm(x[edge.ends[1]] - x[edge.ends[0]]);
    length.add(edge.length);
  }
  if (!edges_.empty()) mean_edge_ = length.value() / static_cast<double>(edges_.size());
  rank_vertices();
}

PanelMesh::PanelMesh(const Patch& half, const Plane& plane)
    : PanelMesh(Patch(with_mirror_image(half.mesh(), fold_vertices(half, plane), plane).mesh)) {
  plane_ = plane;
  image_.resize(edges_.size());
  for (Index t = 0; t < triangles().size() / 2; ++t) {
    // The image is turned over: its side from corner 0 is that to corner 0.
    const Index image = static_cast<Index>(t + triangles().size() / 2);
    for (std::size_t i = 0; i < 3; ++i) {
      const Index e = sides_[t][i], f = sides_[image][2 - i];
      image_[e] = f;
      image_[f] = e;
    }
  }
}

void PanelMesh::rank_vertices() {
  Graph graph;
  const auto count = static_cast<Index>(patch_.vertex_count());
  for (Index v = 0; v < count; ++v) {
    std::vector<Index> near(patch_.ring(v).begin(), patch_.ring(v).end());
    for (const Index w : patch_.ring(v))
      near.insert(near.end(), patch_.ring(w).begin(), patch_.ring(w).end());
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    std::erase(near, v);
    graph.neighbours.insert(graph.neighbours.end(), near.begin(), near.end());
    graph.start.push_back(graph.neighbours.size());
  }
  rank_.resize(count);
  const std::vector<Index> order = nested_dissection(patch_.positions(), graph);
  for (Index k = 0; k < count; ++k)
    rank_[order[k]] = k;
}

void PanelMesh::pair_sides() {
  sides_.resize(triangles().size());
  const std::vector<EdgeSide> sorted = sorted_sides(patch_.mesh());
  for (const EdgeSides& sides : group_by_edge(sorted)) {
    PanelEdge edge;
    edge.ends = {sides.begin->low, sides.begin->high};
    for (const EdgeSide* side = sides.begin; side < sides.end; ++side) {
      edge.triangles[static_cast<std::size_t>(side - sides.begin)] = side->triangle;
      sides_[side->triangle][side->corner] = static_cast<Index>(edges_.size());
    }
    edges_.push_back(edge);
  }
}

std::vector<bool> fold_vertices(const Patch& half, const Plane& plane) {
  const double most = k_on_plane * bounding_box_diagonal(half.mesh());
  const auto is_near = [&](Index v) {
    return std::abs(height_over(plane, half.positions()[v])) <= most;
  };
  std::vector<bool> on_fold(half.vertex_count(), false);
  for (const std::vector<Index>& loop : half.border_loops()) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Index v = loop[k], w = loop[(k + 1) % loop.size()];
      if (is_near(v) && is_near(w)) on_fold[v] = on_fold[w] = true;
    }
  }
  return on_fold;
}

double length_of(const PanelMesh& mesh, std::span<const Index> edges) {
  double length = 0.0;
  for (const Index e : edges)
    length += mesh.edges()[e].length;
  return length;
}

bool is_crease(const PanelMesh& mesh, const PanelEdge& edge) {
  constexpr double k_cosine = 0.8660254037844386;  // of 30 degrees
  if (edge.is_border()) return false;
  const auto normal = [&](Index triangle) {
    const Triangle& t = mesh.triangles()[triangle];
    const auto at = [&](std::size_t i) { return mesh.scale() * mesh.patch().positions()[t[i]]; };
    return cross(at(1) - at(0), at(2) - at(0));
  };
  const Vec3 a = normal(edge.triangles[0]), b = normal(edge.triangles[1]);
  return dot(a, b) <= k_cosine * norm(a) * norm(b);
}

double open_length(const PanelMesh& mesh, const OpenEdges& open) {
  NeumaierSum sum;
  for (std::size_t e = 0; e < open.size(); ++e) {
    if (open[e] != 0) sum.add(mesh.edges()[e].length);
  }
  return sum.value();
}

std::vector<int> open_edges_at(const PanelMesh& mesh, const OpenEdges& open) {
  std::vector<int> open_at(mesh.patch().vertex_count(), 0);
  for (std::size_t e = 0; e < open.size(); ++e) {
    if (open[e] == 0) continue;
    for (const Index v : mesh.edges()[e].ends)
      ++open_at[v];
  }
  return open_at;
}

std::size_t tips_of(const PanelMesh& mesh, std::span<const int> open_at) {
  std::size_t count = 0;
  for (Index v = 0; v < open_at.size(); ++v)
    count += open_at[v] == 1 && !mesh.patch().is_border(v) ? 1 : 0;
  return count;
}

std::vector<std::vector<Index>> open_parts(const PanelMesh& mesh, const OpenEdges& open,
                                           std::span<const Index> triangles) {
  std::vector<Index> place(mesh.triangles().size(), PanelEdge::none);
  for (Index k = 0; k < triangles.size(); ++k)
    place[triangles[k]] = k;
  DisjointSets<Index> sets(triangles.size());
  for (const Index t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Index e = mesh.edge_of(t, i), other = mesh.edges()[e].other(t);
      if (open[e] == 0 && other != PanelEdge::none && place[other] != PanelEdge::none)
        sets.join(place[t], place[other]);
    }
  }
  std::vector<std::vector<Index>> parts;
  std::vector<Index> part_of(triangles.size(), PanelEdge::none);
  for (Index k = 0; k < triangles.size(); ++k) {
    Index& part = part_of[sets.first_of(k)];
    if (part == PanelEdge::none) {
      part = static_cast<Index>(parts.size());
      parts.emplace_back();
    }
    parts[part].push_back(triangles[k]);
  }
  return parts;
}

std::vector<std::vector<Index>> open_parts(const PanelMesh& mesh, const OpenEdges& open) {
  std::vector<Index> all(mesh.triangles().size());
  std::iota(all.begin(), all.end(), Index{0});
  return open_parts(mesh, open, all);
}

}  // namespace planish
