// Fairing with the border held: bi-Laplacian, and the flows of Taubin, of Desbrun and others, and
// of Clarenz and others. Equations in docs/methods/fairing.md.

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <vector>

#include <planish/evolve/method.h>

#include "evolve/state/sweep.h"
#include "evolve/systems/diffusion_system.h"
#include "evolve/systems/fairing_system.h"
#include "evolve/systems/positions.h"
#include "measure/area.h"
#include "measure/normals.h"

namespace planish {

namespace {

class FairingStepper {
 public:
  FairingStepper(const BilaplacianFairing& options, PatchState& state, ThreadPool& pool)
      : options_(options),
        state_(state),
        pool_(pool),
        jacobian_(angle_jacobian_of(state)),
        origins_(inner_positions(state)),
        rate_(options.pull / area_of(surface(origins_), 1.0)) {
    const double pull = options.pull / static_cast<double>(state.inner_count());
    for (Index v = 0; v < state.inner_count(); ++v) {
      weights_.push_back(state.weight(v));
      pulls_.push_back(pull * state.weight(v));
      const auto ring = jacobian_.ring(v);
      const bool is_held =
          options.flow == FairingFlow::none &&
          std::any_of(ring.begin(), ring.end(), [&](Index w) { return !state.is_inner(w); });
      movable_.push_back(jacobian_.is_movable(v) && !is_held ? 1 : 0);
    }
  }

  SweepOutcome step() {
    const Positions before = inner_positions(state_);
    const std::optional<Positions> after = faired(before);
    if (!after) return {};
    const double rms = norm_of(sum_of(*after, -1.0, before)) /
                       std::sqrt(static_cast<double>(state_.inner_count()));
    const double smallest = options_.min_step * mean_edge(jacobian_, state_);
    return SweepOutcome(set_positions(*after, jacobian_, state_)).ended_if(rms <= smallest);
  }

 private:
  std::optional<Positions> faired(const Positions& before) const {
    switch (options_.flow) {
      case FairingFlow::taubin:
        return along_umbrellas(along_umbrellas(before, options_.lambda), options_.mu);
      case FairingFlow::implicit:
        return diffused(before, rate_, [](const Triangle&) { return Diffusivity{}; });
      case FairingFlow::anisotropic:
        return anisotropically(before);
      case FairingFlow::none:
        break;
    }
    const FairingSystem fairing(state_, movable_, LaplacianWeights::thin_plate, pulls_, pool_);
    if (!fairing.solvable()) return {};
    return fairing.apply(origins_, pool_);
  }

  /// All by a share of the vector to the mean of the ring.
  Positions along_umbrellas(const Positions& from, double share) const {
    Positions to = from;
    for (Index v = 0; v < to.size(); ++v) {
      if (movable_[v] == 0) continue;
      const auto ring = jacobian_.ring(v);
      Vec3 sum;
      for (const Index w : ring)
        sum += (state_.is_inner(w) ? from[w] : state_.position(w)) - from[v];
      to[v] += (share / static_cast<double>(ring.size())) * sum;
    }
    return to;
  }

  std::optional<Positions> diffused(const Positions& from, double rate,
                                    const DiffusionSystem::DiffusivityOf& diffusivity) const {
    const DiffusionSystem system(state_, movable_, weights_, rate, diffusivity, pool_);
    if (!system.solvable()) return {};
    return system.apply(from, pool_);
  }

  /// Diffusion that gets the slower in a principal direction the more the surface bends in it, seen
  /// on a surface from which waves of the length of an edge are gone.
  std::optional<Positions> anisotropically(const Positions& before) const {
    const double edge = mean_edge(jacobian_, state_);
    const auto smooth =
        diffused(before, 2.0 / (edge * edge), [](const Triangle&) { return Diffusivity{}; });
    if (!smooth) return {};
    const TriMesh mesh = surface(*smooth);
    const std::vector<Vec3> normals = unit_vertex_normals(mesh.triangles, mesh.positions);
    const double crease = options_.crease * (std::numbers::pi / 180.0) / edge;
    const auto slowed = [crease](double curvature) {
      const double ratio = curvature / crease;
      return 1.0 / (1.0 + ratio * ratio);
    };
    return diffused(before, rate_, [&](const Triangle& t) {
      const TriangleCurvature bend =
          triangle_curvature({mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]},
                             {normals[t[0]], normals[t[1]], normals[t[2]]});
      return Diffusivity{bend.direction, slowed(bend.along), slowed(bend.across)};
    });
  }

  /// The patch with the inner vertices there, the border where it is.
  TriMesh surface(const Positions& inner) const {
    Positions positions = all_positions(state_);
    std::copy(inner.begin(), inner.end(), positions.begin());
    return {std::move(positions), state_.triangles()};
  }

  BilaplacianFairing options_;
  PatchState& state_;
  ThreadPool& pool_;
  AngleJacobian jacobian_;  // who is next to whom
  Positions origins_;
  double rate_;                          // of diffusion, 1 / time
  std::vector<double> weights_, pulls_;  // by inner vertex
  std::vector<unsigned char> movable_;   // by inner vertex; of `none` those next to the border not
};

}  // namespace

Sweep make_sweep(const BilaplacianFairing& options, PatchState& state, ThreadPool& pool) {
  auto stepper = std::make_shared<FairingStepper>(options, state, pool);
  return [stepper] { return stepper->step(); };
}

}  // namespace planish
