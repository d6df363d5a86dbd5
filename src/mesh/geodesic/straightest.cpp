#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include <planish/mesh/geodesic.h>

#include "core/job.h"
#include "core/math.h"
#include "geometry/angle_between.h"
#include "mesh/geodesic/unfolded_mesh.h"

namespace planish {

namespace {

constexpr std::size_t k_most_crossed = 20'000'000;
constexpr std::size_t k_steps_between_questions = 1024;
constexpr double k_no_angle = 1e-12;  // radians

/// Walks straight on over a mesh.
class StraightWalk {
 public:
  StraightWalk(const UnfoldedMesh& mesh, const SurfacePoint& from, double length)
      : mesh_(mesh), half_edges_(mesh.half_edges()), on_(from), left_(length) {
    path_.points.push_back(from);
  }

  GeodesicPath run(Vec3 direction, const Context& context) {
    begin(direction);
    for (std::size_t steps = 1; !is_done_; ++steps) {
      if (steps % k_steps_between_questions == 0) stop_if_cancelled(context);
      if (steps > k_most_crossed) {
        throw Error(ErrorCode::too_large,
                    "the path crosses more than 20 million edges: ask for a shorter one");
      }
      step();
    }
    if (path_.points.size() == 1) path_.points.push_back(path_.points.front());
    path_.length /= mesh_.scale();
    return std::move(path_);
  }

 private:
  /// A side of the triangle in the frame of at_.
  struct Side {
    Index half_edge;
    Vec2 from, along;
  };

  void begin(Vec3 direction);
  Vec2 in_plane(Index h, Vec3 direction) const;
  std::array<Side, 3> sides() const;
  void step();
  void cross_edge(Index side, Vec2 place, Vec2 heading);
  void go_around(Index v, double angle);

  const UnfoldedMesh& mesh_;
  const HalfEdges& half_edges_;
  SurfacePoint on_;       ///< where the walk is
  double left_;           ///< of the length
  Index at_ = 0;          ///< it goes through the triangle of this half-edge
  Vec2 place_, heading_;  ///< in its frame; heading of length 1
  bool is_done_ = false;
  GeodesicPath path_;
};

/// The direction in the frame of h, of length 1.
Vec2 StraightWalk::in_plane(Index h, Vec3 direction) const {
  const Vec3 from = mesh_.position(half_edges_.from(h));
  const Vec3 x = (1.0 / mesh_.length(h)) * (mesh_.position(half_edges_.to(h)) - from);
  const Vec3 up = cross(cross(x, mesh_.position(half_edges_.apex(h)) - from), x);
  const double size = math::hypot(direction.x, direction.y, direction.z);
  const Vec3 unit = (1.0 / size) * direction;
  const Vec2 flat = {dot(unit, x), dot(unit, (1.0 / norm(up)) * up)};
  if (!(norm(flat) > k_no_angle)) {
    throw Error(ErrorCode::option_out_of_range,
                "the direction is 0 or normal to the triangle where the path begins: give one "
                "along the surface");
  }
  return (1.0 / norm(flat)) * flat;
}

void StraightWalk::begin(Vec3 direction) {
  at_ = 3 * mesh_.triangle_of(on_.corners);
  const auto zeros = std::count(on_.shares.begin(), on_.shares.end(), 0.0);
  // At a vertex the half-edge from it, on an edge that edge.
  while ((zeros == 2 && half_edges_.from(at_) != mesh_.vertex_of(on_)) ||
         (zeros == 1 && !mesh_.is_on_edge(at_, on_)))
    ++at_;
  place_ = mesh_.in_frame(at_, on_);
  heading_ = in_plane(at_, direction);
  if (zeros == 2) {
    go_around(half_edges_.from(at_), mesh_.angle_to(at_) + math::atan2(heading_.y, heading_.x));
  } else if (zeros == 1 && heading_.y < 0.0) {
    cross_edge(at_, place_, heading_);
  }
}

std::array<StraightWalk::Side, 3> StraightWalk::sides() const {
  const Index next = HalfEdges::next(at_), previous = HalfEdges::previous(at_);
  const Vec2 to = {mesh_.length(at_), 0.0}, apex = mesh_.apex(at_);
  return {{{at_, {}, to}, {next, to, apex - to}, {previous, apex, Vec2{} - apex}}};
}

/// Goes through the triangle.
void StraightWalk::step() {
  const std::array<Side, 3> all = sides();
  const Side* exit = nullptr;
  double distance = 0.0;
  for (const Side& side : all) {
    const double out = -cross(side.along, heading_);
    if (!(out > 0.0) || mesh_.is_on_edge(side.half_edge, on_)) continue;
    const double to_side = std::max(0.0, cross(side.along, place_ - side.from) / out);
    if (exit != nullptr && to_side >= distance) continue;
    exit = &side;
    distance = to_side;
  }
  if (exit == nullptr) {  // a triangle without area
    is_done_ = true;
    return;
  }
  const double t = cross(place_ - exit->from, heading_) / cross(exit->along, heading_);
  const SurfacePoint next = mesh_.on_edge(exit->half_edge, std::clamp(t, 0.0, 1.0));
  if (distance >= left_) {
    on_ = mesh_.between(at_ / 3, on_, next, distance > 0.0 ? left_ / distance : 0.0);
    path_.points.push_back(on_);
    path_.length += left_;
    is_done_ = true;
    return;
  }
  on_ = next;
  path_.points.push_back(on_);
  path_.length += distance;
  left_ -= distance;
  const Index v = mesh_.vertex_of(on_);
  if (v == HalfEdges::none) {
    const Vec2 place = {std::clamp(t, 0.0, 1.0) * mesh_.length(exit->half_edge), 0.0};
    const auto rotated = [&](auto in_side) { return in_side(place_ + heading_) - in_side(place_); };
    const Vec2 heading = exit == &all[0] ? heading_
                         : exit == &all[1]
                             ? rotated([&](Vec2 p) { return mesh_.in_next(at_, p); })
                             : rotated([&](Vec2 p) { return mesh_.in_previous(at_, p); });
    cross_edge(exit->half_edge, place, heading);
    return;
  }
  if (half_edges_.is_border(v)) {
    is_done_ = true;
    return;
  }
  const auto side = std::find_if(all.begin(), all.end(),
                                 [&](const Side& s) { return half_edges_.from(s.half_edge) == v; });
  go_around(v, mesh_.angle_to(side->half_edge) + angle_between(side->along, Vec2{} - heading_) +
                   0.5 * mesh_.angle_around(v));
}

/// Into the triangle beyond a side.
/// @param place, heading in the frame of the side
void StraightWalk::cross_edge(Index side, Vec2 place, Vec2 heading) {
  at_ = half_edges_.twin(side);
  is_done_ = at_ == HalfEdges::none;
  if (is_done_) return;
  place_ = mesh_.in_twin(side, place);
  heading_ = (-1.0 / norm(heading)) * heading;
}

/// Into the triangle at a vertex that has the angle, which counts as UnfoldedMesh::angle_to().
void StraightWalk::go_around(Index v, double angle) {
  const double around = mesh_.angle_around(v);
  if (!half_edges_.is_border(v)) {
    angle = std::fmod(angle, around);
    if (angle < 0.0) angle += around;
  } else if (angle < -k_no_angle || angle > around + k_no_angle) {
    is_done_ = true;
    return;
  }
  double low = 0.0;
  bool is_found = false;
  half_edges_.for_each_corner(v, [&](Index h) {
    const double high = low + mesh_.corner_angle(h);
    if (!is_found) {
      at_ = h;
      const auto [sine, cosine] = math::sincos(std::clamp(angle - low, 0.0, high - low));
      heading_ = {cosine, sine};
    }
    is_found = is_found || angle < high;
    low = high;
  });
  place_ = {};
  on_ = mesh_.at_vertex(at_);
}

}  // namespace

GeodesicPath straightest(const Patch& patch, const SurfacePoint& from, Vec3 direction,
                         double length, const Context& context) {
  if (!(length >= 0.0 && std::isfinite(length))) {
    throw Error(ErrorCode::option_out_of_range,
                "the length of a path is negative or no number: give 0 or more");
  }
  const UnfoldedMesh mesh(patch);
  StraightWalk walk(mesh, mesh.checked(from), length * mesh.scale());
  GeodesicPath path = walk.run(direction, context);
  path.points.front() = from;
  return path;
}

}  // namespace planish
