#include "evolve/methods/penalty_merit.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numbers>
#include <numeric>
#include <tuple>
#include <utility>

#include "core/math.h"
#include "core/neumaier_sum.h"
#include "geometry/angle_gradient.h"
#include "geometry/triangle_shape.h"

namespace planish {

namespace {

constexpr std::size_t k_grain = 512;

/// Border vertices that came at one place, for each place where there is more than one.
std::vector<std::vector<Index>> linked_vertices(const PatchState& state) {
  std::vector<Index> border(state.vertex_count() - state.inner_count());
  std::iota(border.begin(), border.end(), static_cast<Index>(state.inner_count()));
  const auto key = [&](Index v) {
    const Vec3 p = state.origin(v);
    return std::tuple(p.x, p.y, p.z);
  };
  std::stable_sort(border.begin(), border.end(), [&](Index v, Index w) { return key(v) < key(w); });
  std::vector<std::vector<Index>> links;
  for (auto first = border.begin(); first != border.end();) {
    const auto end =
        std::find_if(first, border.end(), [&](Index v) { return key(v) != key(*first); });
    if (end - first > 1) links.emplace_back(first, end);
    first = end;
  }
  return links;
}

/// Where each vertex's part of a list begins, from how many entries it has.
std::vector<std::size_t> starts_of(const std::vector<std::size_t>& counts) {
  std::vector<std::size_t> start(counts.size() + 1, 0);
  std::partial_sum(counts.begin(), counts.end(), start.begin() + 1);
  return start;
}

}  // namespace

PenaltyMerit::PenaltyMerit(const PatchState& state, BorderRule border, ThreadPool& pool)
    : pool_(pool), inner_count_(state.inner_count()), triangles_(state.triangles()) {
  make_nodes(state, border);
  make_edges(state);
  make_corners(state.vertex_count());
  for (const Triangle& t : triangles_) {
    const double shape = triangle_shape(state.origin(t[0]), state.origin(t[1]), state.origin(t[2]));
    least_shape_.push_back(std::min(shape, k_least_shape));
  }
}

void PenaltyMerit::make_nodes(const PatchState& state, BorderRule border) {
  const auto is_fixed = [&](Index v) { return state.is_fixed(v); };
  for (Index v = 0; v < state.inner_count(); ++v) {
    if (!is_fixed(v)) add_node({&v, 1});
  }
  if (border == BorderRule::fixed) return;
  for (const auto& vertices : linked_vertices(state)) {
    if (std::none_of(vertices.begin(), vertices.end(), is_fixed)) add_node(vertices);
  }
}

void PenaltyMerit::add_node(std::span<const Index> vertices) {
  vertices_.insert(vertices_.end(), vertices.begin(), vertices.end());
  node_start_.push_back(vertices_.size());
}

void PenaltyMerit::make_edges(const PatchState& state) {
  std::vector<std::pair<Index, Index>> edges;  // each in both directions
  for (const Triangle& t : triangles_) {
    for (int k = 0; k < 3; ++k) {
      edges.emplace_back(t[k], t[(k + 1) % 3]);
      edges.emplace_back(t[(k + 1) % 3], t[k]);
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  std::vector<std::size_t> counts(state.vertex_count(), 0);
  NeumaierSum squares;
  for (const auto& [v, w] : edges) {
    const double length = norm(state.origin(v) - state.origin(w));
    neighbours_.push_back({w, length});
    ++counts[v];
    squares.add(length * length);
  }
  neighbour_start_ = starts_of(counts);
  mean_squared_edge_ = squares.value() / static_cast<double>(edges.size());
}

void PenaltyMerit::make_corners(std::size_t vertex_count) {
  std::vector<std::size_t> counts(vertex_count, 0);
  for (const Triangle& t : triangles_) {
    for (const Index v : t)
      ++counts[v];
  }
  corner_start_ = starts_of(counts);
  corners_.resize(corner_start_.back());
  std::vector<std::size_t> next(corner_start_.begin(), corner_start_.end() - 1);
  for (std::size_t corner = 0; corner < 3 * triangles_.size(); ++corner)
    corners_[next[triangles_[corner / 3][corner % 3]]++] = corner;
}

std::vector<double> PenaltyMerit::angles(const std::vector<Vec3>& positions) const {
  std::vector<double> angles(3 * triangles_.size());
  pool_.for_ranges(triangles_.size(), k_grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      const Vec3 p = positions[triangles_[t][0]], q = positions[triangles_[t][1]],
                 r = positions[triangles_[t][2]];
      const Vec3 a = q - p, b = r - p, c = r - q;
      const double area = norm(cross(a, b));
      angles[3 * t] = math::atan2(area, dot(a, b));
      angles[3 * t + 1] = math::atan2(area, -dot(a, c));
      angles[3 * t + 2] = math::atan2(area, dot(b, c));
    }
  });
  return angles;
}

PenaltyPoint PenaltyMerit::at(std::vector<Vec3> positions) const {
  PenaltyPoint point;
  point.positions = std::move(positions);
  const std::vector<Vec3>& x = point.positions;
  const std::vector<double> angle = angles(x);
  point.defects.resize(inner_count_);
  pool_.for_ranges(inner_count_, k_grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      double sum = 0.0;
      for (std::size_t c = corner_start_[v]; c < corner_start_[v + 1]; ++c)
        sum += angle[corners_[c]];
      point.defects[v] = 2.0 * std::numbers::pi - sum;
    }
  });
  NeumaierSum energy, stretch;
  for (const double g : point.defects)
    energy.add(g * g);
  for (Index v = 0; v < x.size(); ++v) {
    for (std::size_t i = neighbour_start_[v]; i < neighbour_start_[v + 1]; ++i) {
      const auto [w, length] = neighbours_[i];
      if (w < v) continue;
      const double longer = norm(x[w] - x[v]) - length;
      stretch.add(longer * longer);
    }
  }
  point.energy = energy.value();
  point.stretch = stretch.value();
  std::atomic<bool> sound = true;
  pool_.for_ranges(triangles_.size(), k_grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      const Triangle& tri = triangles_[t];
      // Not so for sizes that are no numbers either.
      if (!(triangle_shape(x[tri[0]], x[tri[1]], x[tri[2]]) >= least_shape_[t])) sound = false;
    }
  });
  point.sound = sound && std::isfinite(point.energy + point.stretch);
  return point;
}

std::vector<Vec3> PenaltyMerit::energy_gradient_by_corner(const PenaltyPoint& point) const {
  std::vector<Vec3> by_corner(3 * triangles_.size());
  pool_.for_ranges(triangles_.size(), k_grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      const Triangle& tri = triangles_[t];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t q = (k + 1) % 3, r = (k + 2) % 3;
        if (tri[k] >= inner_count_) continue;  // the border has no defect
        const AngleGradient angle = angle_gradient(point.positions[tri[k]], point.positions[tri[q]],
                                                   point.positions[tri[r]]);
        const double factor = -2.0 * point.defects[tri[k]];
        by_corner[3 * t + k] += factor * angle.at_p;
        by_corner[3 * t + q] += factor * angle.at_q;
        by_corner[3 * t + r] += factor * angle.at_r;
      }
    }
  });
  return by_corner;
}

std::vector<Vec3> PenaltyMerit::gradient(const PenaltyPoint& point, double factor) const {
  const std::vector<Vec3> by_corner = energy_gradient_by_corner(point);
  std::vector<Vec3> gradient(node_count());
  pool_.for_ranges(node_count(), k_grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t node = begin; node < end; ++node) {
      Vec3 energy, stretch;
      for (const Index v : vertices_of(node)) {
        for (std::size_t c = corner_start_[v]; c < corner_start_[v + 1]; ++c)
          energy += by_corner[corners_[c]];
        for (std::size_t i = neighbour_start_[v]; i < neighbour_start_[v + 1]; ++i) {
          const Vec3 edge = point.positions[v] - point.positions[neighbours_[i].vertex];
          const double length = norm(edge);
          if (length > 0.0) stretch += (2.0 - 2.0 * neighbours_[i].length / length) * edge;
        }
      }
      gradient[node] = stretch + factor * energy;
    }
  });
  return gradient;
}

}  // namespace planish
