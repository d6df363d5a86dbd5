#include "mesh/coarsen/coarsener.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "mesh/breadth_first.h"
#include "mesh/coarsen/coarse_sizes.h"

namespace planish {

namespace {

constexpr float k_far = std::numeric_limits<float>::infinity();
// How much a square of the distance from the fine surface counts against one of an edge length.
constexpr double k_distance_cost = 10.0;
// How much a poor shape of the triangles counts in the choice of the end to collapse into.
constexpr double k_shape_cost = 2.0;
// Gap at a border vertex to the crowding inside at the same edge lengths.
constexpr double k_gap_cost = 0.2;
// Where vertices are so far apart for their size, no more are taken at a kept border.
constexpr float k_sparse = 1.0F;
// Keys of vertices four times as dense as what is wanted, and denser ones.
constexpr double k_early = 0.0625;
constexpr double k_least_alignment = 0.5;    // cosine of 60 degrees
constexpr double k_largest_cosine = 0.9848;  // of 10 degrees
constexpr double k_flip_height = 0.2;        // to the shorter diagonal
constexpr std::size_t k_least_loop = 6;

/// The key less its last digits: vertices of one level go in the order of their numbers, near ones
/// together, which is several times as fast and costs no quality. Coarser levels do at first. Few
/// digits are left, so a float holds them: keys of a surface of size 1 are within its range.
float level_of(double key) {
  const int digits = key < k_early ? 1 : 4;  // after the first, binary
  const int dropped = std::numeric_limits<double>::digits - 1 - digits;
  return static_cast<float>(
      std::bit_cast<double>(std::bit_cast<std::uint64_t>(key) >> dropped << dropped));
}

}  // namespace

Coarsener::Coarsener(const TriMesh& mesh, const std::vector<Index>& order, std::size_t vertices,
                     CoarseBorder border, std::vector<unsigned char> keep)
    : half_edges_(renumbered(mesh, order)),
      surface_(fine_surface({mesh, order}, half_edges_)),
      fixed_(std::move(keep)),
      limit_(border == CoarseBorder::kept ? k_sparse : k_far),
      left_(order.size()),
      wanted_(vertices),
      loop_of_(left_, HalfEdges::none),
      queue_(left_),
      is_touched_(left_, 0) {
  count_loops();
  for (Index v = 0; v < left_; ++v) {
    if (border == CoarseBorder::kept && half_edges_.is_border(v)) fixed_[v] = 1;
  }
  sizes_ = border == CoarseBorder::kept ? graded_sizes(surface_, half_edges_, fixed_, vertices)
                                        : even_sizes(surface_, vertices);
  surface_.areas = std::vector<double>();  // sizes alone need them
  quadrics_ = fine_quadrics(surface_.positions, half_edges_);
  queue_.reserve(left_);
  for (Index v = 0; v < left_; ++v) {
    if (fixed_[v] == 0) queue_.set(v, level_of(crowding(v)));
  }
}

void Coarsener::count_loops() {
  for (Index v = 0; v < loop_of_.size(); ++v) {
    if (!half_edges_.is_border(v) || loop_of_[v] != HalfEdges::none) continue;
    std::size_t size = 0;
    for (Index w = v; loop_of_[w] == HalfEdges::none; w = half_edges_.next_on_border(w)) {
      loop_of_[w] = static_cast<Index>(loop_sizes_.size());
      ++size;
    }
    loop_sizes_.push_back(size);
  }
}

TriangleGrade Coarsener::grade_around(Index v) const {
  TriangleGrade worst;
  half_edges_.for_each_corner(
      v, [&](Index h) { worst.add(grade(v, half_edges_.to(h), half_edges_.apex(h))); });
  return worst;
}

/// Of the triangles that change when `gone` is drawn into `stays`.
TriangleGrade Coarsener::grade_after(Index gone, Index stays) const {
  TriangleGrade worst;
  half_edges_.for_each_corner(gone, [&](Index h) {
    const Index a = half_edges_.to(h), b = half_edges_.apex(h);
    if (a != stays && b != stays) worst.add(grade(stays, a, b));
  });
  return worst;
}

/// The square of the distance to the neighbours, by a mean that the nearest rule; a border edge
/// opposite counts as one of them, with its height as that of an equilateral triangle.
double Coarsener::crowding(Index v) const {
  if (half_edges_.is_border(v)) return border_gap(v);
  const Vec3 p = surface_.positions[v];
  double sum = 0.0;
  half_edges_.for_each_corner(v, [&](Index h) {
    const Index w = half_edges_.to(h);
    const Vec3 edge = surface_.positions[w] - p;
    const double size = 0.5 * (sizes_[v] + sizes_[w]);
    double closeness = size * size / dot(edge, edge);
    if (half_edges_.twin(HalfEdges::next(h)) == HalfEdges::none) {
      const Vec3 side = surface_.positions[half_edges_.apex(h)] - surface_.positions[w];
      const Vec3 n = cross(edge, side);
      closeness = std::max(closeness, 0.75 * size * size * dot(side, side) / dot(n, n));
    }
    closeness *= closeness;
    sum += closeness * closeness;
  });
  return 1.0 / std::sqrt(std::sqrt(sum));
}

double Coarsener::border_gap(Index v) const {
  const Vec3 p = surface_.positions[v];
  const Index before = half_edges_.from(half_edges_.border_edge_to(v));
  const double gap = norm(surface_.positions[half_edges_.next_on_border(v)] - p) +
                     norm(surface_.positions[before] - p);
  return k_gap_cost * gap * gap / (sizes_[v] * sizes_[v]);
}

double Coarsener::distance_cost(Index gone, Index stays) const {
  const double size = sizes_[gone];
  return k_distance_cost * quadrics_[gone].mean(surface_.positions[stays]) / (size * size);
}

/// Calls f(edge, end that stays) with each edge that v may be drawn along.
template <class F>
void Coarsener::for_each_way_out(Index v, F f) const {
  if (half_edges_.is_border(v)) {
    if (loop_sizes_[loop_of_[v]] <= k_least_loop) return;
    const Index before = half_edges_.border_edge_to(v);
    f(half_edges_.first(v), half_edges_.next_on_border(v));
    f(before, half_edges_.from(before));
  } else {
    half_edges_.for_each_corner(v, [&](Index h) { f(h, half_edges_.to(h)); });
  }
}

/// What taking v out costs at least.
double Coarsener::least_cost(Index v) const {
  double least = std::numeric_limits<double>::infinity();
  for_each_way_out(v, [&](Index, Index w) { least = std::min(least, distance_cost(v, w)); });
  return least + crowding(v);
}

Coarsener::Collapse Coarsener::best_collapse(Index v) {
  const TriangleGrade before = grade_around(v);
  const double crowding_cost = crowding(v);
  ways_.clear();
  for_each_way_out(v, [&](Index edge, Index stays) {
    const TriangleGrade after = grade_after(v, stays);
    if (!after.has_lengths) return;
    if (after.alignment < std::min(k_least_alignment, before.alignment)) return;
    if (after.cosine > std::max(k_largest_cosine, before.cosine)) return;
    const double cost = crowding_cost + distance_cost(v, stays);
    ways_.push_back({edge, stays, cost, cost + k_shape_cost * crowding_cost * after.cosine});
  });
  while (!ways_.empty()) {
    const auto best = std::min_element(ways_.begin(), ways_.end());
    if (half_edges_.may_collapse(best->edge, v)) return *best;
    ways_.erase(best);
  }
  return {};
}

void Coarsener::touch(Index v) {
  if (is_touched_[v] != 0) return;
  is_touched_[v] = 1;
  touched_.push_back(v);
}

void Coarsener::collapse(const Collapse& way, Index gone) {
  if (half_edges_.is_border(gone)) --loop_sizes_[loop_of_[gone]];
  half_edges_.collapse(way.edge, gone);
  quadrics_[way.stays] += quadrics_[gone];
  --left_;
  touch(way.stays);
  half_edges_.for_each_neighbor(way.stays, [&](Index w) { touch(w); });
  flip_around(way.stays);
  update_touched();
}

/// Whether a flip makes the smallest angle larger and nearly keeps the surface. As the list of all
/// angles, smallest first, grows with every such flip, they come to an end.
bool Coarsener::improves(Index h) const {
  if (half_edges_.twin(h) == HalfEdges::none) return false;
  const Index a = half_edges_.from(h), b = half_edges_.to(h);
  const Index c = half_edges_.apex(h), d = half_edges_.apex(half_edges_.twin(h));
  const auto& p = surface_.positions;
  // The sum of the angles at c and d is beyond 180 degrees where that of the cotangents is
  // negative.
  const Vec3 ca = p[a] - p[c], cb = p[b] - p[c], da = p[a] - p[d], db = p[b] - p[d];
  if (!(dot(ca, cb) * norm(cross(da, db)) + dot(da, db) * norm(cross(ca, cb)) < 0.0)) return false;
  const Vec3 ab = p[b] - p[a], cd = p[d] - p[c], across = cross(ab, cd);
  const double height = dot(ca, across), shorter = std::min(dot(ab, ab), dot(cd, cd));
  if (height * height > k_flip_height * k_flip_height * shorter * dot(across, across)) return false;
  TriangleGrade before = grade(a, b, c), after = grade(d, b, c);
  before.add(grade(b, a, d));
  after.add(grade(c, a, d));
  return after.has_lengths && after.cosine < before.cosine - 1e-12 &&
         after.alignment >= std::min(k_least_alignment, before.alignment) &&
         half_edges_.may_flip(h);
}

void Coarsener::flip_around(Index v) {
  half_edges_.for_each_corner(v, [&](Index h) {
    stack_.push_back(h);
    stack_.push_back(HalfEdges::next(h));
  });
  while (!stack_.empty()) {
    const Index h = stack_.back();
    stack_.pop_back();
    if (!improves(h)) continue;
    const Index g = half_edges_.twin(h);
    half_edges_.flip(h);
    for (const Index side : {h, HalfEdges::next(h), g, HalfEdges::next(g)}) {
      stack_.push_back(side);
      touch(half_edges_.from(side));
    }
  }
}

void Coarsener::update_touched() {
  for (const Index v : touched_) {
    is_touched_[v] = 0;
    if (fixed_[v] == 0) queue_.set(v, level_of(crowding(v)));
  }
  touched_.clear();
}

/// Keys are bounds from below, of growing cost: how crowded a vertex is, what taking it out costs
/// at least, and what it costs.
void Coarsener::run(const ThreadPool* pool) {
  constexpr std::size_t often = 1024;
  for (std::size_t step = 0; left_ > wanted_ && !queue_.empty() && queue_.top_key() < limit_;
       ++step) {
    if (pool != nullptr && step % often == 0) pool->stop_if_cancelled();
    const Index v = queue_.top();
    const float key = queue_.top_key(), least = level_of(least_cost(v));
    if (least > key) {
      queue_.set(v, least);
      continue;
    }
    const Collapse way = best_collapse(v);
    // Those that cannot go are asked again when something changes around them.
    if (way.edge == HalfEdges::none) {
      queue_.remove(v);
    } else if (level_of(way.cost) > key) {
      queue_.set(v, level_of(way.cost));
    } else {
      queue_.remove(v);
      collapse(way, v);
    }
  }
}

std::vector<Triangle> Coarsener::triangles() const {
  std::vector<Triangle> triangles;
  for (Index h = 0; h < half_edges_.size(); h += 3) {
    if (!half_edges_.is_alive(h)) continue;
    triangles.push_back({half_edges_.from(h), half_edges_.from(h + 1), half_edges_.from(h + 2)});
  }
  return triangles;
}

}  // namespace planish
