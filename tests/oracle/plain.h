#pragma once

// Slow and obviously right: every formula written out with one arctangent per angle, nothing kept
// from one call to the next. What the library does fast must agree with this.

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include <planish/mesh/tri_mesh.h>

#include "oracle/line_solver.h"
#include "oracle/model_search.h"
#include "oracle/series.h"

namespace planish::plain {

inline double angle_between(Vec3 a, Vec3 b) {
  return std::atan2(norm(cross(a, b)), dot(a, b));
}

/// A mesh with what is found by looking at all triangles.
struct Patch {
  TriMesh mesh;
  std::vector<std::vector<Index>> triangles_at;  // of each vertex
  std::vector<bool> inner;

  explicit Patch(TriMesh m) : mesh(std::move(m)), triangles_at(mesh.positions.size()) {
    std::map<std::pair<Index, Index>, int> sides;
    for (Index t = 0; t < mesh.triangles.size(); ++t) {
      for (int k = 0; k < 3; ++k) {
        const Index a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
        ++sides[{std::min(a, b), std::max(a, b)}];
        triangles_at[a].push_back(t);
      }
    }
    inner.assign(mesh.positions.size(), true);
    for (const auto& [side, count] : sides) {
      if (count == 1) inner[side.first] = inner[side.second] = false;
    }
    for (std::size_t v = 0; v < inner.size(); ++v) {
      if (triangles_at[v].empty()) inner[v] = false;
    }
  }

  /// The angle at v in triangle t.
  double angle(Index t, Index v) const {
    const Triangle& tri = mesh.triangles[t];
    const int k = tri[0] == v ? 0 : tri[1] == v ? 1 : 2;
    const Vec3 at = mesh.positions[v];
    return plain::angle_between(mesh.positions[tri[(k + 1) % 3]] - at,
                                mesh.positions[tri[(k + 2) % 3]] - at);
  }

  double angle_sum(Index v) const {
    double sum = 0.0;
    for (const Index t : triangles_at[v])
      sum += angle(t, v);
    return sum;
  }

  /// d_v
  double defect(Index v) const { return 2.0 * std::numbers::pi - angle_sum(v); }

  /// Counter-clockwise, for inner v.
  std::vector<Index> ring(Index v) const {
    std::map<Index, Index> next;
    for (const Index t : triangles_at[v]) {
      const Triangle& tri = mesh.triangles[t];
      const int k = tri[0] == v ? 0 : tri[1] == v ? 1 : 2;
      next[tri[(k + 1) % 3]] = tri[(k + 2) % 3];
    }
    std::vector<Index> ring{next.begin()->first};
    while (next[ring.back()] != ring.front())
      ring.push_back(next[ring.back()]);
    return ring;
  }

  /// L(v), Eq. 9 with the paper's weights.
  Vec3 laplacian(Index v) const {
    double total = 0.0;
    for (const Index j : ring(v))
      total += norm(mesh.positions[j] - mesh.positions[v]);
    Vec3 mean;
    for (const Index j : ring(v)) {
      const double weight = norm(mesh.positions[j] - mesh.positions[v]) / total;
      mean += weight * mesh.positions[j];
    }
    return mean - mesh.positions[v];
  }

  /// b_v with v at x (Eq. 13 with the sum over inner neighbours only).
  double ring_energy(Index v, Vec3 x) const {
    Patch moved = *this;
    moved.mesh.positions[v] = x;
    double b = moved.defect(v) * moved.defect(v);
    for (const Index j : ring(v)) {
      if (inner[j]) b += moved.defect(j) * moved.defect(j);
    }
    return b;
  }

  /// b_v, b_v' and the Gauss-Newton curvature at v + lambda L, L frozen: Eq. 15 to 17 as printed
  /// but with L(v) for L(v_j) in Eq. 17 and the sum over inner neighbours.
  LinePoint along(Index v, Vec3 L, double lambda) const {
    Patch moved = *this;
    const Vec3 x = mesh.positions[v] + lambda * L;
    moved.mesh.positions[v] = x;
    const auto at = [&](Index j) { return moved.mesh.positions[j]; };
    const std::vector<Index> r = ring(v);
    const std::size_t n = r.size();
    double own_rate = 0.0;
    for (std::size_t j = 0; j < n; ++j) {  // Eq. 16
      const Vec3 p = x - at(r[j]), q = x - at(r[(j + 1) % n]);
      const double alpha = plain::angle_between(p, q);
      own_rate += -1.0 / std::sin(alpha) * (dot(p, L) + dot(q, L)) / (norm(p) * norm(q)) +
                  1.0 / std::tan(alpha) * (dot(p, L) / dot(p, p) + dot(q, L) / dot(q, q));
    }
    LinePoint b{lambda, 0.0, 0.0, 0.0};
    const auto add = [&b](double defect, double rate) {
      b.value += defect * defect;
      b.slope += -2.0 * defect * rate;
      b.curvature += 2.0 * rate * rate;
    };
    add(moved.defect(v), own_rate);
    for (std::size_t j = 0; j < n; ++j) {
      if (!inner[r[j]]) continue;
      double rate = 0.0;  // Eq. 17
      const Vec3 p = x - at(r[j]);
      for (const std::size_t m : {(j + n - 1) % n, (j + 1) % n}) {
        const Vec3 e = at(r[m]) - at(r[j]);
        const double beta = plain::angle_between(p, e);
        rate += -1.0 / std::sin(beta) * dot(e, L) / (norm(p) * norm(e)) +
                1.0 / std::tan(beta) * dot(p, L) / dot(p, p);
      }
      add(moved.defect(r[j]), rate);
    }
    return b;
  }

  /// The defects that b_v is made of, with v at its place + t L.
  std::vector<Series> defects_along(Index v, Vec3 L) const {
    const auto place = [&](Index j) { return on_line(mesh.positions[j], j == v ? L : Vec3{}); };
    std::vector<Series> defects;
    std::vector<Index> vertices = ring(v);
    vertices.push_back(v);
    for (const Index w : vertices) {
      if (!inner[w]) continue;
      Series defect{{2.0 * std::numbers::pi}};
      for (const Index t : triangles_at[w]) {
        const Triangle& tri = mesh.triangles[t];
        const int k = tri[0] == w ? 0 : tri[1] == w ? 1 : 2;
        defect = defect - plain::angle_between(place(tri[(k + 1) % 3]) - place(w),
                                               place(tri[(k + 2) % 3]) - place(w));
      }
      defects.push_back(defect);
    }
    return defects;
  }

  double energy() const {
    double sum = 0.0;
    for (Index v = 0; v < inner.size(); ++v) {
      if (inner[v]) sum += defect(v) * defect(v);
    }
    return sum;
  }

  /// One controllable sweep in the given order; `accept_above` is the least fall of b_v that
  /// counts.
  void controllable_sweep(std::span<const Index> order, Interval steps, double accept_above) {
    for (const Index v : order) {
      const Vec3 L = laplacian(v), start = mesh.positions[v];
      const auto f = [&](double lambda) { return ring_energy(v, start + lambda * L); };
      const Found best = search_on_line(defects_along(v, L), f, steps);
      const Vec3 target = start + best.at * L;
      if (ring_energy(v, target) < ring_energy(v, start) - accept_above) {
        mesh.positions[v] = target;
      }
    }
  }
};

}  // namespace planish::plain
