#include "measure/form/form_change.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <queue>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "core/neumaier_sum.h"
#include "measure/area.h"
#include "measure/bends.h"
#include "measure/form/windows.h"
#include "measure/moments.h"
#include "measure/normals.h"
#include "measure/smoothed.h"

namespace planish {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Radii of windows, of the size. What is seen as an edge; as rough; as a feature; as a hill; as a
// dent, and its middle. A window has a radius of some mean edges at least: a coarse mesh shows no
// more.
constexpr double k_edge_radius = 0.02, k_bend_radius = 0.025, k_feature_radius = 0.06,
                 k_relief_radius = 0.12, k_dent_radius = 0.1, k_middle_radius = 0.03;
constexpr double k_least_edges = 1.5, k_least_feature_edges = 2.0;
constexpr std::size_t k_least_vertices = 4;

// Added bending is compared with the design's bending in the window, plus the bending that two
// thirds of its area stay below, plus a constant (over the square of the size). The second keeps
// one sharp bead from masking waves beside it; bending below the constant cannot be seen.
constexpr double k_calm_part = 2.0 / 3.0, k_least_bending = 8.0;

// Added bending counts by this factor where the window is nearer to the border than this many
// radii: people notice it less there.
constexpr double k_border_radii = 1.15, k_border_part = 0.6;

// Of how unevenly the normals of the design lie. Where a feature turns as a whole or becomes a
// little lower, its normals turn as unevenly as that.
constexpr double k_own_part = 0.3;

// Mean edges, of each surface its own: noise is nearly all in shorter waves.
constexpr double k_noise_wave = 4.0;

constexpr double k_least_relief = 0.05;  // rms height over the radius, from which it stands out
constexpr double k_least_edge = 0.15;    // rms turn across an edge, radians
// Of all edges, and of the area: less is not missed, and noise has as much.
constexpr double k_least_edge_part = 0.3, k_least_edge_area = 0.01;

/// A design and its result; size_of() the design is 1.
struct Compared {
  const Connectivity& connectivity;
  std::vector<Vec3> before = {}, after = {};
  std::vector<Vec3> normals_before = {}, normals_after = {};  // of length 1
  std::vector<double> areas = {}, offsets = {};               // of the design; along its normals
  // Half of that of each edge at its ends.
  std::vector<double> bending_before = {}, bending_after = {};
  double mean_edge = 0.0;

  double radius(double usual, double least_edges = k_least_edges) const {
    return std::max(usual, least_edges * mean_edge);
  }
};

Vec3 unit(Vec3 a) {
  const double length = norm(a);
  return length > 0.0 ? (1.0 / length) * a : Vec3{};
}

std::vector<Vec3> unit_normals(const Patch& design, std::span<const Vec3> positions) {
  std::vector<Vec3> normals = vertex_normals(design.triangles(), positions, 1.0);
  for (Vec3& normal : normals)
    normal = unit(normal);
  return normals;
}

/// The diagonal of a rectangle that spreads as widely, times unit_scale(): it is the same however
/// the surface is turned.
double size_of(const Patch& design) {
  const SurfaceMoments moments =
      moments_of(design.triangles(), design.positions(), design.unit_scale());
  return moments.area > 0.0 ? std::sqrt(12.0 * moments.covariance.trace() / moments.area) : 0.0;
}

/// @pre size > 0
Compared compared(const Patch& design, std::span<const Vec3> after, double size) {
  const std::size_t n = design.vertex_count();
  Compared pair{.connectivity = design.connectivity()};
  const double scale = design.unit_scale();
  const Vec3 origin = n > 0 ? scale * design.positions().front() : Vec3{};
  const auto placed = [&](std::span<const Vec3> positions) {
    std::vector<Vec3> places;
    places.reserve(n);
    for (const Vec3 p : positions)
      places.push_back((1.0 / size) * (scale * p - origin));
    return places;
  };
  pair.before = placed(design.positions());
  pair.after = placed(after);
  pair.normals_before = unit_normals(design, pair.before);
  pair.normals_after = unit_normals(design, pair.after);
  pair.areas.assign(n, 0.0);
  NeumaierSum length;
  for (const Triangle& t : design.triangles()) {
    const double third = norm(triangle_normal(t, pair.before, 1.0)) / 6.0;
    for (const Index v : t)
      pair.areas[v] += third;
  }
  pair.bending_before.assign(n, 0.0);
  pair.bending_after.assign(n, 0.0);
  double edges = 0.0;
  for_each_hinge(pair.connectivity, [&](const Hinge& h) {
    const auto bend = [&](const std::vector<Vec3>& p) {
      return bend_at(p[h.from], p[h.to], p[h.left], p[h.right]);
    };
    const Bend first = bend(pair.before);
    const double had = first.bending(), has = bend(pair.after).bending();
    for (const Index v : {h.from, h.to}) {
      pair.bending_before[v] += 0.5 * had;
      pair.bending_after[v] += 0.5 * has;
    }
    length.add(first.length);
    edges += 1.0;
  });
  for (std::size_t v = 0; v < n; ++v)
    pair.offsets.push_back(dot(pair.after[v] - pair.before[v], pair.normals_before[v]));
  if (edges > 0.0) pair.mean_edge = length.value() / edges;
  return pair;
}

/// How far each vertex of the design is from the border, along edges; infinity beyond `most`.
std::vector<double> border_distances(const Compared& pair, double most) {
  using Entry = std::pair<double, Index>;
  std::vector<double> distances(pair.before.size(), std::numeric_limits<double>::infinity());
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto reach = [&](Index v, double distance) {
    if (!(distance < distances[v]) || distance > most) return;
    distances[v] = distance;
    queue.emplace(distance, v);
  };
  for (Index v = 0; v < pair.before.size(); ++v)
    if (pair.connectivity.is_border(v)) reach(v, 0.0);
  while (!queue.empty()) {
    const auto [distance, v] = queue.top();
    queue.pop();
    if (distance > distances[v]) continue;
    for (const Index w : pair.connectivity.ring(v))
      reach(w, distance + norm(pair.before[w] - pair.before[v]));
  }
  return distances;
}

/// Figures of windows, each with its part of the area.
class Figures {
 public:
  void add(double value, double share, Index middle) {
    if (value > largest_) {
      largest_ = value;
      at_ = middle;
    }
    values_.emplace_back(value, values_.size());
    shares_.push_back(share);
  }
  double area() const {
    NeumaierSum area;
    for (const double share : shares_)
      area.add(share);
    return area.value();
  }
  /// What so large a part of the area has at most; 0 without windows.
  double at_most_on(double part) const {
    auto order = values_;
    std::sort(order.begin(), order.end());
    const double needed = part * area();
    NeumaierSum so_far;
    for (const auto& [value, i] : order) {
      so_far.add(shares_[i]);
      if (so_far.value() >= needed) return value;
    }
    return 0.0;
  }
  double largest() const { return largest_; }
  Index place_of_largest() const { return at_; }

 private:
  std::vector<std::pair<double, std::size_t>> values_;
  std::vector<double> shares_;
  double largest_ = 0.0;
  Index at_ = 0;
};

/// The bending of a window, and its part of the area.
struct WindowBending {
  double before = 0.0, after = 0.0, area = 0.0;
  double share = 0.0;
  Index middle = 0;

  /// Root of the bending that came over that which the design has, and `calm` over the area.
  double more(double calm) const {
    const double beside = before + area * (calm + k_least_bending);
    return after > before && beside > 0.0 ? std::sqrt((after - before) / beside) : 0.0;
  }
};

WindowBending bending_of(const Compared& pair, const Window& window) {
  WindowBending bending{.share = window.share, .middle = window.vertices.front()};
  for (std::size_t i = 0; i < window.vertices.size(); ++i) {
    const Index v = window.vertices[i];
    bending.before += window.weights[i] * pair.bending_before[v];
    bending.after += window.weights[i] * pair.bending_after[v];
    bending.area += window.weights[i] * pair.areas[v];
  }
  return bending;
}

/// How much the normals of a window turn across an edge, radians: the spread of their main
/// direction beyond that of the next, which noise has too.
double turn_across(const Compared& pair, const Window& window, std::span<const Vec3> normals) {
  Matrix3d spread = Matrix3d::Zero();
  Vector3d mean = Vector3d::Zero();
  double area = 0.0;
  for (std::size_t i = 0; i < window.vertices.size(); ++i) {
    const double weight = window.weights[i] * pair.areas[window.vertices[i]];
    const Vec3 n = normals[window.vertices[i]];
    const Vector3d normal(n.x, n.y, n.z);
    spread += weight * normal * normal.transpose();
    mean += weight * normal;
    area += weight;
  }
  if (!(area > 0.0)) return 0.0;
  mean /= area;
  spread = spread / area - mean * mean.transpose();
  const Vector3d by_size =
      Eigen::SelfAdjointEigenSolver<Matrix3d>(spread, Eigen::EigenvaluesOnly).eigenvalues();
  return std::sqrt(std::max(by_size[2] - by_size[1], 0.0));
}

/// The heights of a window over the plane that fits it, and how much of them the result has.
struct Relief {
  double rms = 0.0;  ///< of the design
  double kept = 1.0;
};

/// Rows: two directions across a normal, and the normal.
Matrix3d frame_of(Vec3 normal) {
  const Vec3 off = std::abs(normal.x) < 0.6 ? Vec3{1.0, 0.0, 0.0} : Vec3{0.0, 1.0, 0.0};
  const Vec3 along = unit(cross(normal, off)), across = cross(normal, along);
  Matrix3d frame;
  frame << along.x, along.y, along.z, across.x, across.y, across.z, normal.x, normal.y, normal.z;
  return frame;
}

/// A height as a sum of coordinates: the third less the plane of the first two that fits it.
Vector3d over_plane(const Matrix3d& covariance) {
  Eigen::Matrix2d squares = covariance.topLeftCorner<2, 2>();
  squares += 1e-9 * covariance.trace() * Eigen::Matrix2d::Identity();  // for windows of one line
  const Eigen::Vector2d slopes = squares.ldlt().solve(covariance.topRightCorner<2, 1>());
  return {-slopes[0], -slopes[1], 1.0};
}

Relief relief_of(const Compared& pair, const Window& window) {
  using Vector6d = Eigen::Matrix<double, 6, 1>;
  using Matrix6d = Eigen::Matrix<double, 6, 6>;
  Matrix6d squares = Matrix6d::Zero();
  Vector6d sum = Vector6d::Zero();
  Vec3 normal = {}, normal_after = {};
  double area = 0.0;
  const Index middle = window.vertices.front();
  for (std::size_t i = 0; i < window.vertices.size(); ++i) {
    const Index v = window.vertices[i];
    const double weight = window.weights[i] * pair.areas[v];
    const Vec3 p = pair.before[v] - pair.before[middle], q = pair.after[v] - pair.after[middle];
    const Vector6d place(p.x, p.y, p.z, q.x, q.y, q.z);
    squares += weight * place * place.transpose();
    sum += weight * place;
    normal += weight * pair.normals_before[v];
    normal_after += weight * pair.normals_after[v];
    area += weight;
  }
  if (!(area > 0.0)) return {};
  sum /= area;
  Matrix6d frames = Matrix6d::Zero();
  frames.topLeftCorner<3, 3>() = frame_of(unit(normal));
  frames.bottomRightCorner<3, 3>() = frame_of(unit(normal_after));
  const Matrix6d covariance =
      frames * (squares / area - sum * sum.transpose()) * frames.transpose();
  const Vector3d first = over_plane(covariance.topLeftCorner<3, 3>());
  const Vector3d second = over_plane(covariance.bottomRightCorner<3, 3>());
  const double own = first.dot(covariance.topLeftCorner<3, 3>() * first);
  const double common = first.dot(covariance.topRightCorner<3, 3>() * second);
  if (!(own > 0.0)) return {};
  return {std::sqrt(own), common / own};
}

/// What values of the vertices of a window have in common with even ones: c0 + c1 x + c2 y, x and y
/// over the radius along its mean plane.
class EvenPart {
 public:
  EvenPart(const Compared& pair, const Window& window, double radius) : window_(window) {
    const std::size_t n = window.vertices.size();
    weights_.reserve(n);
    terms_.reserve(n);
    Vec3 normal = {};
    for (std::size_t i = 0; i < n; ++i) {
      const Index v = window.vertices[i];
      weights_.push_back(window.weights[i] * pair.areas[v]);
      normal += weights_[i] * pair.normals_before[v];
      area_ += weights_[i];
    }
    const Matrix3d frame = frame_of(unit(normal));
    Matrix3d squares = Matrix3d::Zero();
    for (const Index v : window.vertices) {
      const Vec3 p = (1.0 / radius) * (pair.before[v] - pair.before[window.vertices.front()]);
      const Vector3d place = frame * Vector3d(p.x, p.y, p.z);
      const Vector3d x(1.0, place[0], place[1]);
      squares += weights_[terms_.size()] * x * x.transpose();
      terms_.push_back(x);
    }
    squares += 1e-9 * area_ * Matrix3d::Identity();  // for windows of one line
    squares_ = squares.ldlt();
  }

  double area() const { return area_; }
  /// 1, x, y of a vertex by its place in the window.
  const Vector3d& terms(std::size_t i) const { return terms_[i]; }

  /// c0, c1, c2 of value_of(vertex).
  template <class ValueOf>
  Vector3d fitting(const ValueOf& value_of) const {
    Vector3d sum = Vector3d::Zero();
    for (std::size_t i = 0; i < terms_.size(); ++i)
      sum += weights_[i] * value_of(window_.vertices[i]) * terms_[i];
    return squares_.solve(sum);
  }

  /// The rms of what vectors have beyond it.
  template <class VectorOf>
  double beyond(const VectorOf& vector_of) const {
    Matrix3d sum = Matrix3d::Zero();
    double squares = 0.0;
    for (std::size_t i = 0; i < terms_.size(); ++i) {
      const Vec3 value = vector_of(window_.vertices[i]);
      sum += weights_[i] * terms_[i] * Vector3d(value.x, value.y, value.z).transpose();
      squares += weights_[i] * dot(value, value);
    }
    const Matrix3d even = squares_.solve(sum);
    return std::sqrt(std::max(squares - even.cwiseProduct(sum).sum(), 0.0) / area_);
  }

 private:
  const Window& window_;
  double area_ = 0.0;
  std::vector<double> weights_;
  std::vector<Vector3d> terms_;
  Eigen::LDLT<Matrix3d> squares_;
};

/// How far the middle of a window went along the normal beyond the whole, which may shift and tilt.
double dent_of(const Compared& pair, const Window& window, double radius) {
  const EvenPart even(pair, window, radius);
  if (!(even.area() > 0.0)) return 0.0;
  const auto offset = [&](Index v) { return pair.offsets[v]; };
  const Vector3d whole = even.fitting(offset);
  const double near = pair.radius(k_middle_radius) / radius;
  double sum = 0.0, area = 0.0;
  for (std::size_t i = 0; i < window.vertices.size(); ++i) {
    const Index v = window.vertices[i];
    if (window.weights[i] < 1.0 - near * near) continue;
    sum += pair.areas[v] * (pair.offsets[v] - whole.dot(even.terms(i)));
    area += pair.areas[v];
  }
  return area > 0.0 ? std::abs(sum / area) : 0.0;
}

/// How unevenly the normals of a window turned, degrees, beyond a part of how they lie.
double uneven_turn_of(const Compared& pair, const Window& window, double radius) {
  const EvenPart even(pair, window, radius);
  if (!(even.area() > 0.0)) return 0.0;
  const double own = even.beyond([&](Index v) { return pair.normals_before[v]; });
  const double turned =
      even.beyond([&](Index v) { return pair.normals_after[v] - pair.normals_before[v]; });
  return std::max(turned - k_own_part * own, 0.0) * 180.0 / std::numbers::pi;
}

bool has_enough(const Window& window) {
  return window.vertices.size() >= k_least_vertices && window.share > 0.0;
}

/// How much more the result is bent.
struct MoreBent {
  double nearly_all = 0.0, largest = 0.0;
  Index at = 0;
};

MoreBent more_bent(const Compared& pair) {
  constexpr double nearly_all = 0.99;
  std::vector<WindowBending> windows;
  Figures designed, bent;
  const double radius = pair.radius(k_bend_radius);
  const double near_border = k_border_radii * radius;
  const std::vector<double> to_border = border_distances(pair, near_border);
  for_each_window(pair.connectivity, pair.before, pair.areas, radius, [&](const Window& window) {
    if (!has_enough(window)) return;
    const WindowBending found = bending_of(pair, window);
    if (!(found.area > 0.0)) return;
    designed.add(found.before / found.area, found.share, found.middle);
    windows.push_back(found);
  });
  const double calm = designed.at_most_on(k_calm_part);
  for (const WindowBending& window : windows) {
    const double part = to_border[window.middle] > near_border ? 1.0 : k_border_part;
    bent.add(part * window.more(calm), window.share, window.middle);
  }
  return {bent.at_most_on(nearly_all), bent.largest(), bent.place_of_largest()};
}

/// A design without the shortest waves, which are most of what noise is bent, and a result without
/// them: what the noise has of longer waves hides none that are higher.
struct BelowNoise {
  Patch design;
  Compared pair;

  BelowNoise(const Patch& noisy, std::span<const Vec3> after)
      : design(noisy.with_positions(smooth(noisy, noisy.positions()))),
        pair(compared(design, smooth(noisy, {after.begin(), after.end()}), size_of(design))) {}

 private:
  static std::vector<Vec3> smooth(const Patch& noisy, std::vector<Vec3> positions) {
    const Patch patch = noisy.with_positions(std::move(positions));
    const double scale = patch.unit_scale();
    return smoothed_positions(patch, k_noise_wave * mean_side_of(patch.mesh(), scale) / scale);
  }
};

void find_folds(const Compared& pair, std::span<const Vec3> after,
                const std::optional<BelowNoise>& below_noise, FormChange& change) {
  const MoreBent bent = more_bent(pair), below = below_noise ? more_bent(below_noise->pair) : bent;
  change.ripple = std::max(bent.nearly_all, below.nearly_all);
  change.fold = std::max(bent.largest, below.largest);
  change.fold_at = after[below.largest > bent.largest ? below.at : bent.at];
}

void find_lost_edges(const Compared& pair, FormChange& change) {
  Figures lost;
  double all = 0.0;
  const double radius = pair.radius(k_edge_radius);
  for_each_window(pair.connectivity, pair.before, pair.areas, radius, [&](const Window& window) {
    if (!has_enough(window)) return;
    all += window.share;
    const double turn = turn_across(pair, window, pair.normals_before);
    if (turn <= k_least_edge) return;
    const double kept = turn_across(pair, window, pair.normals_after) / turn;
    lost.add(1.0 - kept, window.share, window.vertices.front());
  });
  const double edges = lost.area(),
               least = std::max(k_least_edge_part * edges, k_least_edge_area * all);
  if (edges > least) change.edge_lost = std::max(lost.at_most_on(1.0 - least / edges), 0.0);
}

void find_lost_relief(const Compared& pair, FormChange& change) {
  constexpr double less_than_half = 0.4;  // the rest lost as much or more
  Figures lost;
  const double radius = pair.radius(k_relief_radius);
  for_each_window(pair.connectivity, pair.before, pair.areas, radius, [&](const Window& window) {
    if (!has_enough(window)) return;
    const Relief relief = relief_of(pair, window);
    if (relief.rms > k_least_relief * radius)
      lost.add(1.0 - relief.kept, window.share, window.vertices.front());
  });
  change.relief_lost = std::max(lost.at_most_on(less_than_half), 0.0);
}

void find_uneven_turns(const Compared& pair, FormChange& change) {
  constexpr double nearly_all = 0.98;
  Figures turns;
  const double radius = pair.radius(k_feature_radius, k_least_feature_edges);
  for_each_window(pair.connectivity, pair.before, pair.areas, radius, [&](const Window& window) {
    if (has_enough(window))
      turns.add(uneven_turn_of(pair, window, radius), window.share, window.vertices.front());
  });
  change.uneven_turn = turns.at_most_on(nearly_all);
}

void find_dents(const Compared& pair, std::span<const Vec3> after, FormChange& change) {
  constexpr double nearly_all = 0.98;
  Figures dents;
  const double radius = pair.radius(k_dent_radius);
  for_each_window(pair.connectivity, pair.before, pair.areas, radius, [&](const Window& window) {
    if (has_enough(window))
      dents.add(dent_of(pair, window, radius) / radius, window.share, window.vertices.front());
  });
  change.dent = dents.at_most_on(nearly_all);
  change.dent_at = after[dents.place_of_largest()];
}

}  // namespace

bool FormChange::is_rippled() const {
  return ripple > k_seen_ripple;
}

bool FormChange::is_folded() const {
  return fold > k_seen_new_fold;
}

bool FormChange::is_dented() const {
  return dent > k_seen_dent;
}

bool FormChange::is_uneven() const {
  return uneven_turn > k_seen_uneven_turn;
}

bool FormChange::has_lost_relief() const {
  return relief_lost > k_seen_relief_lost;
}

bool FormChange::has_lost_edge() const {
  return edge_lost > k_seen_edge_lost;
}

FormChange form_change_of(const Patch& design, std::span<const Vec3> after, bool is_noisy) {
  FormChange change;
  const double size = size_of(design);
  if (!(size > 0.0)) return change;
  const Compared pair = compared(design, after, size);
  std::optional<BelowNoise> below_noise;
  if (is_noisy) below_noise.emplace(design, after);
  find_folds(pair, after, below_noise, change);
  find_lost_edges(pair, change);
  // Noise that went is no feature and no hill.
  const Compared& shown = below_noise ? below_noise->pair : pair;
  find_uneven_turns(shown, change);
  find_lost_relief(shown, change);
  find_dents(pair, after, change);
  return change;
}

}  // namespace planish
