#include "measure/form/compared.h"

#include <cmath>
#include <numbers>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "core/neumaier_sum.h"
#include "measure/bends.h"
#include "measure/normals.h"
#include "mesh/symmetry/moments.h"

namespace planish {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double k_middle_radius = 0.03;  // of a dent, of the size

// Of how unevenly the normals of the design lie. Where a feature turns as a whole or becomes a
// little lower, its normals turn as unevenly as that.
constexpr double k_own_part = 0.3;

Vec3 unit(Vec3 a) {
  const double length = norm(a);
  return length > 0.0 ? (1.0 / length) * a : Vec3{};
}

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

}  // namespace

double size_of(const Patch& design) {
  const SurfaceMoments moments =
      moments_of(design.triangles(), design.positions(), design.unit_scale());
  return moments.area > 0.0 ? std::sqrt(12.0 * moments.covariance.trace() / moments.area) : 0.0;
}

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
  pair.normals_before = unit_vertex_normals(design.triangles(), pair.before);
  pair.normals_after = unit_vertex_normals(design.triangles(), pair.after);
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

double uneven_turn_of(const Compared& pair, const Window& window, double radius) {
  const EvenPart even(pair, window, radius);
  if (!(even.area() > 0.0)) return 0.0;
  const double own = even.beyond([&](Index v) { return pair.normals_before[v]; });
  const double turned =
      even.beyond([&](Index v) { return pair.normals_after[v] - pair.normals_before[v]; });
  return std::max(turned - k_own_part * own, 0.0) * 180.0 / std::numbers::pi;
}

}  // namespace planish
