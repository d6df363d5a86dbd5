#include "evolve/vertex_step/move_check.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include "core/math.h"
#include "core/number_text.h"

namespace planish {

namespace {

/// What rounding may add to the defect of a vertex, for each of its angles.
constexpr double k_rounding_of_angle = 1e-14;

/// Squares of areas of triangles with shorter edges, as shares of the patch's size, are less than
/// doubles hold with all their digits: angles there may be off by anything.
constexpr double k_shortest_edge = 1e-70;

}  // namespace

bool MoveCheck::is_wanted() {
#ifdef PLANISH_CHECK_MOVES
  return true;
#else
  return false;
#endif
}

MoveCheck::MoveCheck(const PatchState& state)
    : state_(&state), rings_(rings_by_vertex(state.plan())) {}

double MoveCheck::defect(std::size_t v) const {
  double sum = 0.0;
  const std::span<const Index> ring = rings_[v];
  for (std::size_t j = 0; j < ring.size(); ++j) {
    const Vec3 a = state_->position(ring[j]) - state_->position(v);
    const Vec3 b = state_->position(ring[(j + 1) % ring.size()]) - state_->position(v);
    sum += math::atan2(norm(cross(a, b)), dot(a, b));
  }
  return 2.0 * std::numbers::pi - sum;
}

bool MoveCheck::has_digits(std::size_t v) const {
  const std::span<const Index> ring = rings_[v];
  for (std::size_t j = 0; j < ring.size(); ++j) {
    const Vec3 tip = state_->position(ring[j]);
    const Vec3 next = state_->position(ring[(j + 1) % ring.size()]);
    if (norm(tip - state_->position(v)) < k_shortest_edge) return false;
    if (norm(next - tip) < k_shortest_edge) return false;
  }
  return true;
}

MoveCheck::Energy MoveCheck::energy(std::size_t v) const {
  Energy energy;
  const auto add = [&](std::size_t w) {
    const double size = std::abs(defect(w));
    const double rounding = has_digits(w)
                                ? k_rounding_of_angle * static_cast<double>(rings_[w].size())
                                : std::numeric_limits<double>::infinity();
    energy.value += size * size;
    energy.rounding += (2.0 * size + rounding) * rounding;
  };
  add(v);
  for (const Index j : rings_[v]) {
    if (state_->is_inner(j)) add(j);
  }
  return energy;
}

void MoveCheck::require_fall(std::size_t v, Energy before) const {
  const Energy after = energy(v);
  if (after.value <= before.value + before.rounding + after.rounding) return;
  throw std::logic_error("the move of vertex " + std::to_string(state_->vertex_of(v)) +
                         " raised its ring energy from " + number_text(before.value) + " to " +
                         number_text(after.value));
}

}  // namespace planish
