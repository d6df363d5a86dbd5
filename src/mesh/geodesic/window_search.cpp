#include "mesh/geodesic/window_search.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/job.h"
#include "core/math.h"
#include "geometry/angle_between.h"

namespace planish {

namespace {

/// Of distances, relative: what is longer by less may be as short.
constexpr double k_equal = 1e-13;
/// Of directions: what lies beside a window by less is seen through it. Rays that end at a vertex
/// leave no gap between the windows on its sides.
constexpr double k_seen = 1e-11;
/// Paths do not bend at a vertex whose angle sum is above 2 pi by less.
constexpr double k_flat = 1e-12;
constexpr std::size_t k_between_questions = 1024;

/// Where the ray from `source` through `through` meets the x axis; NaN where it does not.
double crossing(Vec2 source, Vec2 through) {
  const double rise = through.y - source.y;
  return rise > 0.0 ? source.x - source.y * ((through.x - source.x) / rise)
                    : std::numeric_limits<double>::quiet_NaN();
}

/// Puts an item where another one is no longer used, or at the end. @return where
template <class T>
Index put(std::vector<T>& list, std::vector<Index>& unused, const T& item) {
  if (unused.empty()) {
    list.push_back(item);
    return static_cast<Index>(list.size() - 1);
  }
  const Index place = unused.back();
  unused.pop_back();
  list[place] = item;
  return place;
}

}  // namespace

WindowSearch::WindowSearch(const UnfoldedMesh& mesh, const SurfacePoint& from,
                           const SurfacePoint& to, double at_most)
    : mesh_(mesh),
      half_edges_(mesh.half_edges()),
      from_(from),
      to_(to),
      goal_place_(mesh.position(to)),
      goal_triangles_(mesh.triangles_at(to)),
      goal_{.distance = at_most * (1.0 + 1e-12)},
      arrivals_(mesh.vertex_count()),
      angles_(mesh.vertex_count(), -1.0),
      splits_(half_edges_.size()) {}

Sleeve WindowSearch::run(const Sleeve& known, const Context& context) {
  start();
  for (std::size_t steps = 1; !queue_.empty(); ++steps) {
    if (steps % k_between_questions == 0) stop_if_cancelled(context);
    const Entry entry = queue_.front();
    if (entry.bound > goal_.distance) break;
    std::pop_heap(queue_.begin(), queue_.end());
    queue_.pop_back();
    if (entry.is_vertex) {
      pass_on_vertex(entry.item);
    } else {
      const Window window = windows_[entry.item];
      unused_windows_.push_back(entry.item);
      pass_on_window(window);
      release(window.trace);
    }
  }
  return goal_.triangle == none ? known : found();
}

void WindowSearch::start() {
  for (const Index t : mesh_.triangles_at(from_)) {
    for (Index h = 3 * t; h < 3 * t + 3; ++h) {
      const Vec2 place = mesh_.in_frame(h, from_);
      arrive(half_edges_.from(h),
             {.distance = norm(place), .corner = h, .turn = angle_between(Vec2{1.0, 0.0}, place)});
      const Index twin = half_edges_.twin(h);
      if (twin == none || mesh_.is_on_edge(h, from_)) continue;
      add({.edge = twin,
           .trace = none,
           .begin = 0.0,
           .end = mesh_.length(h),
           .source = mesh_.in_twin(h, place),
           .before = 0.0},
          none, none);
    }
  }
}

void WindowSearch::arrive(Index v, const Arrival& arrival) {
  Arrival& known = arrivals_[v];
  if (!(arrival.distance < known.distance * (1.0 - k_equal))) return;
  if (arrival.trace != none) ++traces_[arrival.trace].users;
  const Index before = known.trace;
  const double passed_on = known.passed_on;
  known = arrival;
  known.passed_on = passed_on;
  release(before);
  const double rest = norm(mesh_.position(v) - goal_place_);
  if (may_bend(v)) push({known.distance + rest, v, true});
  for (const Index t : goal_triangles_) {
    if (mesh_.corner(t, v) != none) reach_goal({known.distance + rest, none, v, t});
  }
}

void WindowSearch::reach_goal(const Goal& goal) {
  if (!(goal.distance < goal_.distance)) return;
  if (goal.trace != none) ++traces_[goal.trace].users;
  release(goal_.trace);
  goal_ = goal;
}

/// Whether a shortest path can bend at a vertex.
bool WindowSearch::may_bend(Index v) {
  double& around = angles_[v];
  if (around < 0.0) around = mesh_.angle_around(v);
  return half_edges_.is_border(v) ? around > std::numbers::pi - k_flat
                                  : around > 2.0 * std::numbers::pi + k_flat;
}

void WindowSearch::push(Entry entry) {
  queue_.push_back(entry);
  std::push_heap(queue_.begin(), queue_.end());
}

/// Puts a window into the queue, unless it can be on no shortest path.
void WindowSearch::add(Window window, Index root, Index parent) {
  if (!(window.end > window.begin) || is_beaten(window)) return;
  const double bound = bound_of(window);
  if (!(bound <= goal_.distance)) return;
  if (parent != none) ++traces_[parent].users;
  window.trace = put(traces_, unused_traces_, {window.edge, root, parent, 1});
  push({bound, put(windows_, unused_windows_, window), false});
}

void WindowSearch::release(Index trace) {
  while (trace != none && --traces_[trace].users == 0) {
    unused_traces_.push_back(trace);
    trace = traces_[trace].parent;
  }
}

/// The least distance to its source and on to the goal in a straight line through space, by way of
/// the window: the goal is turned around the edge into the plane, beyond the edge.
double WindowSearch::bound_of(const Window& window) const {
  const Vec3 begin = mesh_.position(half_edges_.from(window.edge));
  const Vec3 end = mesh_.position(half_edges_.to(window.edge));
  const Vec3 axis = (1.0 / mesh_.length(window.edge)) * (end - begin);
  const Vec3 place = goal_place_ - begin;
  const Vec2 goal = {dot(place, axis), norm(cross(place, axis))};
  const Vec2 source = window.source;
  const double rise = goal.y - source.y;
  const double straight =
      rise > 0.0 ? source.x - source.y * ((goal.x - source.x) / rise) : source.x;
  const Vec2 at = {std::clamp(straight, window.begin, window.end), 0.0};
  return window.before + norm(at - source) + norm(goal - at);
}

/// Whether paths through the vertices of the edge or the third one behind it are shorter at an end
/// of the window, and then everywhere in it (Xin and Wang 2009).
bool WindowSearch::is_beaten(const Window& window) const {
  const Vec2 begin = {window.begin, 0.0}, end = {window.end, 0.0};
  const double to_begin = (window.before + norm(begin - window.source)) * (1.0 - k_equal);
  const double to_end = (window.before + norm(end - window.source)) * (1.0 - k_equal);
  const double length = mesh_.length(window.edge);
  if (arrivals_[half_edges_.from(window.edge)].distance + window.end < to_end) return true;
  if (arrivals_[half_edges_.to(window.edge)].distance + (length - window.begin) < to_begin)
    return true;
  const Index twin = half_edges_.twin(window.edge);
  const Vec2 third = mesh_.in_twin(twin, mesh_.apex(twin));
  const double distance = arrivals_[half_edges_.apex(twin)].distance;
  const bool on_right = cross(0.5 * (begin + end) - window.source, third - window.source) < 0.0;
  return on_right ? distance + norm(third - begin) < to_begin
                  : distance + norm(third - end) < to_end;
}

/// Makes windows of what is seen from a vertex that the path bends at: where both sides of the way
/// on have pi or more, or the border.
void WindowSearch::pass_on_vertex(Index v) {
  Arrival& arrival = arrivals_[v];
  if (!(arrival.distance < arrival.passed_on)) return;
  arrival.passed_on = arrival.distance;
  const Arrival known = arrival;
  if (known.distance == 0.0) return;  // it is the start
  constexpr double pi = std::numbers::pi;
  const double came = mesh_.angle_to(known.corner) + known.turn;
  // Ways on are at angles of pi to this from where it came, on both sides.
  const double most = half_edges_.is_border(v) ? infinite : angles_[v] - pi;
  double low = 0.0;
  half_edges_.for_each_corner(v, [&](Index h) {
    const double angle = mesh_.corner_angle(h);
    const auto see = [&](double first, double last) {
      const double begin = std::max(first - low, 0.0), end = std::min(last - low, angle);
      if (begin < end) add_seen(h, begin, end, known.distance, v);
    };
    see(came + pi - k_flat, came + most + k_flat);
    see(came - most - k_flat, came - pi + k_flat);
    low += angle;
    // Along edges, from both of their ends.
    arrive(half_edges_.to(h), {.distance = known.distance + mesh_.length(h),
                               .root = v,
                               .corner = HalfEdges::next(h),
                               .turn = mesh_.corner_angle(HalfEdges::next(h))});
    const Index back = HalfEdges::previous(h);
    if (half_edges_.twin(back) != none) return;
    arrive(half_edges_.from(back),
           {.distance = known.distance + mesh_.length(back), .root = v, .corner = back});
  });
}

/// Adds what is seen through the side of a triangle from the corner on the other side.
/// @param low, high angles from the half-edge `corner`
void WindowSearch::add_seen(Index corner, double low, double high, double before, Index root) {
  const Index opposite = HalfEdges::next(corner), twin = half_edges_.twin(opposite);
  if (twin == none) return;
  const Vec2 first = {mesh_.length(corner), 0.0}, second = mesh_.apex(corner);
  const auto share_at = [&](double angle) {
    const auto [sine, cosine] = math::sincos(angle);
    const double to_first = cross(first, {cosine, sine}), to_second = cross(second, {cosine, sine});
    return std::clamp(to_first / (to_first - to_second), 0.0, 1.0);
  };
  const double length = mesh_.length(opposite);
  const double end = low == 0.0 ? length : length * (1.0 - share_at(low));
  const double begin = high == mesh_.corner_angle(corner) ? 0.0 : length * (1.0 - share_at(high));
  add({.edge = twin,
       .trace = none,
       .begin = begin,
       .end = end,
       .source = mesh_.in_twin(opposite, mesh_.apex(opposite)),
       .before = before},
      root, none);
}

void WindowSearch::pass_on_window(const Window& window) {
  const Index h = window.edge;
  const Vec2 left_ray = Vec2{window.begin, 0.0} - window.source;
  const Vec2 right_ray = Vec2{window.end, 0.0} - window.source;
  // How far a direction is to the left of the left and of the right ray.
  const auto turns = [&](Vec2 ray) {
    return std::pair{cross(left_ray, ray), cross(right_ray, ray)};
  };
  const auto is_seen = [&](Vec2 ray) {
    const auto [of_left, of_right] = turns(ray);
    const double slack = k_seen * norm(ray);
    return of_left <= slack * norm(left_ray) && of_right >= -slack * norm(right_ray);
  };
  if (std::find(goal_triangles_.begin(), goal_triangles_.end(), h / 3) != goal_triangles_.end()) {
    const Vec2 ray = mesh_.in_frame(h, to_) - window.source;
    if (is_seen(ray)) reach_goal({window.before + norm(ray), window.trace, none, h / 3});
  }
  const Vec2 ray = mesh_.apex(h) - window.source;
  const auto [of_left, of_right] = turns(ray);
  bool left = of_left<0.0, right = of_right> 0.0;
  if (is_seen(ray)) {
    const double distance = window.before + norm(ray);
    arrive(half_edges_.apex(h), {.distance = distance,
                                 .trace = window.trace,
                                 .corner = HalfEdges::previous(h),
                                 .turn = angle_between(mesh_.apex(h), ray)});
    // One angle, one split: all but the nearest window go on on one side only.
    if (left && right) {
      Split& split = splits_[h];
      const double at = crossing(window.source, mesh_.apex(h));
      if (distance < split.distance) {
        split = {distance, at};
      } else if (distance > split.distance * (1.0 + k_equal)) {
        (at < split.at ? right : left) = false;
      }
    }
  }
  add_children(window, of_left, of_right, left, right);
}

/// Adds what is seen through the two other sides of the triangle.
void WindowSearch::add_children(const Window& window, double of_left, double of_right, bool left,
                                bool right) {
  const Index h = window.edge;
  const auto add_child = [&](Index side, bool reaches_begin, bool reaches_end, auto in_frame) {
    const Index twin = half_edges_.twin(side);
    if (twin == none) return;
    const auto place = [&](Vec2 p) { return mesh_.in_twin(side, in_frame(p)); };
    const double length = mesh_.length(side);
    const Vec2 source = place(window.source);
    const auto meets = [&](double x) {
      return std::clamp(crossing(source, place({x, 0.0})), 0.0, length);
    };
    add({.edge = twin,
         .trace = none,
         .begin = reaches_begin ? 0.0 : meets(window.begin),
         .end = reaches_end ? length : meets(window.end),
         .source = source,
         .before = window.before},
        traces_[window.trace].root, window.trace);
  };
  if (left) {
    add_child(HalfEdges::previous(h), window.begin == 0.0, of_right >= 0.0,
              [&](Vec2 p) { return mesh_.in_previous(h, p); });
  }
  if (right) {
    add_child(HalfEdges::next(h), of_left <= 0.0, window.end == mesh_.length(h),
              [&](Vec2 p) { return mesh_.in_next(h, p); });
  }
}

/// The triangles of the best path, piece by piece from the goal back to the start.
Sleeve WindowSearch::found() const {
  struct Piece {
    Index trace, triangle;
    Index to;  // vertex
  };
  std::vector<Piece> pieces = {{goal_.trace, goal_.triangle, none}};
  Index v = goal_.trace != none ? traces_[goal_.trace].root : goal_.vertex;
  while (v != none) {
    const Arrival& arrival = arrivals_[v];
    pieces.push_back({arrival.trace, arrival.corner / 3, v});
    v = arrival.trace != none ? traces_[arrival.trace].root : arrival.root;
  }
  Sleeve sleeve;
  for (auto piece = pieces.rbegin(); piece != pieces.rend(); ++piece) {
    std::vector<Index> entered;
    for (Index i = piece->trace; i != none; i = traces_[i].parent)
      entered.push_back(traces_[i].edge);
    const Index first = entered.empty() ? piece->triangle : half_edges_.twin(entered.back()) / 3;
    if (piece == pieces.rbegin()) {
      sleeve.first = first;
    } else {
      turn_around(sleeve, mesh_, std::prev(piece)->to, first);
    }
    for (auto h = entered.rbegin(); h != entered.rend(); ++h)
      enter(sleeve, half_edges_, *h);
  }
  return sleeve;
}

}  // namespace planish
