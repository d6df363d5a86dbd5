#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <planish/mesh/connectivity.h>

namespace planish {

/// A patch laid out for sweeping. Vertices are renumbered: inner ones first, colour by colour and
/// along a space-filling curve within each, then the border; unused ones are left out. Positions
/// are apart by coordinate and scaled by unit_scale(), which is exact both ways.
class PatchState {
 public:
  PatchState(const TriMesh& mesh, const Connectivity& connectivity);

  std::size_t inner_count() const { return ring_start_.size() - 1; }
  std::size_t color_count() const { return color_start_.size() - 1; }
  /// The vertices of one colour are color_begin(c) to color_begin(c + 1).
  std::size_t color_begin(std::size_t color) const { return color_start_[color]; }

  bool is_inner(Index v) const { return v < inner_count(); }
  std::span<const Index> ring(std::size_t v) const {
    return {rings_.data() + ring_start_[v], ring_start_[v + 1] - ring_start_[v]};
  }
  Vec3 position(std::size_t v) const { return {x_[v], y_[v], z_[v]}; }
  /// Where an inner vertex was at first.
  Vec3 origin(std::size_t v) const { return scale_ * origins_[vertex_of_[v]]; }
  void move(std::size_t v, Vec3 to) {
    x_[v] = to.x, y_[v] = to.y, z_[v] = to.z;
    moved_[v] = 1;
  }

  /// d_v of an inner vertex, as of the last update; see refresh_defects().
  double defect(std::size_t v) const { return defects_[v]; }
  void set_defect(std::size_t v, double defect) { defects_[v] = defect; }
  /// Computes the defects of the inner vertices begin to end from the positions.
  void refresh_defects(std::size_t begin, std::size_t end);

  /// One defect per vertex of the mesh, in its order, as angle_defects() gives them.
  std::vector<double> defects_in_mesh_order() const;
  /// The positions in the order and size of the mesh; what never moved keeps its bits.
  std::vector<Vec3> positions_in_mesh_order() const;

  /// Factor from model units to the units in here.
  double scale() const { return scale_; }
  /// The mesh's number of a vertex.
  Index vertex_of(std::size_t v) const { return vertex_of_[v]; }

 private:
  double scale_;
  std::vector<Vec3> origins_;     // the mesh's positions, as they came
  std::vector<Index> vertex_of_;  // number in the mesh
  std::vector<double> x_, y_, z_, defects_;
  std::vector<unsigned char> moved_;
  std::vector<std::size_t> ring_start_, color_start_;
  std::vector<Index> rings_;
};

}  // namespace planish
