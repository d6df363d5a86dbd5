#include "panels/cells/normal_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

namespace planish {

namespace {

constexpr int k_rounds = 12;

/// What the triangles of a cell are like.
struct Proxy {
  Vec3 normal, middle;
};

class Lloyd {
 public:
  Lloyd(const PanelMesh& mesh, std::span<const Index> triangles, double place_weight)
      : mesh_(mesh), triangles_(triangles), place_(mesh.triangles().size(), PanelEdge::none) {
    const std::vector<Vec3>& x = mesh.patch().positions();
    double area = 0.0;
    for (const Index t : triangles)
      area += mesh.area(t);
    const double unit = area > 0.0 ? mesh.scale() * std::sqrt(place_weight / area) : 0.0;
    for (std::size_t k = 0; k < triangles.size(); ++k) {
      const Triangle& t = mesh.triangles()[triangles[k]];
      place_[triangles[k]] = static_cast<Index>(k);
      const Vec3 n = cross(x[t[1]] - x[t[0]], x[t[2]] - x[t[0]]);
      const double size = norm(n);
      own_.push_back(
          {size > 0.0 ? (1.0 / size) * n : Vec3{}, (unit / 3.0) * (x[t[0]] + x[t[1]] + x[t[2]])});
    }
  }

  std::vector<Index> run(std::size_t count) {
    std::vector<Index> seeds = spread_seeds(count);
    std::vector<Proxy> proxies;
    proxies.reserve(seeds.size());
    for (const Index seed : seeds)
      proxies.push_back(own_[seed]);
    std::vector<Index> cells = flood(seeds, proxies);
    for (int round = 0; round < k_rounds; ++round) {
      proxies = means(cells, seeds.size());
      seeds = best_seeds(cells, proxies, seeds);
      cells = flood(seeds, proxies);
    }
    return cells;
  }

 private:
  template <class Visit>
  void for_each_neighbour(std::size_t k, const Visit& visit) const {
    for (std::size_t i = 0; i < 3; ++i) {
      const Index other = mesh_.edges()[mesh_.edge_of(triangles_[k], i)].other(triangles_[k]);
      if (other != PanelEdge::none && place_[other] != PanelEdge::none) visit(place_[other]);
    }
  }

  /// One after the other the triangle with most steps to those before.
  std::vector<Index> spread_seeds(std::size_t count) const {
    std::vector<Index> seeds = {0};
    std::vector<std::size_t> steps(triangles_.size(), triangles_.size());
    while (true) {
      std::vector<Index> front = {seeds.back()};
      steps[seeds.back()] = 0;
      while (!front.empty()) {
        std::vector<Index> next;
        for (const Index k : front) {
          for_each_neighbour(k, [&](Index n) {
            if (steps[n] <= steps[k] + 1) return;
            steps[n] = steps[k] + 1;
            next.push_back(n);
          });
        }
        front = std::move(next);
      }
      const auto farthest = std::max_element(steps.begin(), steps.end());
      if (seeds.size() >= count || *farthest == 0) return seeds;
      seeds.push_back(static_cast<Index>(farthest - steps.begin()));
    }
  }

  double distance(Index k, const Proxy& proxy) const {
    const Vec3 turn = own_[k].normal - proxy.normal, off = own_[k].middle - proxy.middle;
    return dot(turn, turn) + dot(off, off);
  }

  std::vector<Index> flood(std::span<const Index> seeds, std::span<const Proxy> proxies) const {
    std::vector<Index> cells(triangles_.size(), PanelEdge::none);
    using Entry = std::tuple<double, Index, Index>;  // cost, triangle, cell
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    for (std::size_t c = 0; c < seeds.size(); ++c)
      queue.emplace(-1.0, seeds[c], static_cast<Index>(c));
    while (!queue.empty()) {
      const auto [at, k, cell] = queue.top();
      queue.pop();
      if (cells[k] != PanelEdge::none) continue;
      cells[k] = cell;
      for_each_neighbour(k, [&, cell = cell](Index n) {
        if (cells[n] == PanelEdge::none)
          queue.emplace(mesh_.area(triangles_[n]) * distance(n, proxies[cell]), n, cell);
      });
    }
    return cells;
  }

  std::vector<Proxy> means(std::span<const Index> cells, std::size_t count) const {
    std::vector<Proxy> sums(count);
    std::vector<double> areas(count, 0.0);
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const double area = mesh_.area(triangles_[k]);
      sums[cells[k]].normal += area * own_[k].normal;
      sums[cells[k]].middle += area * own_[k].middle;
      areas[cells[k]] += area;
    }
    for (std::size_t c = 0; c < count; ++c) {
      const double size = norm(sums[c].normal);
      if (size > 0.0) sums[c].normal = (1.0 / size) * sums[c].normal;
      if (areas[c] > 0.0) sums[c].middle = (1.0 / areas[c]) * sums[c].middle;
    }
    return sums;
  }

  std::vector<Index> best_seeds(std::span<const Index> cells, std::span<const Proxy> proxies,
                                std::vector<Index> seeds) const {
    std::vector<double> least(seeds.size(), std::numeric_limits<double>::infinity());
    for (Index k = 0; k < cells.size(); ++k) {
      const double off = distance(k, proxies[cells[k]]);
      if (off >= least[cells[k]]) continue;
      least[cells[k]] = off;
      seeds[cells[k]] = k;
    }
    return seeds;
  }

  const PanelMesh& mesh_;
  std::span<const Index> triangles_;
  std::vector<Index> place_;
  std::vector<Proxy> own_;  // of each triangle
};

}  // namespace

std::vector<Index> normal_cells(const PanelMesh& mesh, std::span<const Index> triangles,
                                std::size_t count, double place_weight) {
  if (triangles.empty()) return {};
  return Lloyd(mesh, triangles, place_weight).run(std::max<std::size_t>(count, 1));
}

}  // namespace planish
