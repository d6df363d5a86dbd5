#include "evolve/auto/shared/border_motion.h"

#include <algorithm>
#include <cmath>

#include "evolve/auto/shared/tuning.h"
#include "geometry/angle_between.h"

namespace planish {

namespace {

using Rule = BorderFreedom::Rule;

Vec3 unit(Vec3 a) {
  const double length = norm(a);
  return length > 0.0 ? (1.0 / length) * a : Vec3{};
}

/// The share of the way from a to b that is nearest to p.
double nearest_share(Vec3 a, Vec3 b, Vec3 p) {
  const Vec3 along = b - a;
  const double square = dot(along, along);
  return square > 0.0 ? std::clamp(dot(p - a, along) / square, 0.0, 1.0) : 0.0;
}

/// Makes slides so small that vertices keep their order: no slide forward exceeds that of the next
/// vertex by more than a share of the gap to it.
/// @param slides at least 0, by vertex of a closed curve
/// @param behind the vertex behind vertex i, as slides go
/// @param gap from vertex i to the one before it, as slides go
template <class Behind, class Gap>
void keep_order(std::vector<double>& slides, const Behind& behind, const Gap& gap) {
  // Twice around, as what one round finds may bind those that it began with.
  std::size_t i = 0;
  for (std::size_t k = 0; k < 2 * slides.size(); ++k) {
    const std::size_t follower = behind(i);
    slides[follower] =
        std::min(slides[follower], slides[i] + tuning::border::k_approach * gap(follower));
    i = follower;
  }
}

}  // namespace

BorderMotion::BorderMotion(const BorderFreedom& freedom, double most_deviation,
                           const PatchState& state)
    : rule_(freedom.rule),
      reach_(rule_ == Rule::within ? std::min(freedom.distance, most_deviation) : most_deviation),
      state_(state) {
  if (!freedom.moves()) return;
  const auto& starts = state.border_starts();
  for (std::size_t l = 0; l + 1 < starts.size(); ++l) {
    Loop loop{starts[l], std::vector<double>(starts[l + 1] - starts[l]), 0.0};
    for (std::size_t i = 0; i < loop.size(); ++i) {
      loop.gaps[i] = norm(origin_of(loop, i + 1) - origin_of(loop, i));
      loop.length += loop.gaps[i];
    }
    loops_.push_back(std::move(loop));
  }
  for (const Loop& loop : loops_) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const bool held =
          state.is_fixed(vertex_of(loop, i)) || (freedom.rule == Rule::slide && is_corner(loop, i));
      marks_.push_back(held ? 0 : 1);
    }
  }
}

int BorderMotion::direction_count() const {
  if (loops_.empty()) return 0;
  return rule_ == Rule::slide ? 1 : 3;
}

bool BorderMotion::is_corner(const Loop& loop, std::size_t i) const {
  const Vec3 at = origin_of(loop, i);
  const Vec3 in = at - origin_of(loop, i + loop.size() - 1), out = origin_of(loop, i + 1) - at;
  return !(angle_between(in, out) <= tuning::border::k_corner);
}

const BorderMotion::Loop& BorderMotion::loop_of(Index v) const {
  const auto after =
      std::upper_bound(loops_.begin(), loops_.end(), v,
                       [](Index vertex, const Loop& loop) { return vertex < loop.first; });
  return *std::prev(after);
}

Vec3 BorderMotion::direction(Index v, int which) const {
  if (rule_ == Rule::within) {
    return {which == 0 ? 1.0 : 0.0, which == 1 ? 1.0 : 0.0, which == 2 ? 1.0 : 0.0};
  }
  const Loop& loop = loop_of(v);
  const std::size_t i = v - loop.first;
  return unit(state_.position(vertex_of(loop, i + 1)) -
              state_.position(vertex_of(loop, i + loop.size() - 1)));
}

void BorderMotion::restrict(Positions& positions) const {
  if (rule_ == Rule::slide) {
    for (const Loop& loop : loops_)
      restrict_slides(loop, positions);
    return;
  }
  for (auto v = static_cast<Index>(state_.inner_count()); v < vertex_count(); ++v) {
    const Vec3 away = positions[v] - state_.origin(v);
    const double far = norm(away);
    if (far > reach_) positions[v] = state_.origin(v) + (reach_ / far) * away;
  }
}

void BorderMotion::restrict_slides(const Loop& loop, Positions& positions) const {
  const std::size_t n = loop.size();
  std::vector<double> forward(n, 0.0), backward(n, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    const Index v = vertex_of(loop, i);
    if (marks_[v - state_.inner_count()] == 0) continue;
    // No place is further away than the way to it along the border.
    const double slide = std::clamp(slid_to(loop, i, positions[v]), -reach_, reach_);
    forward[i] = std::max(slide, 0.0);
    backward[i] = std::max(-slide, 0.0);
  }
  const auto previous = [&](std::size_t i) { return i > 0 ? i - 1 : n - 1; };
  const auto next = [&](std::size_t i) { return i + 1 < n ? i + 1 : 0; };
  keep_order(forward, previous, [&](std::size_t i) { return loop.gaps[i]; });
  keep_order(backward, next, [&](std::size_t i) { return loop.gaps[previous(i)]; });
  for (std::size_t i = 0; i < n; ++i)
    positions[vertex_of(loop, i)] = place_at(loop, i, forward[i] - backward[i]);
}

/// How far along the border, forwards or backwards from vertex i, the point nearest to a place is;
/// corners, fixed vertices and the window end the search.
double BorderMotion::slid_to(const Loop& loop, std::size_t i, Vec3 place) const {
  double best = 0.0, least = norm(place - origin_of(loop, i));
  for (const bool forwards : {true, false}) {
    const std::size_t stride = forwards ? 1 : loop.size() - 1;
    std::size_t at = i;
    for (double walked = 0.0; walked < tuning::border::k_window * loop.length;) {
      const std::size_t to = (at + stride) % loop.size();
      const double gap = loop.gaps[forwards ? at : to];
      const double most =
          gap > 0.0 ? std::min(1.0, (tuning::border::k_window * loop.length - walked) / gap) : 0.0;
      const Vec3 a = origin_of(loop, at), b = origin_of(loop, to);
      const double share = std::min(nearest_share(a, b, place), most);
      const double far = norm(place - (a + share * (b - a)));
      if (far < least) {
        least = far;
        best = (forwards ? 1.0 : -1.0) * (walked + share * gap);
      }
      walked += gap;
      at = to;
      if (at == i || marks_[vertex_of(loop, at) - state_.inner_count()] == 0) break;
    }
  }
  return best;
}

Vec3 BorderMotion::place_at(const Loop& loop, std::size_t i, double slide) const {
  const bool forwards = slide > 0.0;
  const std::size_t stride = forwards ? 1 : loop.size() - 1;
  double left = std::abs(slide);
  std::size_t at = i;
  for (std::size_t walked = 0; left > 0.0 && walked < loop.size(); ++walked) {
    const std::size_t to = (at + stride) % loop.size();
    const double gap = loop.gaps[forwards ? at : to];
    if (left < gap) {
      const Vec3 from = origin_of(loop, at);
      return from + (left / gap) * (origin_of(loop, to) - from);
    }
    left -= gap;
    at = to;
  }
  return origin_of(loop, at);
}

std::vector<Index> BorderMotion::at_limit() const {
  std::vector<Index> vertices;
  if (rule_ != Rule::within) return vertices;
  for (auto v = static_cast<Index>(state_.inner_count()); v < vertex_count(); ++v) {
    if (norm(state_.position(v) - state_.origin(v)) >= tuning::k_at_limit * reach_)
      vertices.push_back(v);
  }
  return vertices;
}

std::vector<SecondDifference> BorderMotion::bends() const {
  std::vector<SecondDifference> bends;
  for (const Loop& loop : loops_) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::size_t before = i + loop.size() - 1;
      const double back = loop.gaps[before % loop.size()], ahead = loop.gaps[i];
      const double both = back + ahead;
      if (!(both > 0.0)) continue;
      bends.push_back({{vertex_of(loop, before), vertex_of(loop, i), vertex_of(loop, i + 1)},
                       {-2.0 * ahead / both, 2.0, -2.0 * back / both}});
    }
  }
  return bends;
}

}  // namespace planish
