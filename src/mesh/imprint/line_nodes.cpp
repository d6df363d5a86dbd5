#include "mesh/imprint/line_nodes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "mesh/imprint/constrained_delaunay.h"

namespace planish {

namespace {

/// Barycentric coordinates in cells of the grid; their sum is all cells of a side.
std::array<double, 3> cells_of(const std::array<double, 3>& shares) {
  std::array<double, 3> cells = {0.0, std::nearbyint(shares[1] * k_cells),
                                 std::nearbyint(shares[2] * k_cells)};
  if (shares[0] == 0.0) cells[1] = k_cells - cells[2];
  cells[2] = std::min(cells[2], k_cells - cells[1]);
  cells[0] = k_cells - cells[1] - cells[2];
  return cells;
}

}  // namespace

LineNodes::LineNodes(const Patch& patch, const ImprintOptions& options)
    : vertex_count_(patch.vertex_count()),
      scale_(patch.unit_scale()),
      mesh_(planish::scaled(patch.mesh(), scale_)),
      half_edges_(mesh_),
      share_(options.snap),
      most_(options.farthest_snap * bounding_box_diagonal(mesh_)) {}

LineNodes::Node LineNodes::node(Index number) const {
  return number < vertex_count_ ? Node{On::vertex, number} : nodes_[number - vertex_count_];
}

SurfacePoint LineNodes::place(Index number) const {
  return place_of(node(number));
}

SurfacePoint LineNodes::place_of(const Node& at) const {
  if (at.on == On::face) {
    const double second = at.grid.x / k_cells, third = at.grid.y / k_cells;
    return {mesh_.triangles[at.element],
            {(k_cells - at.grid.x - at.grid.y) / k_cells, second, third}};
  }
  const Index half = at.on == On::edge ? at.element : half_edges_.first(at.element);
  const double along = at.on == On::edge ? at.grid.x : 0.0;
  SurfacePoint point{mesh_.triangles[half / 3], {0.0, 0.0, 0.0}};
  point.shares[half % 3] = (k_cells - along) / k_cells;
  point.shares[HalfEdges::next(half) % 3] = along / k_cells;
  return point;
}

Vec3 LineNodes::position(Index number) const {
  if (number < vertex_count_) return mesh_.positions[number];
  return position_of(place(number), mesh_.positions);
}

Index LineNodes::edge_of(Index half) const {
  return std::min(half, half_edges_.twin(half));
}

double LineNodes::snap_at(Index vertex) const {
  double shortest = most_ / std::max(share_, 1e-300);
  half_edges_.for_each_neighbor(vertex, [&](Index w) {
    shortest = std::min(shortest, norm(mesh_.positions[w] - mesh_.positions[vertex]));
  });
  return std::min(share_ * shortest, most_);
}

void LineNodes::note(double moved) {
  constexpr double rounding = 1e-12;
  if (moved <= rounding) return;
  ++snapped_;
  farthest_ = std::max(farthest_, moved);
}

Index LineNodes::new_node(const Node& node) {
  nodes_.push_back(node);
  return static_cast<Index>(count() - 1);
}

/// The half-edge from the first of its corners.
std::optional<Index> LineNodes::half_of(const SurfacePoint& point) const {
  const Index a = point.corners[0], b = point.corners[1], c = point.corners[2];
  if (a >= vertex_count_ || !half_edges_.is_used(a)) return std::nullopt;
  std::optional<Index> found;
  half_edges_.for_each_corner(a, [&](Index h) {
    if (half_edges_.to(h) == b && half_edges_.apex(h) == c) found = h;
  });
  return found;
}

std::optional<Index> LineNodes::add(const SurfacePoint& point) {
  const auto half = half_of(point);
  const double sum = point.shares[0] + point.shares[1] + point.shares[2];
  const bool are_shares = std::all_of(point.shares.begin(), point.shares.end(),
                                      [](double share) { return share >= 0.0; });
  if (!half || !are_shares || !(std::abs(sum - 1.0) <= 1e-6)) return std::nullopt;
  std::array<double, 3> shares = point.shares;  // in the order of the triangle
  std::rotate(shares.begin(), shares.begin() + static_cast<std::ptrdiff_t>((3 - *half % 3) % 3),
              shares.end());
  const Index first = *half - *half % 3;
  const std::array<double, 3> cells = cells_of(shares);
  const Vec3 place = position_of(point, mesh_.positions);
  for (Index k = 0; k < 3; ++k) {
    const Index v = half_edges_.from(first + k);
    const double apart = norm(place - mesh_.positions[v]);
    if (cells[k] == 0.0) continue;  // the triangle beyond an edge that it is on may not have v
    if (cells[k] == k_cells || apart <= snap_at(v)) return note(apart), v;
  }
  // What is on an edge already stays on it: beyond it may be a triangle without the others.
  const bool is_on_edge = std::count(cells.begin(), cells.end(), 0.0) > 0;
  for (Index k = 0; k < 3; ++k) {
    const Index h = first + k;
    if (is_on_edge) {
      if (cells[(k + 2) % 3] == 0.0) return add_on_edge(h, cells[(k + 1) % 3]);
      continue;
    }
    const Vec3 from = mesh_.positions[half_edges_.from(h)];
    const Vec3 along = mesh_.positions[half_edges_.to(h)] - from;
    const double share = std::clamp(dot(place - from, along) / dot(along, along), 0.0, 1.0);
    const double apart = norm(place - (from + share * along));
    if (!(apart <= std::min(snap_at(half_edges_.from(h)), snap_at(half_edges_.to(h))))) continue;
    return add_on_edge(h, std::nearbyint(share * k_cells), apart);
  }
  return add_in_face(first / 3, {cells[1], cells[2]});
}

Index LineNodes::add_in_face(Index triangle, Vec2 grid) {
  const Node added{On::face, triangle, grid};
  const Vec3 place = position_of(place_of(added), mesh_.positions);
  double most = most_;
  for (const Index corner : mesh_.triangles[triangle])
    most = std::min(most, snap_at(corner));
  for (const Index other : in_faces_[triangle]) {
    const double apart = norm(position(other) - place);
    if (apart > most) continue;
    note(apart);
    return other;
  }
  return new_in_face(triangle, grid);
}

Index LineNodes::new_in_face(Index triangle, Vec2 grid) {
  in_faces_[triangle].push_back(new_node({On::face, triangle, grid}));
  return in_faces_[triangle].back();
}

Index LineNodes::add_on_edge(Index half, double cells, double apart) {
  const Index edge = edge_of(half);
  const double at = edge == half ? cells : k_cells - cells;
  const Index from = half_edges_.from(edge), to = half_edges_.to(edge);
  if (at <= 0.0) return from;
  if (at >= k_cells) return to;
  const double length = norm(mesh_.positions[to] - mesh_.positions[from]);
  const double reach = std::min(share_ * length, most_);
  auto& on = on_edges_[edge];
  const auto above = on.lower_bound(at);
  auto nearest = above;
  if (above != on.begin() &&
      (above == on.end() || at - std::prev(above)->first < above->first - at))
    nearest = std::prev(above);
  if (nearest != on.end()) {
    const double along = std::abs(nearest->first - at) / k_cells * length;
    const double moved = std::sqrt(apart * apart + along * along);
    if (moved <= reach) return note(moved), nearest->second;
  }
  note(apart);
  return on[at] = new_node({On::edge, edge, {at, 0.0}});
}

std::vector<Index> LineNodes::on_edge(Index half) const {
  const Index edge = edge_of(half);
  std::vector<Index> nodes;
  if (const auto found = on_edges_.find(edge); found != on_edges_.end()) {
    for (const auto& [cells, node] : found->second)
      nodes.push_back(node);
  }
  if (edge != half) std::reverse(nodes.begin(), nodes.end());
  return nodes;
}

double LineNodes::cells_along(Index half, Index number) const {
  const Node at = node(number);
  if (at.on == On::vertex) return at.element == half_edges_.from(half) ? 0.0 : k_cells;
  return at.element == half ? at.grid.x : k_cells - at.grid.x;
}

Index LineNodes::add_between(Index half, Index from, Index to, double share) {
  const double begin = cells_along(half, from), end = cells_along(half, to);
  return add_on_edge(half, std::nearbyint(begin + share * (end - begin)));
}

std::vector<Index> LineNodes::along(Index half, Index from, Index to) const {
  double begin = cells_along(half, from), end = cells_along(half, to);
  const bool is_back = begin > end;
  if (is_back) std::swap(begin, end);
  std::vector<Index> nodes = {is_back ? to : from};
  for (const Index node : on_edge(half)) {
    const double at = cells_along(half, node);
    if (at > begin && at < end) nodes.push_back(node);
  }
  nodes.push_back(is_back ? from : to);
  if (is_back) std::reverse(nodes.begin(), nodes.end());
  return nodes;
}

template <class Visit>
void LineNodes::for_each_face(Index number, Visit visit) const {
  const Node at = node(number);
  if (at.on == On::face) return visit(at.element);
  if (at.on == On::vertex)
    return half_edges_.for_each_corner(at.element, [&](Index h) { visit(h / 3); });
  visit(at.element / 3);
  if (const Index twin = half_edges_.twin(at.element); twin != HalfEdges::none) visit(twin / 3);
}

std::optional<LineNodes::Way> LineNodes::way(Index from, Index to) const {
  const auto is_on = [&](Index half, Index number) {
    const Node at = node(number);
    if (at.on == On::edge) return at.element == edge_of(half);
    return at.on == On::vertex &&
           (at.element == half_edges_.from(half) || at.element == half_edges_.to(half));
  };
  const auto is_in = [&](Index triangle, Index number) {
    bool found = false;
    for_each_face(number, [&](Index other) { found = found || other == triangle; });
    return found;
  };
  std::optional<Way> way;
  // The one with fewer triangles around it is asked first: thousands may meet at a vertex.
  const bool is_vertex = node(from).on == On::vertex;
  const Index one = is_vertex ? to : from, other = is_vertex ? from : to;
  for_each_face(one, [&](Index triangle) {
    const bool is_better = way && way->on == On::edge;
    if (is_better || !is_in(triangle, other)) return;
    for (Index half = 3 * triangle; half < 3 * triangle + 3; ++half) {
      if (is_on(half, from) && is_on(half, to)) way = Way{On::edge, half};
    }
    if (!way || (way->on == On::face && triangle < way->element)) way = Way{On::face, triangle};
  });
  return way;
}

Vec2 LineNodes::grid_in(Index triangle, Index number) const {
  const Node at = node(number);
  if (at.on == On::face) return at.grid;
  std::array<double, 3> cells{};
  const auto corner = [&](Index vertex) {
    const Triangle& t = mesh_.triangles[triangle];
    return static_cast<std::size_t>(std::find(t.begin(), t.end(), vertex) - t.begin());
  };
  if (at.on == On::vertex) {
    cells[corner(at.element)] = k_cells;
  } else {
    cells[corner(half_edges_.from(at.element))] = k_cells - at.grid.x;
    cells[corner(half_edges_.to(at.element))] = at.grid.x;
  }
  return {cells[1], cells[2]};
}

}  // namespace planish
