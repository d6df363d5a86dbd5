#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include <planish/measure/fairness.h>

#include "mesh/search/box_tree.h"

namespace planish {

namespace {

// Surfaces take 11 to 18 steps a triangle.
constexpr std::size_t k_steps_a_triangle = 200;

using Corners = BoxTree::Corners;

/// The sign of the volume of a, b, c, d, and the volume; 0 where rounding might have made it.
double volume(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  // Rounding of the determinant is below 8 units of the sum of its terms' sizes (Shewchuk 1997).
  constexpr double rounding = 8.0 * 0x1p-53;
  const Vec3 u = a - d, v = b - d, w = c - d;
  const double vw = v.y * w.z, wv = v.z * w.y, wu = w.y * u.z, uw = w.z * u.y;
  const double uv = u.y * v.z, vu = u.z * v.y;
  const double value = u.x * (vw - wv) + v.x * (wu - uw) + w.x * (uv - vu);
  const double size = std::abs(u.x) * (std::abs(vw) + std::abs(wv)) +
                      std::abs(v.x) * (std::abs(wu) + std::abs(uw)) +
                      std::abs(w.x) * (std::abs(uv) + std::abs(vu));
  return std::abs(value) > rounding * size ? value : 0.0;
}

bool all_of_one_sign(double a, double b, double c) {
  return (a > 0.0 && b > 0.0 && c > 0.0) || (a < 0.0 && b < 0.0 && c < 0.0);
}

/// Where an edge of `through` crosses the inside of the triangle `t`.
std::optional<Vec3> crossing(const Corners& through, const Corners& t) {
  std::array<double, 3> side{};
  for (std::size_t k = 0; k < 3; ++k)
    side[k] = volume(t[0], t[1], t[2], through[k]);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t l = (k + 1) % 3;
    if (!(side[k] > 0.0 && side[l] < 0.0) && !(side[k] < 0.0 && side[l] > 0.0)) continue;
    const Vec3 p = through[k], q = through[l];
    if (!all_of_one_sign(volume(p, q, t[0], t[1]), volume(p, q, t[1], t[2]),
                         volume(p, q, t[2], t[0])))
      continue;
    return p + (side[k] / (side[k] - side[l])) * (q - p);
  }
  return std::nullopt;
}

bool overlap(const Box& a, const Box& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y &&
         a.low.z <= b.high.z && b.low.z <= a.high.z;
}

bool share_a_vertex(const Triangle& a, const Triangle& b) {
  for (const Index v : a) {
    if (v == b[0] || v == b[1] || v == b[2]) return true;
  }
  return false;
}

/// One search, of a mesh of about the size 1.
class Search {
 public:
  explicit Search(const TriMesh& mesh)
      : mesh_(mesh), tree_(mesh), left_(k_steps_a_triangle * mesh.triangles.size()) {
    boxes_.reserve(mesh.triangles.size());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
      boxes_.push_back(box_of(tree_.corners(i)));
  }

  SelfIntersections run() {
    waiting_.emplace_back(0, 0);
    while (!waiting_.empty() && found_.complete) {
      const auto [a, b] = waiting_.back();
      waiting_.pop_back();
      take_apart(a, b);
    }
    return found_;
  }

 private:
  /// Looks at all pairs of a triangle of node a and one of node b.
  void take_apart(std::size_t a, std::size_t b) {
    const auto nodes = tree_.nodes();
    const BoxTree::Node &first = nodes[a], &second = nodes[b];
    if (!take_step() || (a != b && !overlap(first.box, second.box))) return;
    if (first.is_leaf() && second.is_leaf()) {
      look_at_leaves(first, second);
    } else if (a == b) {
      waiting_.emplace_back(a + 1, a + 1);
      waiting_.emplace_back(first.second, first.second);
      waiting_.emplace_back(a + 1, first.second);
    } else if (second.is_leaf() ||
               (!first.is_leaf() && first.end - first.begin >= second.end - second.begin)) {
      waiting_.emplace_back(a + 1, b);
      waiting_.emplace_back(first.second, b);
    } else {
      waiting_.emplace_back(a, b + 1);
      waiting_.emplace_back(a, second.second);
    }
  }

  void look_at_leaves(const BoxTree::Node& first, const BoxTree::Node& second) {
    const bool same = first.begin == second.begin;
    for (std::size_t i = first.begin; i < first.end; ++i) {
      for (std::size_t j = same ? i + 1 : second.begin; j < second.end; ++j) {
        if (!overlap(boxes_[i], boxes_[j])) continue;
        if (!take_step()) return;
        look_at(i, j);
      }
    }
  }

  void look_at(std::size_t i, std::size_t j) {
    Index s = tree_.triangle(i), t = tree_.triangle(j);
    if (share_a_vertex(mesh_.triangles[s], mesh_.triangles[t])) return;
    // In the order of their numbers, so that the place does not depend on the tree.
    if (s > t) std::swap(i, j), std::swap(s, t);
    std::optional<Vec3> at = crossing(tree_.corners(i), tree_.corners(j));
    if (!at) at = crossing(tree_.corners(j), tree_.corners(i));
    if (!at) return;
    ++found_.pairs;
    const std::array<Index, 2> pair = {s, t};
    if (!found_.first || pair < found_.first->triangles) found_.first = {pair, *at};
  }

  bool take_step() {
    if (left_ == 0) found_.complete = false;
    if (left_ > 0) --left_;
    return found_.complete;
  }

  const TriMesh& mesh_;
  BoxTree tree_;
  std::vector<Box> boxes_;  // of triangles, in the order of the tree
  std::vector<std::pair<std::size_t, std::size_t>> waiting_;
  std::size_t left_;
  SelfIntersections found_;
};

}  // namespace

SelfIntersections find_self_intersections(const TriMesh& mesh) {
  if (mesh.triangles.empty()) return {};
  const double scale = unit_scale(mesh);
  TriMesh scaled = mesh;
  for (Vec3& p : scaled.positions)
    p = scale * p;
  SelfIntersections found = Search(scaled).run();
  if (found.first) {
    const Vec3 at = found.first->at;
    found.first->at = {at.x / scale, at.y / scale, at.z / scale};
  }
  return found;
}

}  // namespace planish
