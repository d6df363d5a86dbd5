#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <planish/evolve/constraints.h>
#include <planish/measure/flattenability.h>
#include <planish/mesh/patch.h>

#include "core/buffer.h"
#include "core/neumaier_sum.h"
#include "core/thread_pool.h"
#include "evolve/simd/move_stars.h"
#include "evolve/state/visit_plan.h"
#include "geometry/box.h"
#include "mesh/symmetry/mirror_orbits.h"

namespace planish {

/// Sums over vertices of the sizes of their defects.
struct DefectSums {
  double most = 0.0;
  NeumaierSum energy, sum;

  void add(double size) {
    raise(size);
    energy.add(size * size);
    sum.add(size);
  }
  void add(const DefectSums& part) {
    raise(part.most);
    energy.add(part.energy);
    sum.add(part.sum);
  }

 private:
  void raise(double size) {
    if (size > most || std::isnan(size)) most = size;
  }
};

/// A patch laid out for sweeping. Vertices are renumbered along a space-filling curve, inner ones
/// first, then the border; unused ones are left out. Positions are scaled by unit_scale(), which is
/// exact both ways.
class PatchState {
 public:
  /// @param orbits of the vertices of the patch, as from mirror_orbits_of()
  PatchState(const Patch& patch, ThreadPool& pool, const Constraints& constraints = {},
             const MirrorOrbits& orbits = {});

  std::size_t inner_count() const { return plan_.visits.size(); }
  bool is_inner(Index v) const { return v < inner_count(); }
  /// Inner and border vertices.
  std::size_t vertex_count() const { return vertex_of_.size(); }
  /// The first vertex of each loop of the border, then vertex_count(): the vertices of a loop
  /// follow one another in their order along it.
  const std::vector<Index>& border_starts() const { return border_starts_; }
  /// True if nothing may move the vertex, though it is measured.
  bool is_fixed(std::size_t v) const { return !fixed_.empty() && fixed_[v] != 0; }
  /// The weight of the vertex's moves.
  double weight(std::size_t v) const { return weights_.empty() ? 1.0 : weights_[vertex_of_[v]]; }
  /// As it was at first, in model units and the numbers of the mesh.
  const Patch& patch() const { return patch_; }
  /// The triangles, in the numbers here and the order of the mesh.
  std::vector<Triangle> triangles() const;
  /// What is not to be entered, in the units in here; without triangles where there is nothing.
  const TriMesh& obstacle() const { return obstacle_; }
  /// Vertices with their mirror images, where the patch is to stay its own mirror image.
  const MirrorOrbits& orbits() const { return orbits_; }
  /// How a sweep visits the inner vertices.
  const VisitPlan& plan() const { return plan_; }

  Vec3 position(std::size_t v) const { return {sites_[v].x, sites_[v].y, sites_[v].z}; }
  /// The same as a function of the vertex.
  auto positions() const {
    return [this](std::size_t v) { return position(v); };
  }
  /// Where a vertex was at first.
  Vec3 origin(std::size_t v) const { return scale_ * patch_.positions()[vertex_of_[v]]; }
  void move(std::size_t v, Vec3 to) { sites_[v].x = to.x, sites_[v].y = to.y, sites_[v].z = to.z; }

  /// Positions and defects.
  std::span<Site> sites() { return sites_; }

  /// d_v of an inner vertex, as of the last update; see measure().
  double defect(std::size_t v) const { return sites_[v].defect; }
  /// Computes all defects from the positions and returns e_max, e_avg, energy and sum_abs_defect;
  /// ends a sweep. On any number of threads with the same bits.
  Flattenability measure(ThreadPool& pool);

  /// A clock for those who skip what cannot have changed: its time is when vertices of the colour
  /// are visited in this sweep. Later visits that see one of them have later times.
  Changes changes(Index color) { return {changed_at_.data(), time_of(color)}; }
  /// True if the vertex, its neighbours or their defects changed after `then`.
  bool ring_changed_since(std::uint32_t then, const Star& star, std::size_t valence) const {
    if (changed_at_[star.center] > then) return true;
    for (std::size_t j = 0; j < valence; ++j) {
      if (is_inner(star.ring[j]) && changed_at_[star.ring[j]] > then) return true;
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
  VisitPlan plan_for(const Connectivity& connectivity, std::size_t inner, const Box& box,
                     ThreadPool& pool) const;
  void fix(std::span<const Index> vertices);
  void place_vertices(ThreadPool& pool);
  std::uint32_t time_of(Index color) const { return sweep_began_ + color; }
  DefectSums measure_visits(std::size_t begin, std::size_t end);

  Patch patch_;
  std::vector<double> weights_;  // as in Constraints
  TriMesh obstacle_;
  std::vector<unsigned char> fixed_;  // none where nothing is
  double scale_ = 1.0;
  std::vector<Index> vertex_of_;  // number in the mesh
  std::vector<Index> border_starts_;
  Buffer<Site> sites_;                     // as many
  std::vector<std::uint32_t> changed_at_;  // when its place or defect changed last
  std::uint32_t sweep_began_ = 1;
  VisitPlan plan_;
  MirrorOrbits orbits_;
};

}  // namespace planish
