#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <planish/measure/flattenability.h>
#include <planish/mesh/connectivity.h>

#include "core/lanes/isa.h"
#include "core/thread_pool.h"
#include "evolve/lanes/move_stars.h"

namespace planish {

/// A patch laid out for sweeping. Vertices are renumbered along a space-filling curve, inner ones
/// first, then the border; unused ones are left out. Inner vertices are visited colour by colour,
/// within a colour by valence, along the curve within these. Places are scaled by unit_scale(),
/// which is exact both ways.
class PatchState {
 public:
  PatchState(const TriMesh& mesh, const Connectivity& connectivity, ThreadPool& pool);

  std::size_t inner_count() const { return ring_start_.size() - 1; }
  std::size_t color_count() const { return color_start_.size() - 1; }
  /// The vertices of one colour are visited from color_begin(c) to color_begin(c + 1).
  std::size_t color_begin(std::size_t color) const { return color_start_[color]; }

  bool is_inner(Index v) const { return v < inner_count(); }
  std::span<const Index> ring(std::size_t v) const {
    return {rings_.data() + ring_start_[v], ring_start_[v + 1] - ring_start_[v]};
  }
  /// The inner vertex that is the i-th to be visited.
  Index visited(std::size_t i) const { return visits_[i]; }
  /// From the i-th visit, the end of those that follow with its colour and valence.
  std::size_t end_of_run(std::size_t i) const;

  Vec3 position(std::size_t v) const { return {sites_[v].x, sites_[v].y, sites_[v].z}; }
  /// Where an inner vertex was at first.
  Vec3 origin(std::size_t v) const { return scale_ * origins_[vertex_of_[v]]; }
  void move(std::size_t v, Vec3 to) {
    sites_[v].x = to.x, sites_[v].y = to.y, sites_[v].z = to.z;
    note_move(v);
  }

  /// Places and defects; who moves a vertex here says so with note_move().
  std::span<Site> sites() { return sites_; }
  /// Remembers that v moved, and with it the defects of its ring.
  void note_move(std::size_t v) {
    moved_[v] = 1;
    changed_at_[v] = now_;
    for (const Index j : ring(v)) {
      if (is_inner(j)) changed_at_[j] = now_;
    }
  }

  /// d_v of an inner vertex, as of the last update; see refresh_defects().
  double defect(std::size_t v) const { return sites_[v].defect; }
  /// Computes all defects from the positions, on any number of threads with the same bits.
  void refresh_defects(ThreadPool& pool);
  /// e_max, e_avg, energy and sum_abs_defect of the defects.
  Flattenability summary(ThreadPool& pool) const;

  /// A clock for those who skip what cannot have changed: counts phases in which vertices that move
  /// do not see each other.
  void begin_phase() { ++now_; }
  std::uint32_t now() const { return now_; }
  /// True if the vertex, its neighbours or their defects changed after phase `then`.
  bool ring_changed_since(std::uint32_t then, std::size_t v) const {
    if (changed_at_[v] > then) return true;
    for (const Index j : ring(v)) {
      if (is_inner(j) && changed_at_[j] > then) return true;
    }
    return false;
  }

  /// The positions in the order and size of the mesh; what never moved keeps its bits.
  std::vector<Vec3> positions_in_mesh_order() const;

  /// Factor from model units to the units in here.
  double scale() const { return scale_; }
  /// The mesh's number of a vertex.
  Index vertex_of(std::size_t v) const { return vertex_of_[v]; }

 private:
  void number_rings(const Connectivity& connectivity, std::size_t inner, ThreadPool& pool);
  void plan_visits(const std::vector<Index>& colors);
  void place_vertices(ThreadPool& pool);

  double scale_;
  std::vector<Vec3> origins_;     // the mesh's positions, as they came
  std::vector<Index> vertex_of_;  // number in the mesh
  std::vector<Site> sites_;
  std::vector<unsigned char> moved_;
  std::vector<std::uint32_t> changed_at_;  // the last phase that changed its place or defect
  std::uint32_t now_ = 1;
  std::vector<std::size_t> ring_start_, color_start_;
  std::vector<Index> visits_;
  std::vector<std::size_t> run_end_;  // ascending: visits before which colour or valence change
  std::vector<Index> rings_;
};

}  // namespace planish
