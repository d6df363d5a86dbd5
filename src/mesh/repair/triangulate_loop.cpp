#include "mesh/repair/triangulate_loop.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace planish {

namespace {

// 1 less the cosine of the angle between normals: 150 degrees and more are a fold.
constexpr double k_fold = 1.866;
// Bends are compared in steps, so that rounding decides nothing between flat triangles.
constexpr double k_steps = 32.0;
// Twice the area over the square of the longest side.
constexpr double k_no_area = 1e-9;

/// How well a part of the loop can be closed.
struct Closing {
  double bend = std::numeric_limits<double>::infinity();  // in steps
  double length = 0.0;                                    // of diagonals
  std::size_t middle = 0;                                 // corner of the triangle at its diagonal
  Vec3 normal;                                            // of that

  bool is_better(const Closing& other) const {
    return bend != other.bend ? bend < other.bend : length < other.length;
  }
};

class LoopTriangles {
 public:
  LoopTriangles(std::span<const Vec3> corners, std::span<const Vec3> beside)
      : corners_(corners), beside_(beside), closings_(corners.size() * corners.size()) {
    for (std::size_t i = 0; i + 1 < corners.size(); ++i)
      at(i, i + 1) = {0.0, 0.0, i, beside[i]};
  }

  /// Finds the best way to close corners i to j from those of shorter parts.
  void close(std::size_t i, std::size_t j) {
    const bool whole = j - i + 1 == corners_.size();
    Closing best;
    for (std::size_t m = i + 1; m < j; ++m) {
      const Closing &one = at(i, m), &other = at(m, j);
      Closing closing{std::max(one.bend, other.bend), one.length + other.length, m, {}};
      if (!(closing.bend < std::numeric_limits<double>::infinity())) continue;
      const auto normal = normal_of(i, m, j);
      if (!normal) continue;
      closing.normal = *normal;
      closing.bend = std::max({closing.bend, bend(*normal, one.normal), bend(*normal, other.normal),
                               whole ? bend(*normal, beside_.back()) : 0.0});
      if (!whole) closing.length += norm(corners_[j] - corners_[i]);
      if (closing.is_better(best)) best = closing;
    }
    at(i, j) = best;
  }

  bool is_closed() const { return closings_[corners_.size() - 1].bend < k_steps * k_fold; }

  std::vector<Triangle> triangles() {
    std::vector<Triangle> result;
    std::vector<std::pair<std::size_t, std::size_t>> parts{{0, corners_.size() - 1}};
    while (!parts.empty()) {
      const auto [i, j] = parts.back();
      parts.pop_back();
      if (j == i + 1) continue;
      const std::size_t m = at(i, j).middle;
      result.push_back({static_cast<Index>(i), static_cast<Index>(m), static_cast<Index>(j)});
      parts.emplace_back(m, j);
      parts.emplace_back(i, m);
    }
    return result;
  }

 private:
  Closing& at(std::size_t i, std::size_t j) { return closings_[i * corners_.size() + j]; }

  std::optional<Vec3> normal_of(std::size_t i, std::size_t m, std::size_t j) const {
    const Vec3 u = corners_[m] - corners_[i], v = corners_[j] - corners_[i], w = v - u;
    const Vec3 normal = cross(u, v);
    const double length = norm(normal), longest = std::max({dot(u, u), dot(v, v), dot(w, w)});
    if (!(length > k_no_area * longest)) return std::nullopt;
    return 1.0 / length * normal;
  }

  static double bend(Vec3 a, Vec3 b) {
    return b == Vec3{} ? 0.0 : std::floor(k_steps * (1.0 - dot(a, b)) + 0.5);
  }

  std::span<const Vec3> corners_, beside_;
  std::vector<Closing> closings_;
};

}  // namespace

std::optional<std::vector<Triangle>> triangulate_loop(
    std::span<const Vec3> corners, std::span<const Vec3> beside,
    const std::function<bool(std::size_t, std::size_t)>& may_join) {
  const std::size_t count = corners.size();
  LoopTriangles triangles(corners, beside);
  for (std::size_t length = 2; length < count; ++length) {
    for (std::size_t i = 0; i + length < count; ++i) {
      if (length + 1 == count || may_join(i, i + length)) triangles.close(i, i + length);
    }
  }
  if (!triangles.is_closed()) return std::nullopt;
  return triangles.triangles();
}

}  // namespace planish
