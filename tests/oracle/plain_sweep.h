#pragma once

// The controllable sweep as the equations say it, for one vertex after another: what speed is
// compared with. Rings in compressed rows and nothing computed twice that the equations show at
// once, but one arctangent per angle and no other thought for the machine. Checked against Patch,
// which is slower and simpler still.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include <planish/mesh/patch.h>

#include "oracle/line_solver.h"

namespace planish::plain {

class Sweeper {
 public:
  Sweeper(std::vector<Vec3> positions, const Connectivity& connectivity)
      : connectivity_(connectivity),
        positions_(std::move(positions)),
        defects_(positions_.size(), 0.0) {
    for (const Index v : connectivity.inner_vertices())
      defects_[v] = defect(v);
  }

  const std::vector<Vec3>& positions() const { return positions_; }

  /// One controllable sweep in the given order; returns how many vertices moved.
  std::size_t sweep(std::span<const Index> order, Interval steps, double accept_above) {
    std::size_t moved = 0;
    for (const Index v : order)
      moved += visit(v, steps, accept_above) ? 1 : 0;
    for (const Index v : order)
      defects_[v] = defect(v);
    return moved;
  }

 private:
  struct Angle {
    double size, rate;  // radians; its change along the line
  };

  static double angle_between(Vec3 a, Vec3 b) { return std::atan2(norm(cross(a, b)), dot(a, b)); }

  double defect(Index v) const {
    const auto ring = connectivity_.ring(v);
    double sum = 0.0;
    Vec3 previous = positions_[ring.back()] - positions_[v];
    for (const Index j : ring) {
      const Vec3 next = positions_[j] - positions_[v];
      sum += angle_between(previous, next);
      previous = next;
    }
    return 2.0 * std::numbers::pi - sum;
  }

  /// The angle at x between v_j and v_(j+1), and Eq. 16 for it: p = x - v_j, q = x - v_(j+1).
  static Angle apex(Vec3 p, Vec3 q, Vec3 L) {
    const double s = norm(cross(p, q)), c = dot(p, q);
    const double rate =
        (-(dot(p, L) + dot(q, L)) + c * (dot(p, L) / dot(p, p) + dot(q, L) / dot(q, q))) / s;
    return {std::atan2(s, c), rate};
  }

  /// The angle at v_j between x and v_m, and Eq. 17 for it: p = x - v_j, e = v_m - v_j.
  static Angle base(Vec3 p, Vec3 e, Vec3 L) {
    const double s = norm(cross(p, e)), c = dot(p, e);
    return {std::atan2(s, c), (-dot(e, L) + c * dot(p, L) / dot(p, p)) / s};
  }

  /// b along the line (Eq. 13 and 15, corrected), given the angles at the neighbours without x.
  LinePoint along(Index v, Vec3 L, double lambda) {
    const auto ring = connectivity_.ring(v);
    const std::size_t n = ring.size();
    const Vec3 x = positions_[v] + lambda * L;
    const auto at = [&](std::size_t j) { return positions_[ring[j]]; };
    LinePoint b{lambda, 0.0, 0.0, 0.0};
    const auto add = [&b](double defect, double rate) {
      b.value += defect * defect;
      b.slope -= 2.0 * defect * rate;
      b.curvature += 2.0 * rate * rate;
    };
    Angle own{0.0, 0.0};
    for (std::size_t j = 0; j < n; ++j) {
      const Angle angle = apex(x - at(j), x - at(j + 1 < n ? j + 1 : 0), L);
      own.size += angle.size, own.rate += angle.rate;
    }
    own_ = 2.0 * std::numbers::pi - own.size;
    add(own_, own.rate);
    for (std::size_t j = 0; j < n; ++j) {
      if (!connectivity_.is_inner(ring[j])) continue;
      const Vec3 p = x - at(j);
      const Angle one = base(p, at(j + 1 < n ? j + 1 : 0) - at(j), L);
      const Angle other = base(p, at(j > 0 ? j - 1 : n - 1) - at(j), L);
      changed_[j] = rest_[j] - one.size - other.size;
      add(changed_[j], one.rate + other.rate);
    }
    return b;
  }

  bool visit(Index v, Interval steps, double accept_above) {
    const auto ring = connectivity_.ring(v);
    const std::size_t n = ring.size();
    rest_.assign(n, 0.0);
    changed_.assign(n, 0.0);
    const Vec3 start = positions_[v];
    Vec3 mean;
    double total = 0.0;
    for (const Index j : ring) {
      const double length = norm(positions_[j] - start);
      total += length;
      mean += length * positions_[j];
    }
    const Vec3 L = (1.0 / total) * mean - start;
    double energy = defects_[v] * defects_[v];
    for (std::size_t j = 0; j < n; ++j) {
      if (!connectivity_.is_inner(ring[j])) continue;
      const Vec3 at = positions_[ring[j]], p = start - at;
      rest_[j] = defects_[ring[j]] +
                 angle_between(p, positions_[ring[j + 1 < n ? j + 1 : 0]] - at) +
                 angle_between(p, positions_[ring[j > 0 ? j - 1 : n - 1]] - at);
      energy += defects_[ring[j]] * defects_[ring[j]];
    }
    const LinePoint best =
        minimise_on_line([&](double lambda) { return along(v, L, lambda); }, steps);
    if (best.at == 0.0 || !(along(v, L, best.at).value < energy - accept_above)) return false;
    positions_[v] = start + best.at * L;
    defects_[v] = own_;
    for (std::size_t j = 0; j < n; ++j) {
      if (connectivity_.is_inner(ring[j])) defects_[ring[j]] = changed_[j];
    }
    return true;
  }

  const Connectivity& connectivity_;
  std::vector<Vec3> positions_;
  std::vector<double> defects_;
  // Of the vertex that is visited: per neighbour, 2 pi less the angles without x; its defect.
  std::vector<double> rest_, changed_;
  double own_ = 0.0;
};

}  // namespace planish::plain
