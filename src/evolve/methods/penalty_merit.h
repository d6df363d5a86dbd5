#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <planish/evolve/method.h>

#include "core/thread_pool.h"
#include "evolve/state/patch_state.h"

namespace planish {

/// Positions of all vertices and what the penalty method asks of them.
struct PenaltyPoint {
  std::vector<Vec3> positions;
  std::vector<double> defects;  ///< g of the inner vertices
  double stretch = 0.0;         ///< E_s: sum over the edges of (length - length at first)^2
  double energy = 0.0;          ///< G: sum over the inner vertices of g^2
  bool sound = true;            ///< no triangle has collapsed
};

/// E_s and G of a patch with their gradients. What moves are nodes: a free inner vertex, or border
/// vertices that are linked. Results do not depend on the number of threads.
class PenaltyMerit {
 public:
  PenaltyMerit(const PatchState& state, BorderRule border, ThreadPool& pool);

  std::size_t node_count() const { return node_start_.size() - 1; }
  /// The vertices that move as one.
  std::span<const Index> vertices_of(std::size_t node) const {
    return {vertices_.data() + node_start_[node], node_start_[node + 1] - node_start_[node]};
  }
  /// Mean of the squared lengths of the edges at first.
  double mean_squared_edge() const { return mean_squared_edge_; }

  PenaltyPoint at(std::vector<Vec3> positions) const;
  /// By node: the gradient of E_s + factor G.
  std::vector<Vec3> gradient(const PenaltyPoint& point, double factor) const;

 private:
  struct Neighbour {
    Index vertex;
    double length;  // of the edge, at first
  };

  void make_nodes(const PatchState& state, BorderRule border);
  void add_node(std::span<const Index> vertices);
  void make_edges(const PatchState& state);
  void make_corners(std::size_t vertex_count);
  std::vector<double> angles(const std::vector<Vec3>& positions) const;
  std::vector<Vec3> energy_gradient_by_corner(const PenaltyPoint& point) const;

  ThreadPool& pool_;
  std::size_t inner_count_;
  std::vector<Triangle> triangles_;
  std::vector<Index> vertices_;  // of the nodes
  std::vector<std::size_t> node_start_{0};
  std::vector<std::size_t> neighbour_start_;  // of each vertex
  std::vector<Neighbour> neighbours_;
  std::vector<std::size_t> corner_start_;  // of each vertex
  std::vector<std::size_t> corners_;       // 3 triangle + k
  std::vector<double> least_shape_;        // of each triangle
  double mean_squared_edge_ = 0.0;
};

}  // namespace planish
