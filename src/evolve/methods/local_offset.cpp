// Local optimisation of Wang and Tang 2004, as printed or with the corrections of
// docs/methods/local_offset.md: the worst vertex moves along its first normal, within a band.

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <queue>

#include <planish/evolve/method.h>

#include "core/math.h"
#include "evolve/state/sweep.h"
#include "evolve/vertex_step/move_check.h"
#include "evolve/vertex_step/ring_energy_at.h"

namespace planish {

namespace {

/// A step counts only if the ring energy falls by at least this share of it: what creeps is set
/// aside instead. It need not where the step ends on the band, as then no further one follows.
constexpr double k_least_fall = 1e-3;

/// What rounding may feign of a ring energy T, as a share of sqrt T.
constexpr double k_rounding = 1e-14;

/// Wider bands are none: the patch has a size of about 1 in here, and squares must not overflow.
constexpr double k_widest = 1e100;

/// A step that does not count is halved so often.
constexpr int k_halvings = 5;

/// Mean of the triangles' unit normals, weighted by their angles at the vertex; 0 where they
/// cancel.
Vec3 normal_of(const PatchState& state, Vec3 x, std::span<const Index> ring) {
  Vec3 sum;
  for (std::size_t j = 0; j < ring.size(); ++j) {
    const Vec3 u = state.position(ring[j]) - x;
    const Vec3 w = state.position(ring[j + 1 < ring.size() ? j + 1 : 0]) - x;
    const Vec3 normal = cross(u, w);
    const double area = norm(normal);
    if (area > 0.0) sum += (math::atan2(area, dot(u, w)) / area) * normal;
  }
  const double length = norm(sum);
  return length > 1e-12 ? (1.0 / length) * sum : Vec3{};
}

/// Of the edges at inner vertices; the others never change.
double mean_edge(const PatchState& state, const std::vector<std::span<const Index>>& rings) {
  NeumaierSum sum;
  std::size_t count = 0;
  for (Index v = 0; v < rings.size(); ++v) {
    for (const Index j : rings[v]) {
      if (state.is_inner(j) && j < v) continue;
      sum.add(norm(state.position(j) - state.position(v)));
      ++count;
    }
  }
  return count > 0 ? sum.value() / static_cast<double>(count) : 0.0;
}

/// The line that a vertex moves on.
struct OffsetLine {
  Vec3 origin, normal;
};

/// origin + offset normal, rounded towards the origin until it is within the radius.
Vec3 place_on(const OffsetLine& line, double offset, double radius) {
  // Room for the rounding of the distance itself.
  const double limit = radius * (1.0 - 0x1p-50);
  const double clamped = std::clamp(offset, -limit, limit);
  const Vec3 o = line.origin;
  Vec3 place = o + clamped * line.normal;
  while (norm(place - o) > limit) {
    place = {std::nextafter(place.x, o.x), std::nextafter(place.y, o.y),
             std::nextafter(place.z, o.z)};
  }
  return place;
}

class OffsetMover {
 public:
  OffsetMover(const LocalOffset& options, PatchState& state)
      : options_(options),
        state_(state),
        rings_(rings_by_vertex(state.plan())),
        radius_(options.band > 0.0 ? std::min(options.band * state.scale(), k_widest)
                                   : mean_edge(state, rings_)),
        offsets_(state.inner_count(), 0.0),
        defects_(state.inner_count(), 0.0),
        set_aside_(state.inner_count(), 0),
        visits_(state.inner_count(), 0),
        left_(options.max_updates) {
    for (Index v = 0; v < state.inner_count(); ++v) {
      const Vec3 x = state.position(v);
      lines_.push_back({x, normal_of(state, x, rings_[v])});
      set_aside_[v] = state.is_fixed(v);
    }
    if (MoveCheck::is_wanted() && is_guarded()) check_.emplace(state);
  }

  /// As many tries as there are inner vertices.
  SweepOutcome sweep();

 private:
  struct Candidate {
    double size;  // of the defect
    Index vertex, number;
    /// The largest defect first, of equal ones the vertex with the smallest number in the mesh.
    bool operator<(const Candidate& other) const {
      return size != other.size ? size < other.size : number > other.number;
    }
  };
  struct Step {
    double offset;
    Vec3 place;
    std::vector<double> defects;
  };

  bool is_guarded() const { return options_.step == OffsetStep::guarded; }
  bool is_enough(Index v) const { return std::abs(defects_[v]) <= options_.enough; }
  void push(Index v) { heap_.push({std::abs(defects_[v]), v, state_.vertex_of(v)}); }
  std::optional<Index> pop();
  std::optional<Step> falling_step(Index v) const;
  std::optional<Step> published_step(Index v) const;
  std::optional<Step> next_step(Index v);
  void take(Index v, const Step& step);
  void wake_around(Index v);
  void set_aside(Index v);

  LocalOffset options_;
  PatchState& state_;
  std::vector<std::span<const Index>> rings_;
  double radius_;
  std::vector<OffsetLine> lines_;
  std::vector<double> offsets_, defects_;
  std::vector<unsigned char> set_aside_;
  std::vector<int> visits_;  // with published steps
  std::priority_queue<Candidate> heap_;
  int left_;
  std::optional<MoveCheck> check_;  // in builds that check every move
};

/// The worst vertex that is not set aside. What is out of date in the heap is dropped.
std::optional<Index> OffsetMover::pop() {
  while (!heap_.empty()) {
    const Candidate top = heap_.top();
    heap_.pop();
    if (set_aside_[top.vertex] == 0 && top.size == std::abs(defects_[top.vertex]))
      return top.vertex;
  }
  return {};
}

std::optional<OffsetMover::Step> OffsetMover::falling_step(Index v) const {
  const RingEnergyAt energy(state_, v, rings_[v], defects_);
  const Vec3 x = state_.position(v);
  const StarSample now = energy.along(x, lines_[v].normal);
  const double least = k_least_fall * now.value, rounding = k_rounding * std::sqrt(now.value);
  // As printed, to where the tangent has its root; then to the minimum after Gauss and Newton.
  for (const double step : {-now.value / now.slope, -now.slope / now.curvature}) {
    if (!std::isfinite(step)) continue;
    const double start = offsets_[v], end = std::clamp(start + step, -radius_, radius_);
    double part = 1.0;
    for (int halving = 0; halving <= k_halvings; ++halving, part *= 0.5) {
      const double offset = halving == 0 ? end : start + part * (end - start);
      const Vec3 place = place_on(lines_[v], offset, radius_);
      if (place == x) break;
      const double fall = now.value - energy.value(place);
      const bool on_band = std::abs(offset) == radius_;
      if (fall > rounding && (fall >= least || on_band) && !energy.has_needle(place))
        return Step{offset, place, energy.defects(place)};
    }
  }
  return {};
}

/// To where the tangent of T has its root, clamped; none where that is where the vertex is.
std::optional<OffsetMover::Step> OffsetMover::published_step(Index v) const {
  const RingEnergyAt energy(state_, v, rings_[v], defects_);
  const Vec3 x = state_.position(v);
  const StarSample now = energy.along(x, lines_[v].normal);
  const double step = -now.value / now.slope;
  if (!std::isfinite(step)) return {};
  const double offset = std::clamp(offsets_[v] + step, -radius_, radius_);
  const Vec3 place = place_on(lines_[v], offset, radius_);
  if (place == x || !std::isfinite(energy.value(place))) return {};
  return Step{offset, place, energy.defects(place)};
}

std::optional<OffsetMover::Step> OffsetMover::next_step(Index v) {
  if (is_guarded()) return falling_step(v);
  ++visits_[v];
  return published_step(v);
}

void OffsetMover::take(Index v, const Step& step) {
  const auto before = check_ ? check_->energy(v) : MoveCheck::Energy{};
  state_.move(v, step.place);
  if (check_) check_->require_fall(v, before);
  offsets_[v] = step.offset;
  for (std::size_t j = 0; j < rings_[v].size(); ++j) {
    if (state_.is_inner(rings_[v][j])) defects_[rings_[v][j]] = step.defects[j];
  }
  defects_[v] = step.defects.back();
}

void OffsetMover::wake_around(Index v) {
  const auto wake = [&](Index w) {
    if (state_.is_fixed(w)) return;
    set_aside_[w] = visits_[w] >= options_.max_visits;
    if (set_aside_[w] != 0) return;
    if (!is_enough(w)) push(w);
  };
  wake(v);
  for (const Index j : rings_[v]) {
    if (!state_.is_inner(j)) continue;
    wake(j);
    for (const Index k : rings_[j]) {
      if (state_.is_inner(k) && set_aside_[k] != 0) wake(k);
    }
  }
}

/// The vertex found no step. Its neighbours may, as their ring energies hold its defect; as printed
/// they are not tried.
void OffsetMover::set_aside(Index v) {
  set_aside_[v] = 1;
  if (is_enough(v) || !is_guarded()) return;
  for (const Index j : rings_[v]) {
    if (state_.is_inner(j) && set_aside_[j] == 0 && is_enough(j)) push(j);
  }
}

SweepOutcome OffsetMover::sweep() {
  for (Index v = 0; v < defects_.size(); ++v)
    defects_[v] = state_.defect(v);
  heap_ = {};
  for (Index v = 0; v < defects_.size(); ++v) {
    if (set_aside_[v] == 0 && !is_enough(v)) push(v);
  }
  std::vector<unsigned char> moved(defects_.size(), 0);
  for (std::size_t tries = 0; tries < defects_.size() && left_ > 0; ++tries, --left_) {
    const std::optional<Index> v = pop();
    if (!v) break;
    if (const auto step = next_step(*v)) {
      take(*v, *step);
      wake_around(*v);
      moved[*v] = 1;
    } else {
      set_aside(*v);
    }
  }
  bool done = true;
  for (Index v = 0; v < defects_.size(); ++v)
    done = done && is_enough(v);
  return SweepOutcome(std::accumulate(moved.begin(), moved.end(), std::size_t{0})).ended_if(done);
}

}  // namespace

Sweep make_sweep(const LocalOffset& options, PatchState& state, ThreadPool& /*pool*/) {
  return [mover = OffsetMover(options, state)]() mutable { return mover.sweep(); };
}

}  // namespace planish
