#include "mesh/imprint/constrained_delaunay.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/polygon/diagonal.h"

namespace planish {

namespace {

constexpr Index k_none = std::numeric_limits<Index>::max();  // beyond a side of the triangle
constexpr int k_deepest = 200;  // of segments in segments: rounding alone could go on
constexpr int k_exact = 20;     // from here on only nodes that are on a segment count as on it
constexpr double k_most = 2.0;  // of reach: how far a segment may be led aside, all steps together

}  // namespace

ConstrainedDelaunay::ConstrainedDelaunay(const std::array<double, 3>& sides, double reach) {
  auto [a, b, c] = sides;
  if (!(a > 0.0) || !(c > 0.0)) a = b = c = 1.0;  // of no form
  const double along = (a * a + c * c - b * b) / (2.0 * a);
  right_ = {a, 0.0};
  up_ = {along, std::sqrt(std::max(c * c - along * along, 0.0))};
  reach_ = std::min(reach, 0.01 * a * up_.y / std::max({a, b, c}));
  for (const Vec2 corner : {Vec2{0.0, 0.0}, Vec2{k_cells, 0.0}, Vec2{0.0, k_cells}})
    new_node(corner);
  parts_.push_back({{0, 1, 2}, {k_none, k_none, k_none}});
  part_of_.assign(3, 0);
}

Index ConstrainedDelaunay::new_node(Vec2 grid) {
  grid_.push_back(grid);
  places_.push_back((grid.x / k_cells) * right_ + (grid.y / k_cells) * up_);
  part_of_.push_back(k_none);
  return static_cast<Index>(grid_.size() - 1);
}

bool ConstrainedDelaunay::is_fixed(Index part, std::size_t slot) const {
  const auto& [corners, across] = parts_[part];
  return across[slot] == k_none || is_segment(corners[slot], corners[(slot + 1) % 3]);
}

Vec2 ConstrainedDelaunay::grid_at(Vec2 place) const {
  const double whole = planish::cross(right_, up_);
  return {std::nearbyint(planish::cross(place, up_) / whole * k_cells),
          std::nearbyint(planish::cross(right_, place) / whole * k_cells)};
}

double ConstrainedDelaunay::distance_to_corner(Vec2 place) const {
  double nearest = std::numeric_limits<double>::infinity();
  const auto look_at = [&](const Part& part) {
    for (const Index corner : part.corners)
      nearest = std::min(nearest, norm(places_[corner] - place));
  };
  const Part& here = parts_[locate(grid_at(place))];
  look_at(here);
  for (const Index other : here.across) {  // one may be just beyond a side
    if (other != k_none) look_at(parts_[other]);
  }
  return nearest;
}

int ConstrainedDelaunay::side(Index a, Index b, Index c) const {
  return side_of(grid_[a], grid_[b], grid_[c]);
}

/// Of a place beside a segment, to the line that it is a part of.
double ConstrainedDelaunay::distance_to(Index a, Index b, Vec2 p) const {
  const Vec2 along = places_[b] - places_[a];
  return std::abs(planish::cross(along, p - places_[a])) / std::max(norm(along), 1e-300);
}

/// As side(), but 0 for nodes beside the segment within reach, or within 1e-9 of a side of the
/// triangle.
int ConstrainedDelaunay::side_of_segment(Index a, Index b, Index c, double reach) const {
  constexpr double near = 1e-9 * k_cells;
  const Vec2 along = grid_[b] - grid_[a], to = grid_[c] - grid_[a];
  const double length = norm(along);
  const double way = dot(to, along);
  const bool is_beside = way > 0.0 && way < length * length;
  if (is_beside && std::abs(planish::cross(along, to)) <= near * length) return 0;
  // Not beside the ends: then both parts are shorter than the segment.
  const double whole = norm(places_[b] - places_[a]);
  const double part = dot(places_[c] - places_[a], places_[b] - places_[a]) / whole;
  const bool is_between = part > 2.0 * reach && part < whole - 2.0 * reach;
  return is_between && distance_to(a, b, places_[c]) <= reach ? 0 : side(a, b, c);
}

std::size_t ConstrainedDelaunay::slot_of(Index part, Index corner) const {
  const Triangle& corners = parts_[part].corners;
  return corners[0] == corner ? 0 : corners[1] == corner ? 1 : 2;
}

/// The side from a to b, or from b to a where only that one is inside.
std::optional<ConstrainedDelaunay::Side> ConstrainedDelaunay::edge(Index a, Index b) const {
  for (const bool back : {false, true}) {
    Index part = part_of_[a];
    for (std::size_t count = 0; part != k_none && count <= parts_.size(); ++count) {
      const Part& at = parts_[part];
      const std::size_t slot = slot_of(part, a);
      if (at.corners[(slot + 1) % 3] == b) return Side{part, slot};
      if (at.corners[(slot + 2) % 3] == b) return Side{part, (slot + 2) % 3};
      part = at.across[back ? slot : (slot + 2) % 3];
      if (part == part_of_[a]) break;
    }
  }
  return std::nullopt;
}

/// The part that holds a place: a walk towards it, or where that goes round, a look at all.
Index ConstrainedDelaunay::locate(Vec2 grid) const {
  const auto side_outside = [&](Index part) -> std::optional<std::size_t> {
    const Triangle& t = parts_[part].corners;
    for (std::size_t k = 0; k < 3; ++k) {
      if (side_of(grid_[t[k]], grid_[t[(k + 1) % 3]], grid) < 0) return k;
    }
    return std::nullopt;
  };
  auto part = static_cast<Index>(parts_.size() - 1);
  for (std::size_t count = 0; count < 2 * parts_.size(); ++count) {
    const auto outside = side_outside(part);
    if (!outside) return part;
    if (parts_[part].across[*outside] == k_none) break;
    part = parts_[part].across[*outside];
  }
  for (Index p = 0; p < parts_.size(); ++p) {
    if (!side_outside(p)) return p;
  }
  return 0;
}

void ConstrainedDelaunay::replace_across(Index part, Index before, Index now) {
  if (part == k_none) return;
  auto& across = parts_[part].across;
  std::replace(across.begin(), across.end(), before, now);
}

Index ConstrainedDelaunay::add(Vec2 grid) {
  const Index part = locate(grid);
  const Triangle corners = parts_[part].corners;
  for (const Index corner : corners) {
    if (grid_[corner] == grid) return corner;
  }
  const Index node = new_node(grid);
  for (std::size_t k = 0; k < 3; ++k) {
    if (side(corners[k], corners[(k + 1) % 3], node) == 0) {
      divide_side({part, k}, node);
      return node;
    }
  }
  divide_part(part, node);
  return node;
}

void ConstrainedDelaunay::divide_part(Index part, Index node) {
  const auto [corners, across] = parts_[part];
  const auto second = static_cast<Index>(parts_.size()), third = second + 1;
  parts_[part] = {{corners[0], corners[1], node}, {across[0], second, third}};
  parts_.push_back({{corners[1], corners[2], node}, {across[1], third, part}});
  parts_.push_back({{corners[2], corners[0], node}, {across[2], part, second}});
  replace_across(across[1], part, second);
  replace_across(across[2], part, third);
  part_of_[node] = part_of_[corners[0]] = part_of_[corners[1]] = part;
  part_of_[corners[2]] = second;
  settle({key(corners[0], corners[1]), key(corners[1], corners[2]), key(corners[2], corners[0])});
}

void ConstrainedDelaunay::divide_side(Side side, Index node) {
  const Part left = parts_[side.part];
  const Index a = left.corners[side.slot], b = left.corners[(side.slot + 1) % 3],
              c = left.corners[(side.slot + 2) % 3];
  const Index beyond_bc = left.across[(side.slot + 1) % 3],
              beyond_ca = left.across[(side.slot + 2) % 3], other = left.across[side.slot];
  const auto at_b = static_cast<Index>(parts_.size());
  const Index other_at_b = other == k_none ? k_none : at_b + 1;
  parts_[side.part] = {{a, node, c}, {other, at_b, beyond_ca}};
  parts_.push_back({{node, b, c}, {other_at_b, beyond_bc, side.part}});
  replace_across(beyond_bc, side.part, at_b);
  part_of_[a] = part_of_[node] = part_of_[c] = side.part;
  part_of_[b] = at_b;
  std::vector<Key> open = {key(b, c), key(c, a)};
  if (other != k_none) {
    const Part right = parts_[other];
    const std::size_t slot = slot_of(other, b);
    const Index d = right.corners[(slot + 2) % 3];
    const Index beyond_ad = right.across[(slot + 1) % 3], beyond_db = right.across[(slot + 2) % 3];
    parts_[other] = {{node, a, d}, {side.part, beyond_ad, other_at_b}};
    parts_.push_back({{b, node, d}, {at_b, other, beyond_db}});
    replace_across(beyond_db, other, other_at_b);
    part_of_[d] = other;
    open.push_back(key(a, d));
    open.push_back(key(d, b));
  }
  if (const auto segment = segments_.extract(key(a, b))) {
    divided_at_[key(a, b)] = node;
    segments_[key(a, node)] = segments_[key(node, b)] = segment.mapped();
  }
  settle(std::move(open));
}

/// Whether the quad around an inner side has no corner of 180 degrees or more at its ends.
bool ConstrainedDelaunay::is_convex(Side at) const {
  const Part& left = parts_[at.part];
  const Index other = left.across[at.slot];
  const Index a = left.corners[at.slot], b = left.corners[(at.slot + 1) % 3],
              c = left.corners[(at.slot + 2) % 3];
  const Index d = parts_[other].corners[(slot_of(other, b) + 2) % 3];
  return side(c, a, d) > 0 && side(d, b, c) > 0;
}

void ConstrainedDelaunay::flip(Side at) {
  const Part left = parts_[at.part];
  const Index u = left.across[at.slot];
  const Part right = parts_[u];
  const Index a = left.corners[at.slot], b = left.corners[(at.slot + 1) % 3],
              c = left.corners[(at.slot + 2) % 3];
  const std::size_t slot = slot_of(u, b);
  const Index d = right.corners[(slot + 2) % 3];
  const Index beyond_ad = right.across[(slot + 1) % 3], beyond_db = right.across[(slot + 2) % 3];
  const Index beyond_bc = left.across[(at.slot + 1) % 3],
              beyond_ca = left.across[(at.slot + 2) % 3];
  parts_[at.part] = {{a, d, c}, {beyond_ad, u, beyond_ca}};
  parts_[u] = {{d, b, c}, {beyond_db, beyond_bc, at.part}};
  replace_across(beyond_ad, u, at.part);
  replace_across(beyond_bc, at.part, u);
  part_of_[a] = part_of_[c] = part_of_[d] = at.part;
  part_of_[b] = u;
}

/// Flips edges until none of those that may be has a better one across its quad.
void ConstrainedDelaunay::settle(std::vector<Key> open) {
  std::size_t flips_left = 1000 + 100 * parts_.size();  // rounding could let flips go round
  while (!open.empty() && flips_left > 0) {
    const auto [a, b] = open.back();
    open.pop_back();
    if (is_segment(a, b)) continue;
    const auto at = edge(a, b);
    if (!at || parts_[at->part].across[at->slot] == k_none || !is_convex(*at)) continue;
    const Part& left = parts_[at->part];
    const Index other = left.across[at->slot];
    const Index from = left.corners[at->slot], to = left.corners[(at->slot + 1) % 3],
                c = left.corners[(at->slot + 2) % 3];
    const Index d = parts_[other].corners[(slot_of(other, to) + 2) % 3];
    if (better_diagonal({places_[from], places_[d], places_[to], places_[c]}) !=
        Diagonal::through_second)
      continue;
    flip(*at);
    --flips_left;
    for (const Key& around : {key(from, d), key(d, to), key(to, c), key(c, from)})
      open.push_back(around);
  }
}

void ConstrainedDelaunay::connect(Index a, Index b) {
  connect(a, b, {});
}

double ConstrainedDelaunay::reach_of(const Led& led) const {
  return led.depth < k_exact ? std::clamp(k_most * reach_ - led.aside, 0.0, reach_) : 0.0;
}

/// The part at a that the segment leaves through the side across from it; a node beside the segment
/// instead, where one of its corners is.
ConstrainedDelaunay::Leaving ConstrainedDelaunay::leaving(Index a, Index b, double reach) const {
  // Beside the segment by one metric or the other: they differ where the triangle is long.
  const auto is_ahead = [&](Index node) {
    return dot(grid_[node] - grid_[a], grid_[b] - grid_[a]) > 0.0 ||
           dot(places_[node] - places_[a], places_[b] - places_[a]) > 0.0;
  };
  for (Index part = 0; part < parts_.size(); ++part) {
    const Triangle& t = parts_[part].corners;
    const auto at = std::find(t.begin(), t.end(), a);
    if (at == t.end()) continue;
    const auto slot = static_cast<std::size_t>(at - t.begin());
    const Index p = t[(slot + 1) % 3], q = t[(slot + 2) % 3];
    const int of_p = side_of_segment(a, b, p, reach), of_q = side_of_segment(a, b, q, reach);
    if (of_p == 0 && is_ahead(p)) return {.node = p};
    if (of_q == 0 && is_ahead(q)) return {.node = q};
    if (of_p < 0 && of_q > 0) return {.side = Side{part, (slot + 1) % 3}};
  }
  return {};
}

/// Makes an edge a segment, or part of another one.
void ConstrainedDelaunay::keep(Index a, Index b, double aside) {
  double& kept = segments_[key(a, b)];
  kept = std::max(kept, aside);
}

/// Leads a segment to a node beside it, and on from there.
void ConstrainedDelaunay::connect_over(Index node, Index a, Index b, const Led& led) {
  lead_over(node, a, b, {led.aside + distance_to(a, b, places_[node]), led.depth + 1});
}

void ConstrainedDelaunay::lead_over(Index node, Index a, Index b, const Led& led) {
  farthest_ = std::max(farthest_, led.aside);
  divided_at_[key(a, b)] = node;
  connect(a, node, led);
  connect(node, b, led);
}

void ConstrainedDelaunay::connect(Index a, Index b, const Led& led) {
  if (a == b || led.depth > k_deepest) return;
  if (edge(a, b)) return keep(a, b, led.aside);
  const double reach = reach_of(led);
  auto [way, node] = leaving(a, b, reach);
  if (node) return connect_over(*node, a, b, led);
  std::vector<Key> crossed;
  while (way) {
    const Part& part = parts_[way->part];
    const Index p = part.corners[way->slot], q = part.corners[(way->slot + 1) % 3];
    if (is_segment(p, q)) return cross(key(p, q), a, b, led);
    crossed.push_back(key(p, q));
    const Index next = part.across[way->slot];
    if (next == k_none) return;                 // b is outside
    const std::size_t slot = slot_of(next, q);  // the side from q to p begins here
    const Index tip = parts_[next].corners[(slot + 2) % 3];
    if (tip == b) break;
    const int of_tip = side_of_segment(a, b, tip, reach);
    if (of_tip == 0) return connect_over(tip, a, b, led);
    // p is to the right, q to the left: on through the side that has its ends on both sides.
    way = Side{next, of_tip < 0 ? (slot + 2) % 3 : (slot + 1) % 3};
  }
  flip_across(a, b, std::move(crossed));
  keep(a, b, led.aside);
}

/// Sloan 1993: edges that the segment crosses are flipped until none does.
void ConstrainedDelaunay::flip_across(Index a, Index b, std::vector<Key> crossed) {
  std::vector<Key> made;
  std::size_t left = 1000 + 100 * crossed.size() * crossed.size();
  for (std::size_t k = 0; k < crossed.size() && left > 0; ++k, --left) {
    const auto at = edge(crossed[k][0], crossed[k][1]);
    if (!at) continue;
    if (!is_convex(*at)) {
      crossed.push_back(crossed[k]);
      continue;
    }
    const Part& part = parts_[at->part];
    const Index c = part.corners[(at->slot + 2) % 3];
    const Index other = part.across[at->slot];
    const Index d =
        parts_[other].corners[(slot_of(other, part.corners[(at->slot + 1) % 3]) + 2) % 3];
    flip(*at);
    const bool is_across =
        c != a && c != b && d != a && d != b && side(a, b, c) * side(a, b, d) < 0;
    (is_across ? crossed : made).push_back(key(c, d));
  }
  segments_[key(a, b)] = 0.0;
  settle(std::move(made));
}

/// Where two segments cross, rounded to the grid.
Vec2 ConstrainedDelaunay::crossing(Key segment, Index a, Index b) const {
  const Vec2 along = grid_[b] - grid_[a], other = grid_[segment[1]] - grid_[segment[0]];
  const double share =
      planish::cross(grid_[segment[0]] - grid_[a], other) / planish::cross(along, other);
  const Vec2 exact = grid_[a] + std::clamp(share, 0.0, 1.0) * along;
  return {std::nearbyint(exact.x), std::nearbyint(exact.y)};
}

/// Connects a and b over a segment that lies between them.
void ConstrainedDelaunay::cross(Key segment, Index a, Index b, const Led& led) {
  const Index c = segment[0], d = segment[1];
  const double aside = segments_.at(segment);  // of the other one
  const Vec2 grid = crossing(segment, a, b);
  const bool is_inside = grid.x > 0.0 && grid.y > 0.0 && grid.x + grid.y < k_cells;
  const Vec2 place = (grid.x / k_cells) * right_ + (grid.y / k_cells) * up_;
  const double reach = reach_of({std::max(led.aside, aside), led.depth});
  std::vector<Index> known = {a, b, c, d};
  if (is_inside && reach > 0.0) {
    for (const Index corner : parts_[locate(grid)].corners)
      known.push_back(corner);
  }
  const auto apart = [&](Index node) { return norm(places_[node] - place); };
  const Index nearest = *std::min_element(known.begin(), known.end(),
                                          [&](Index p, Index q) { return apart(p) < apart(q); });
  const bool is_known = !is_inside || apart(nearest) <= reach;
  const Index node = is_known ? nearest : add(grid);
  const double moved = is_known ? apart(nearest) : 0.0;
  if (node != c && node != d && segments_.erase(segment) != 0)
    lead_over(node, c, d, {aside + moved, led.depth + 1});
  if (node != a && node != b) {
    lead_over(node, a, b, {led.aside + moved, led.depth + 1});
  } else {
    connect(a, b, {led.aside, led.depth + 1});
  }
}

void ConstrainedDelaunay::divide(Index a, Index b, double share) {
  const Vec2 exact = grid_[a] + share * (grid_[b] - grid_[a]);
  const Vec2 grid = {std::nearbyint(exact.x), std::nearbyint(exact.y)};
  if (!(grid.x > 0.0 && grid.y > 0.0 && grid.x + grid.y < k_cells)) return;
  const Led led{segments_.extract(key(a, b)).mapped()};
  const Index node = add(grid);
  if (node != a && node != b) divided_at_[key(a, b)] = node;
  connect(a, node, led);
  connect(node, b, led);
}

std::vector<Index> ConstrainedDelaunay::path(Index a, Index b) const {
  std::vector<Index> nodes = {a}, ahead = {b};
  while (!ahead.empty() && nodes.size() < 4 * grid_.size()) {
    const auto divided = divided_at_.find(key(nodes.back(), ahead.back()));
    if (!is_segment(nodes.back(), ahead.back()) && divided != divided_at_.end()) {
      ahead.push_back(divided->second);
    } else {
      if (nodes.back() != ahead.back()) nodes.push_back(ahead.back());
      ahead.pop_back();
    }
  }
  return nodes;
}

std::vector<Triangle> ConstrainedDelaunay::triangles() const {
  std::vector<Triangle> triangles;
  triangles.reserve(parts_.size());
  for (const Part& part : parts_)
    triangles.push_back(part.corners);
  return triangles;
}

}  // namespace planish
