#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include <planish/core/context.h>
#include <planish/evolve/constraints.h>
#include <planish/evolve/method.h>
#include <planish/mesh/patch.h>

namespace planish {

/// Why an evolution ended.
enum class StopReason {
  reached_target,   ///< e_max is at most the target
  stalled,          ///< a sweep moved nothing, so no later one would
  converged,        ///< the method's own test says that it is done
  strain_met,       ///< the pattern's strain is within the limit that was asked for
  deviation_limit,  ///< more would take vertices further away than is allowed
  angle_limit,      ///< more would make angles smaller than is allowed
  smooth_limit,     ///< more would crumple the surface or bend it more than allowed
  sweep_limit,
  design_kept,  ///< of flatten(): the result is the design, by choice or as evolving made it worse
};
/// "reached_target", ...: as in reports.
std::string_view to_string(StopReason reason);

/// In words: why it ended.
std::string_view stop_text(StopReason reason);

/// What comes after a sweep.
enum class SweepStatus {
  running,    ///< another one may gain something
  converged,  ///< the method's own test says that none would gain anything more
  stalled,    ///< the method found nothing to do, and would find nothing again
};

/// A step on a level of a method that goes from coarse to fine.
struct LevelRecord {
  std::size_t inner_vertices = 0;          ///< of the level
  double merit_before = 0.0, merit = 0.0;  ///< what the step made smaller
  double strain = 0.0;                     ///< the level's rms strain potential, a share of length
};

/// The state after one sweep: figures as in Flattenability, radians.
struct SweepRecord {
  int sweep = 0;  ///< from 1
  /// As in Flattenability, after the sweep.
  double e_max = 0.0, e_avg = 0.0, energy = 0.0;
  std::size_t moved = 0;                      ///< vertices that this sweep moved
  double seconds = 0.0;                       ///< since the evolver was made
  SweepStatus status = SweepStatus::running;  ///< whether another sweep may gain something
  StopReason reason = StopReason::converged;  ///< if converged, why
  /// If the sweep was a step on a level: the other figures are those of the patch itself, which
  /// does not move before the last level.
  std::optional<LevelRecord> level = {};
  /// The matrix of the step was to be factored in float, as those of dense patches are, and had to
  /// be in double: nearly singular, or of needles.
  bool in_double = false;
};

/// Whether a method takes a patch of this kind and size.
/// @throws Error what stands in the way of Purpose::evolve; too_large for an inner vertex with more
///   than 4,000 neighbours where the method joins each two of them in one matrix
void check_size(const Patch& patch, const Method& method);

/// Runs a method on a patch, one sweep at a time. evolve() is the loop over it; this is for those
/// who want to look in between.
class Evolver {
 public:
  /// @param context its on_progress is called with an empty stage while a level of the smooth
  ///   method is opened, with the share of that opening
  /// @throws Error option_out_of_range, as check_constraints() and check_size(); Cancelled
  Evolver(const Patch& patch, const Method& method, const Constraints& constraints = {},
          const Context& context = {});
  ~Evolver();
  Evolver(Evolver&&) noexcept;
  Evolver& operator=(Evolver&&) noexcept;

  /// One pass over all inner vertices, or one step that moves them all at once.
  /// @throws Cancelled in the midst of it: then nothing else may be called
  SweepRecord step();

  /// Call this before positions() when ending before the method does: prolongs the result of a
  /// coarse level to the patch.
  void prolong_to_finest();

  /// Where the vertices are now, in the order of the mesh. Vertices that never moved keep the bits
  /// that they came with.
  std::vector<Vec3> positions() const;

  /// The number of threads in use.
  unsigned threads() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace planish
