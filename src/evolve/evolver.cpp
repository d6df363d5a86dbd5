#include <chrono>
#include <optional>
#include <string>
#include <type_traits>

#include <planish/evolve/evolver.h>
#include <planish/measure/flattenability.h>
#include <planish/mesh/inspect.h>
#include <planish/mesh/symmetry.h>

#include "core/thread_pool.h"
#include "evolve/state/mirror_orbits_of.h"
#include "evolve/state/patch_state.h"
#include "evolve/state/sweep.h"

namespace planish {

namespace {

/// Methods that solve for all vertices at once join every two neighbours of a movable vertex in one
/// matrix: with more neighbours it has some gigabytes.
constexpr std::size_t k_most_neighbours = 4000;

template <class M>
constexpr bool k_joins_neighbours = std::is_same_v<M, Auto> || std::is_same_v<M, LeastNorm>;

void check_neighbours(const Connectivity& connectivity, const Method& method) {
  const bool joins = std::visit(
      [](const auto& m) { return k_joins_neighbours<std::decay_t<decltype(m)>>; }, method);
  if (!joins) return;
  for (Index v = 0; v < connectivity.vertex_count(); ++v) {
    const std::size_t neighbours = connectivity.ring(v).size();
    if (neighbours <= k_most_neighbours || connectivity.is_border(v)) continue;
    throw Error(ErrorCode::too_large,
                "vertex " + std::to_string(v) + " has " + std::to_string(neighbours) +
                    " neighbours; method " + std::string(name_of(method)) + " takes at most " +
                    std::to_string(k_most_neighbours) +
                    ": divide the triangles around it, or take another method",
                {.path = {}, .first = v});
  }
}

/// In the plane in which the patch is to stay symmetric; without images where it has none.
Symmetry symmetry_of(const Patch& patch, const Constraints& constraints) {
  return constraints.symmetric_in ? symmetry_in(patch, *constraints.symmetric_in) : Symmetry{};
}

/// The means of the moves and of their mirror images. What did not move stays to the bit.
std::vector<Vec3> with_symmetric_moves(const Patch& patch, const Symmetry& symmetry,
                                       const std::vector<Index>& fixed,
                                       const std::vector<Vec3>& positions) {
  const std::vector<Vec3>& before = patch.positions();
  std::vector<Vec3> after = before;
  for (std::size_t v = 0; v < after.size(); ++v) {
    const Index w = symmetry.image[v];
    after[v] +=
        symmetric_move(positions[v] - before[v], positions[w] - before[w], symmetry.plane.normal);
  }
  for (const Index v : fixed)
    after[v] = before[v];
  return after;
}

}  // namespace

class Evolver::Impl {
 public:
  Impl(const Patch& patch, const Method& method, const Constraints& constraints,
       const Context& context)
      : pool_(context),
        symmetry_(symmetry_of(patch, constraints)),
        fixed_(constraints.fixed),
        state_(patch, pool_, constraints, mirror_orbits_of(patch, symmetry_, constraints)) {
    sweep_.emplace(
        std::visit([this](const auto& m) { return make_sweep(m, state_, pool_); }, method));
  }

  SweepRecord step() {
    SweepRecord record;
    const SweepOutcome outcome = (*sweep_)();
    record.moved = outcome.moved;
    record.status = outcome.status;
    record.reason = outcome.reason;
    record.level = outcome.level;
    record.in_double = outcome.in_double;
    // Anew from the positions, so that the errors of many small updates cannot pile up. A step on a
    // coarser level leaves them as they are.
    if (!outcome.on_coarse_level || sweeps_ == 0) figures_ = state_.measure(pool_);
    record.sweep = ++sweeps_;
    record.e_max = figures_.e_max;
    record.e_avg = figures_.e_avg;
    record.energy = figures_.energy;
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
    record.seconds = elapsed.count();
    return record;
  }

  void prolong_to_finest() { sweep_->prolong_to_finest(); }

  std::vector<Vec3> positions() const {
    std::vector<Vec3> positions = state_.positions_in_mesh_order();
    if (symmetry_.image.empty()) return positions;
    return with_symmetric_moves(state_.patch(), symmetry_, fixed_, positions);
  }
  unsigned threads() const { return pool_.size(); }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  ThreadPool pool_;
  Symmetry symmetry_;
  std::vector<Index> fixed_;
  PatchState state_;
  std::optional<Sweep> sweep_;
  Flattenability figures_;
  int sweeps_ = 0;
};

void check_size(const Patch& patch, const Method& method) {
  require(patch.inspection(), Purpose::evolve);
  check_neighbours(patch.connectivity(), method);
}

Evolver::Evolver(const Patch& patch, const Method& method, const Constraints& constraints,
                 const Context& context) {
  check_options(method);
  check_constraints(constraints, patch.vertex_count(), method);
  check_size(patch, method);
  impl_ = std::make_unique<Impl>(patch, method, constraints, context);
}

Evolver::~Evolver() = default;
Evolver::Evolver(Evolver&&) noexcept = default;
Evolver& Evolver::operator=(Evolver&&) noexcept = default;

SweepRecord Evolver::step() {
  return impl_->step();
}

void Evolver::prolong_to_finest() {
  impl_->prolong_to_finest();
}

std::vector<Vec3> Evolver::positions() const {
  return impl_->positions();
}

unsigned Evolver::threads() const {
  return impl_->threads();
}

}  // namespace planish
