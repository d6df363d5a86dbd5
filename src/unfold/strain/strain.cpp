#include <algorithm>
#include <cmath>
#include <utility>

#include <planish/unfold/strain.h>

#include "core/math.h"
#include "core/neumaier_sum.h"
#include "mesh/edges.h"
#include "unfold/strain/free_edges.h"
#include "unfold/strain/strain_of_edge.h"
#include "unfold/strain/strain_of_edges.h"

namespace planish {

namespace {

double area_of(const TriMesh& mesh, double scale, Index a, Index b, Index c) {
  const Vec3 x = scale * mesh.positions[a];
  return 0.5 * norm(cross(scale * mesh.positions[b] - x, scale * mesh.positions[c] - x));
}

double total_area(const std::vector<StrainOfEdge>& edges) {
  NeumaierSum area;
  for (const StrainOfEdge& edge : edges)
    area.add(edge.area);
  return area.value();
}

std::vector<StrainOfEdge> sorted_by_size(std::vector<StrainOfEdge> edges) {
  std::stable_sort(edges.begin(), edges.end(), [](const StrainOfEdge& a, const StrainOfEdge& b) {
    return std::abs(a.strain) < std::abs(b.strain);
  });
  return edges;
}

double at_share_of_sorted(const std::vector<StrainOfEdge>& edges, double share) {
  const double enough = share * total_area(edges);
  NeumaierSum area;
  for (const StrainOfEdge& edge : edges) {
    area.add(edge.area);
    if (area.value() >= enough) return std::abs(edge.strain);
  }
  return edges.empty() ? 0.0 : std::abs(edges.back().strain);
}

/// Of each strain the part of that kind, by its size.
/// @param sorted the same edges, by |strain|
std::vector<StrainOfEdge> sorted_parts(const std::vector<StrainOfEdge>& edges,
                                       const std::vector<StrainOfEdge>& sorted, Criterion what) {
  std::vector<StrainOfEdge> parts;
  parts.reserve(edges.size());
  const auto add = [&](const std::vector<StrainOfEdge>& some, bool with_part) {
    for (const StrainOfEdge& edge : some) {
      const double part = part_of(edge.strain, what);
      if ((part > 0.0) == with_part) parts.push_back({part, edge.area, edge.edge});
    }
  };
  add(edges, false);
  add(sorted, true);
  return parts;
}

double share_beyond(const std::vector<StrainOfEdge>& edges, const LimitCheck& check) {
  NeumaierSum beyond, all;
  for (const StrainOfEdge& edge : edges) {
    all.add(edge.area);
    if (part_of(edge.strain, check.what) > check.limit) beyond.add(edge.area);
  }
  return all.value() > 0.0 ? beyond.value() / all.value() : 0.0;
}

/// The first edge with most of what the limit is for.
std::array<Index, 2> worst_edge(const std::vector<StrainOfEdge>& edges, Criterion what) {
  const auto worst = std::max_element(edges.begin(), edges.end(),
                                      [what](const StrainOfEdge& a, const StrainOfEdge& b) {
                                        return part_of(a.strain, what) < part_of(b.strain, what);
                                      });
  return worst == edges.end() ? std::array<Index, 2>{} : worst->edge;
}

}  // namespace

double part_of(double strain, Criterion what) {
  switch (what) {
    case Criterion::stretch:
    case Criterion::p99_stretch:
      return std::max(0.0, -strain);
    case Criterion::compression:
    case Criterion::p99_compression:
      return std::max(0.0, strain);
    default:
      return std::abs(strain);
  }
}

std::vector<StrainOfEdge> strain_of_edges(const Patch& patch, std::span<const Vec2> pattern) {
  const double scale = patch.unit_scale();
  std::vector<StrainOfEdge> edges;
  for_each_edge(patch.connectivity(), [&](const Edge& edge) {
    const auto [v, w, left, right] = edge;
    double area = 0.0;
    if (right != Edge::none) area += area_of(patch.mesh(), scale, v, right, w);
    if (left != Edge::none) area += area_of(patch.mesh(), scale, v, w, left);
    edges.push_back({strain_of_edge(patch.mesh(), pattern, scale, v, w), area / 3.0, {v, w}});
  });
  if (!(total_area(edges) > 0.0)) {
    for (StrainOfEdge& edge : edges)
      edge.area = 1.0;
  }
  return edges;
}

double strain_at_share(std::vector<StrainOfEdge> edges, double share) {
  return at_share_of_sorted(sorted_by_size(std::move(edges)), share);
}

EdgeStrain figures_of(const std::vector<StrainOfEdge>& edges) {
  constexpr double share = 0.99;
  EdgeStrain result;
  if (edges.empty()) return result;
  result.worst_edge = edges.front().edge;
  NeumaierSum squares;
  for (const StrainOfEdge& edge : edges) {
    if (std::abs(edge.strain) > result.max) {
      result.max = std::abs(edge.strain);
      result.worst_edge = edge.edge;
    }
    result.max_stretch = std::max(result.max_stretch, -edge.strain);
    result.max_compression = std::max(result.max_compression, edge.strain);
    squares.add(edge.area * edge.strain * edge.strain);
  }
  result.rms = std::sqrt(squares.value() / total_area(edges));
  const std::vector<StrainOfEdge> sorted = sorted_by_size(edges);
  const auto of_part = [&](Criterion what) {
    return at_share_of_sorted(sorted_parts(edges, sorted, what), share);
  };
  result.p99 = at_share_of_sorted(sorted, share);
  result.p99_stretch = of_part(Criterion::p99_stretch);
  result.p99_compression = of_part(Criterion::p99_compression);
  return result;
}

EdgeStrain edge_strain(const Patch& patch, std::span<const Vec2> pattern) {
  return figures_of(strain_of_edges(patch, pattern));
}

std::vector<LimitCheck> check_limits(const Patch& patch, std::span<const Vec2> pattern,
                                     const StrainLimits& limits) {
  require(limits);
  if (!limits.any()) return {};
  const std::vector<StrainOfEdge> edges = strain_of_edges(patch, pattern);
  std::vector<LimitCheck> checks = check_limits(figures_of(edges), limits);
  for (LimitCheck& check : checks) {
    const auto [v, w] = check.edge = worst_edge(edges, check.what);
    check.at = 0.5 * patch.positions()[v] + 0.5 * patch.positions()[w];
    check.share_beyond = share_beyond(edges, check);
  }
  return checks;
}

double largest_border_strain(const Patch& patch, std::span<const Vec2> pattern,
                             std::span<const std::array<Index, 2>> free_edges) {
  const FreeEdges free(free_edges);
  const double scale = patch.unit_scale();
  double largest = 0.0;
  for (const std::vector<Index>& loop : patch.border_loops()) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Index v = loop[k], w = loop[(k + 1) % loop.size()];
      if (free.has(v, w)) continue;
      largest = std::max(largest, std::abs(strain_of_edge(patch.mesh(), pattern, scale, v, w)));
    }
  }
  return largest;
}

std::vector<PrincipalStretch> principal_stretches(const TriMesh& mesh,
                                                  std::span<const Vec2> pattern) {
  const double scale = unit_scale(mesh);
  std::vector<PrincipalStretch> stretches;
  stretches.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    const Vec3 x = scale * mesh.positions[t[0]];
    const Vec3 a = scale * mesh.positions[t[1]] - x, b = scale * mesh.positions[t[2]] - x;
    const double length = norm(a), height = norm(cross(a, b)) / length;
    PrincipalStretch& stretch = stretches.emplace_back();
    if (!(height > 0.0) || !std::isfinite(height)) continue;
    const double along = dot(a, b) / length;
    // The map as a matrix in the frame of a and the normal to it in the triangle.
    const Vec2 p = (scale / length) * (pattern[t[1]] - pattern[t[0]]);
    const Vec2 q = (1.0 / height) * (scale * (pattern[t[2]] - pattern[t[0]]) - along * p);
    const double turn = 0.5 * math::hypot(p.x + q.y, p.y - q.x);
    const double flip = 0.5 * math::hypot(p.x - q.y, p.y + q.x);
    stretch = {turn + flip, turn - flip};
  }
  return stretches;
}

std::vector<double> signed_strains(std::span<const PrincipalStretch> stretches) {
  std::vector<double> strains;
  strains.reserve(stretches.size());
  for (const PrincipalStretch& s : stretches) {
    const double longer = s.max - 1.0, shorter = s.min - 1.0;
    strains.push_back(std::abs(longer) >= std::abs(shorter) ? longer : shorter);
  }
  return strains;
}

}  // namespace planish
