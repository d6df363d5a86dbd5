#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include <planish/mesh/inspect.h>
#include <planish/mesh/symmetry.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include "core/figure_text.h"
#include "core/math.h"
#include "core/neumaier_sum.h"
#include "mesh/match/twins.h"
#include "mesh/search/closest_point.h"
#include "mesh/search/nearest_vertex.h"
#include "mesh/symmetry/mirror_fit.h"
#include "mesh/symmetry/moments.h"
#include "mesh/symmetry/plane_text.h"

namespace planish {

namespace {

constexpr double k_symmetric = 0.005;  // of the diagonal
constexpr double k_rounding = 1e-9;    // of the diagonal: planes this near are as good

/// The mesh with each vertex a little nearer to its neighbours: the two sides of a cut are no
/// longer at one place.
TriMesh drawn_in(TriMesh mesh) {
  constexpr double k_share = 0.05;
  std::vector<Vec3> sums(mesh.positions.size());
  std::vector<double> counts(mesh.positions.size(), 0.0);
  for (const Triangle& t : mesh.triangles) {
    const Vec3 sum = mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]];
    for (const Index v : t) {
      sums[v] += sum;
      counts[v] += 3.0;
    }
  }
  for (std::size_t v = 0; v < sums.size(); ++v) {
    if (!(counts[v] > 0.0)) continue;
    Vec3& p = mesh.positions[v];
    p += k_share * (1.0 / counts[v] * sums[v] - p);
  }
  return mesh;
}

/// A mesh at the scale of unit_scale(), and what is nearest to places.
class MirroredMesh {
 public:
  explicit MirroredMesh(const Patch& patch)
      : scale_(patch.unit_scale()),
        mesh_(scaled(patch.mesh(), scale_)),
        diagonal_(bounding_box_diagonal(mesh_)),
        surface_(mesh_),
        drawn_in_(drawn_in(mesh_)),
        vertices_(drawn_in_, drawn_in_.positions),
        used_(mesh_.positions.size(), 0) {
    for (const Triangle& t : mesh_.triangles) {
      for (const Index v : t)
        used_[v] = 1;
    }
  }
  MirroredMesh(const MirroredMesh&) = delete;
  MirroredMesh& operator=(const MirroredMesh&) = delete;
  ~MirroredMesh() = default;

  const TriMesh& mesh() const { return mesh_; }
  const ClosestPointTree& surface() const { return surface_; }
  double diagonal() const { return diagonal_; }
  double scale() const { return scale_; }

  /// Whether something lies on both sides: a flat mesh is no mirror image in its own plane.
  bool is_divided_by(const Plane& plane) const {
    constexpr double k_least_height = 0.01;  // of the diagonal
    double low = 0.0, high = 0.0;
    for (std::size_t v = 0; v < used_.size(); ++v) {
      if (used_[v] == 0) continue;
      const double height = height_over(plane, mesh_.positions[v]);
      low = std::min(low, height);
      high = std::max(high, height);
    }
    return std::min(-low, high) > k_least_height * diagonal_;
  }

  /// All at this scale.
  Symmetry in(const Plane& plane) const {
    Symmetry symmetry{plane};
    NeumaierSum squares;
    double largest = 0.0;
    std::size_t count = 0;
    for (std::size_t v = 0; v < used_.size(); ++v) {
      if (used_[v] == 0) continue;
      const double square = surface_.query(mirrored(plane, mesh_.positions[v])).squared_distance;
      squares.add(square);
      largest = std::max(largest, square);
      ++count;
    }
    symmetry.largest = std::sqrt(largest);
    symmetry.rms = std::sqrt(squares.value() / static_cast<double>(count));
    symmetry.image = images_in(plane);
    return symmetry;
  }

  /// The plane half way between vertices and their images.
  Plane between_images(const Symmetry& symmetry) const {
    std::vector<Vec3> places, partners;
    places.reserve(used_.size());
    partners.reserve(used_.size());
    for (std::size_t v = 0; v < used_.size(); ++v) {
      if (used_[v] == 0) continue;
      places.push_back(mesh_.positions[v]);
      partners.push_back(mesh_.positions[symmetry.image[v]]);
    }
    return plane_between(places, partners, symmetry.plane);
  }

 private:
  /// Empty where one has none.
  std::vector<Index> images_in(const Plane& plane) const {
    const double tolerance = k_twin_tolerance * diagonal_;
    std::vector<Index> image(used_.size());
    for (Index v = 0; v < image.size(); ++v) {
      image[v] = v;
      if (used_[v] == 0) continue;
      image[v] = vertices_.of(mirrored(plane, drawn_in_.positions[v]));
      const Vec3 there = mirrored(plane, mesh_.positions[v]);
      if (!(norm(mesh_.positions[image[v]] - there) <= tolerance)) return {};
    }
    for (Index v = 0; v < image.size(); ++v) {
      if (image[image[v]] != v) return {};
    }
    return image;
  }

  double scale_;
  TriMesh mesh_;
  double diagonal_;
  ClosestPointTree surface_;
  TriMesh drawn_in_;
  NearestVertex vertices_;
  std::vector<unsigned char> used_;
};

constexpr std::array k_axes = {Vec3{1.0, 0.0, 0.0}, Vec3{0.0, 1.0, 0.0}, Vec3{0.0, 0.0, 1.0}};

/// Its normal of length 1, pointing along the axis that it is nearest to.
Plane in_order(const Plane& plane) {
  const Vec3 n = 1.0 / norm(plane.normal) * plane.normal;
  const double offset = plane.offset / norm(plane.normal);
  double largest = n.x;
  for (const double part : {n.y, n.z}) {
    if (std::abs(part) > std::abs(largest) + k_rounding) largest = part;
  }
  return largest < 0.0 ? Plane{-n, -offset} : Plane{n, offset};
}

/// Normals from one axis to another in steps, without both.
void add_between(std::vector<Vec3>& normals, Vec3 from, Vec3 to) {
  constexpr int steps = 12;
  for (int k = 1; k < steps; ++k) {
    if (2 * k == steps) continue;
    const double angle = k * std::numbers::pi / steps;
    normals.push_back(math::cos(angle) * from + math::sin(angle) * to);
  }
}

/// Where the search begins: normals of planes through the middle.
std::vector<Vec3> first_normals(const SurfaceMoments& moments) {
  constexpr double k_distinct = 0.05;  // of the largest moment
  std::vector<Vec3> normals(k_axes.begin(), k_axes.end());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moments.covariance);
  std::array<Vec3, 3> axes;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d axis = solver.eigenvectors().col(k);
    axes[static_cast<std::size_t>(k)] = {axis[0], axis[1], axis[2]};
    normals.push_back(axes[static_cast<std::size_t>(k)]);
  }
  const auto& moment = solver.eigenvalues();
  const auto are_alike = [&](int k) { return moment[k + 1] - moment[k] <= k_distinct * moment[2]; };
  if (are_alike(0)) add_between(normals, axes[0], axes[1]);
  if (are_alike(1)) add_between(normals, axes[1], axes[2]);
  if (!are_alike(0) || !are_alike(1)) return normals;
  add_between(normals, axes[0], axes[2]);
  for (const double y : {1.0, -1.0}) {
    for (const double z : {1.0, -1.0})
      normals.push_back(std::sqrt(1.0 / 3.0) * (axes[0] + y * axes[1] + z * axes[2]));
  }
  return normals;
}

class SymmetrySearch {
 public:
  /// @param patch the same mesh, at another scale
  SymmetrySearch(const MirroredMesh& mesh, const Patch& patch)
      : mesh_(mesh),
        patch_(patch),
        moments_(moments_of(mesh.mesh().triangles, mesh.mesh().positions, 1.0)) {
    for (const Triangle& t : mesh.mesh().triangles) {
      const Vec3 a = mesh.mesh().positions[t[0]];
      const Vec3 n = cross(mesh.mesh().positions[t[1]] - a, mesh.mesh().positions[t[2]] - a);
      normals_.push_back(norm(n) > 0.0 ? 1.0 / norm(n) * n : Vec3{});
    }
  }

  /// At the scale of the mesh.
  Symmetry found() const {
    std::optional<Symmetry> best;
    for (const Plane& plane : promising()) {
      const Plane moved = fitting(k_places).refined(plane, 2, k_newton_steps).plane;
      if (!mesh_.is_divided_by(moved)) continue;
      Symmetry symmetry = along_axis_if_as_good(exact(mesh_.in(in_order(moved))));
      const bool is_whole = !symmetry.image.empty();
      if (!best || is_better(symmetry, *best)) best = std::move(symmetry);
      if (is_whole) break;
    }
    // Nothing lies on both sides of any: as of a mesh that is too flat and too narrow.
    return best ? *std::move(best) : mesh_.in({k_axes[0], dot(k_axes[0], middle())});
  }

 private:
  static constexpr std::size_t k_few_places = 300, k_places = 2000;
  static constexpr int k_rounds = 8, k_newton_steps = 20;

  Vec3 middle() const { return {moments_.middle[0], moments_.middle[1], moments_.middle[2]}; }

  MirrorFitting fitting(std::size_t count) const {
    std::vector<Vec3> places = even_places(mesh_.mesh(), count);
    const std::vector<Vec3> border = even_border_places(patch_, mesh_.mesh().positions, count / 2);
    places.insert(places.end(), border.begin(), border.end());
    return {mesh_.surface(), normals_, std::move(places), middle()};
  }

  /// Planes that fit best by few places, in their order.
  std::vector<Plane> promising() const {
    constexpr std::size_t k_most = 6;
    const MirrorFitting few = fitting(k_few_places);
    std::vector<MirrorFit> fits;
    for (const Vec3 normal : first_normals(moments_)) {
      const Plane plane{normal, dot(normal, middle())};
      const MirrorFit fit = few.refined(plane, k_rounds, k_rounds);
      if (mesh_.is_divided_by(fit.plane)) fits.push_back(fit);
    }
    std::vector<double> values;
    values.reserve(fits.size());
    for (const MirrorFit& fit : fits)
      values.push_back(fit.rms);
    std::sort(values.begin(), values.end());
    std::vector<Plane> planes;
    for (const MirrorFit& fit : fits) {
      if (planes.size() < k_most && fit.rms <= 2.0 * values.front() + 1e-6 * mesh_.diagonal())
        planes.push_back(fit.plane);
    }
    return planes;
  }

  bool is_as_good(const Symmetry& one, const Symmetry& other) const {
    constexpr double k_same = 1.05;
    return one.largest <= k_same * other.largest + k_rounding * mesh_.diagonal();
  }
  bool is_better(const Symmetry& one, const Symmetry& other) const {
    if (one.image.empty() != other.image.empty()) return !one.image.empty();
    return !is_as_good(other, one);
  }

  /// With vertex images the plane between these.
  Symmetry exact(Symmetry symmetry) const {
    if (symmetry.image.empty()) return symmetry;
    Symmetry between = mesh_.in(in_order(mesh_.between_images(symmetry)));
    return between.image.empty() ? symmetry : between;
  }

  /// People draw along axes, and about the origin.
  Symmetry along_axis_if_as_good(Symmetry symmetry) const {
    constexpr double k_near = 0.02;  // radians
    for (const Vec3 axis : k_axes) {
      if (!(norm(axis - symmetry.plane.normal) <= k_near)) continue;
      const double here = dot(axis, foot_on(symmetry.plane, middle()));
      for (const double offset : {0.0, here}) {
        if (!(std::abs(here - offset) <= k_symmetric * mesh_.diagonal())) continue;
        Symmetry straight = mesh_.in({axis, offset});
        const bool keeps_images = symmetry.image.empty() || !straight.image.empty();
        if (keeps_images && is_as_good(straight, symmetry)) return straight;
      }
    }
    return symmetry;
  }

  const MirroredMesh& mesh_;
  const Patch& patch_;
  SurfaceMoments moments_;
  std::vector<Vec3> normals_;
};

Symmetry in_model_units(Symmetry symmetry, double scale) {
  symmetry.plane.offset /= scale;
  symmetry.largest /= scale;
  symmetry.rms /= scale;
  return symmetry;
}

}  // namespace

TriMesh mirrored(const Plane& plane, TriMesh mesh) {
  for (Vec3& p : mesh.positions)
    p = mirrored(plane, p);
  for (Triangle& t : mesh.triangles)
    std::swap(t[1], t[2]);
  return mesh;
}

double symmetry_tolerance(const TriMesh& mesh) {
  return k_symmetric * bounding_box_diagonal(mesh);
}

std::string plane_text(const Plane& plane) {
  const auto text = [](double value) {
    std::array<char, 32> digits{};
    char* const end = digits.data() + digits.size();
    return std::string(digits.data(),
                       std::to_chars(digits.data(), end, value, std::chars_format::general, 6).ptr);
  };
  const Vec3 n = plane.normal;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (n == k_axes[axis]) return std::string(1, "xyz"[axis]) + "=" + text(plane.offset);
  }
  return "the plane with normal (" + text(n.x) + ", " + text(n.y) + ", " + text(n.z) +
         "), offset " + text(plane.offset);
}

void require_symmetric(const Patch& patch, const Symmetry& symmetry) {
  if (symmetry.largest <= symmetry_tolerance(patch.mesh())) return;
  const double diagonal = bounding_box_diagonal(patch.mesh());
  throw Error(ErrorCode::not_symmetric,
              "the mesh is not symmetric: mirrored in " + plane_text(symmetry.plane) +
                  ", its vertices are up to " + percent_text(symmetry.largest / diagonal) +
                  " of its diagonal from it (" + percent_text(symmetry.rms / diagonal) +
                  " rms), and at most " + percent_text(k_symmetric) + " counts as symmetric");
}

MirrorSide greater_side(const TriMesh& mesh, const Plane& plane) {
  constexpr double k_more = 1.0 + 1e-6;
  double above = 0.0, below = 0.0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
    const bool is_above = height_over(plane, 1.0 / 3.0 * (a + b + c)) > 0.0;
    (is_above ? above : below) += norm(cross(b - a, c - a));
  }
  return below > k_more * above ? MirrorSide::below : MirrorSide::above;
}

Symmetry symmetry_in(const Patch& patch, const Plane& plane) {
  require(patch.inspection(), Purpose::measure);
  const double largest =
      std::max({std::abs(plane.normal.x), std::abs(plane.normal.y), std::abs(plane.normal.z)});
  if (!(largest > 0.0) || !std::isfinite(largest) || !std::isfinite(plane.offset)) {
    throw Error(ErrorCode::option_out_of_range,
                "a plane of symmetry needs a normal that is not 0, and numbers");
  }
  const MirroredMesh mesh(patch);
  const Plane unit =
      in_order({1.0 / largest * plane.normal, mesh.scale() * (plane.offset / largest)});
  return in_model_units(mesh.in(unit), mesh.scale());
}

Symmetry find_symmetry(const Patch& patch) {
  require(patch.inspection(), Purpose::measure);
  const MirroredMesh mesh(patch);
  return in_model_units(SymmetrySearch(mesh, patch).found(), mesh.scale());
}

}  // namespace planish
