#pragma once

#include <cstddef>
#include <vector>

#include "mesh/coarsen/coarsen.h"
#include "mesh/coarsen/fine_surface.h"
#include "mesh/coarsen/triangle_grade.h"
#include "mesh/coarsen/vertex_queue.h"
#include "mesh/half_edges.h"

namespace planish {

/// Takes vertices out of a mesh one after another; see coarsen().
class Coarsener {
 public:
  /// @param mesh must outlive it, as must `order`: its vertices, by their numbers in here
  Coarsener(const TriMesh& mesh, const std::vector<Index>& order, std::size_t vertices,
            CoarseBorder border, std::vector<unsigned char> keep);

  /// @throws Cancelled
  void run(const ThreadPool* pool);
  /// The triangles that are left, in the numbers of `order`.
  std::vector<Triangle> triangles() const;

 private:
  /// An edge to collapse into its end that stays.
  struct Collapse {
    Index edge = HalfEdges::none;
    Index stays = HalfEdges::none;
    double cost = 0.0;
    double score = 0.0;  ///< cost and shape
    bool operator<(const Collapse& other) const { return score < other.score; }
  };

  TriangleGrade grade(Index a, Index b, Index c) const { return grade_of(surface_, a, b, c); }
  TriangleGrade grade_around(Index v) const;
  TriangleGrade grade_after(Index gone, Index stays) const;
  double crowding(Index v) const;
  double border_gap(Index v) const;
  double distance_cost(Index gone, Index stays) const;
  double least_cost(Index v) const;
  template <class F>
  void for_each_way_out(Index v, F f) const;
  Collapse best_collapse(Index v);
  void collapse(const Collapse& way, Index gone);
  bool improves(Index h) const;
  void flip_around(Index v);
  void touch(Index v);
  void update_touched();
  void count_loops();

  HalfEdges half_edges_;
  FineSurface surface_;
  std::vector<PlaneQuadric> quadrics_;
  std::vector<unsigned char> fixed_;
  std::vector<double> sizes_;
  float limit_;  // of keys
  std::size_t left_ = 0, wanted_;
  std::vector<Index> loop_of_;  // of border vertices
  std::vector<std::size_t> loop_sizes_;
  VertexQueue<float> queue_;  // by level_of()
  std::vector<Collapse> ways_;
  std::vector<Index> stack_, touched_;
  std::vector<unsigned char> is_touched_;
};

}  // namespace planish
