// A method from outside: a function of positions, in model units and the numbers of the mesh.

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <planish/core/error.h>
#include <planish/evolve/own_method.h>

#include "evolve/state/sweep.h"

namespace planish {

namespace {

class OwnStepper {
 public:
  OwnStepper(const OwnMethod& method, PatchState& state, ThreadPool& pool)
      : method_(method), state_(state), pool_(pool) {
    const std::size_t count = method.moves_border ? state.vertex_count() : state.inner_count();
    for (Index v = 0; v < count; ++v) {
      if (!state.is_fixed(v)) movable_.emplace_back(state.vertex_of(v), v);
    }
    std::sort(movable_.begin(), movable_.end());
    for (const auto& [in_mesh, v] : movable_)
      movable_in_mesh_.push_back(in_mesh);
  }

  SweepOutcome step() {
    pool_.stop_if_cancelled();
    const std::vector<Vec3> before = state_.positions_in_mesh_order();
    const std::vector<Vec3> after =
        method_.sweep({state_.patch(), before, movable_in_mesh_, ++sweeps_});
    check(after, before.size());
    std::size_t moved = 0;
    for (const auto& [in_mesh, v] : movable_) {
      if (after[in_mesh] == before[in_mesh]) continue;
      state_.move(v, state_.scale() * after[in_mesh]);
      ++moved;
    }
    return moved;
  }

 private:
  void check(const std::vector<Vec3>& after, std::size_t count) const {
    if (after.size() != count) {
      fail("gave " + std::to_string(after.size()) + " positions for " + std::to_string(count) +
           " vertices");
    }
    for (const Index v : movable_in_mesh_) {
      const Vec3 p = state_.scale() * after[v];
      if (!std::isfinite(dot(p, p)))
        fail("gave a position that is no number, at vertex " + std::to_string(v), v);
    }
  }
  [[noreturn]] void fail(const std::string& what, std::optional<std::size_t> vertex = {}) const {
    throw Error(ErrorCode::method_failed, "method " + method_.name + " " + what,
                {.path = {}, .first = vertex});
  }

  OwnMethod method_;
  PatchState& state_;
  ThreadPool& pool_;
  std::vector<std::pair<Index, Index>> movable_;  // in the mesh and in the state
  std::vector<Index> movable_in_mesh_;
  int sweeps_ = 0;
};

}  // namespace

Sweep make_sweep(const OwnMethod& method, PatchState& state, ThreadPool& pool) {
  auto stepper = std::make_shared<OwnStepper>(method, state, pool);
  return [stepper] { return stepper->step(); };
}

OwnMethod result_as_method(std::string name, std::vector<Vec3> positions) {
  return {.name = std::move(name),
          .sweep = [positions = std::move(positions)](const SweepInput&) { return positions; },
          .usual_sweeps = 1,
          .moves_border = true};
}

}  // namespace planish
