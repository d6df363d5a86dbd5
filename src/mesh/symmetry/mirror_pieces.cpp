#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include <planish/mesh/symmetry.h>

#include "geometry/box.h"
#include "mesh/match/twins.h"
#include "mesh/search/closest_point.h"
#include "mesh/split.h"

namespace planish {

namespace {

/// A piece and what is nearest to it.
class PlacedPiece {
 public:
  PlacedPiece(const TriMesh& mesh, const Plane& plane) : mesh_(mesh), used_(vertices_of(mesh)) {
    if (used_.empty()) return;
    surface_.emplace(mesh);
    double weighted = 0.0;
    for (const Triangle& t : mesh.triangles) {
      const Vec3 a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
      weighted += norm(cross(b - a, c - a)) * height_over(plane, 1.0 / 3.0 * (a + b + c));
    }
    height_ = weighted;
    for (const Index v : used_) {
      const Vec3 p = mesh.positions[v];
      box_.add(p);
      image_box_.add(mirrored(plane, p));
      low_ = std::min(low_, height_over(plane, p));
      high_ = std::max(high_, height_over(plane, p));
    }
  }

  bool is_empty() const { return used_.empty(); }
  bool is_above() const { return height_ > 0.0; }
  /// As far as the other side, but for a half.
  bool reaches_across() const { return std::min(-low_, high_) >= 0.5 * std::max(-low_, high_); }

  bool may_be_image_of(const PlacedPiece& other, double tolerance) const {
    const auto differ = [&](double Vec3::*x) {
      return std::abs(box_.low.*x - other.image_box_.low.*x) > tolerance ||
             std::abs(box_.high.*x - other.image_box_.high.*x) > tolerance;
    };
    return !differ(&Vec3::x) && !differ(&Vec3::y) && !differ(&Vec3::z);
  }

  /// The largest distance of mirrored vertices from another piece; nothing above the tolerance.
  std::optional<double> distance_to(const PlacedPiece& other, const Plane& plane,
                                    double tolerance) const {
    double largest = 0.0;
    for (const Index v : used_) {
      const Vec3 there = mirrored(plane, mesh_.positions[v]);
      const double square = other.surface_->query(there).squared_distance;
      if (!(square <= tolerance * tolerance)) return std::nullopt;
      largest = std::max(largest, square);
    }
    return std::sqrt(largest);
  }

 private:
  static std::vector<Index> vertices_of(const TriMesh& mesh) {
    std::set<Index> used;
    for (const Triangle& t : mesh.triangles)
      used.insert(t.begin(), t.end());
    return {used.begin(), used.end()};
  }

  const TriMesh& mesh_;
  std::vector<Index> used_;
  std::optional<ClosestPointTree> surface_ = {};
  Box box_, image_box_;
  double height_ = 0.0, low_ = 0.0, high_ = 0.0;
};

/// How far two pieces are from being mirror images; nothing above the tolerance.
std::optional<double> distance_between(const PlacedPiece& one, const PlacedPiece& other,
                                       const Plane& plane, double tolerance) {
  if (!other.may_be_image_of(one, tolerance)) return std::nullopt;
  const auto there = one.distance_to(other, plane, tolerance);
  if (!there || &one == &other) return there;
  const auto back = other.distance_to(one, plane, tolerance);
  return back ? std::optional(std::max(*there, *back)) : std::nullopt;
}

/// Whether the mirror images of all triangles of one mesh are triangles of the other one.
/// @param image vertex of the one -> of the other
bool have_same_triangles(const TriMesh& one, const TriMesh& other, std::span<const Index> image) {
  if (one.triangles.size() != other.triangles.size()) return false;
  std::set<Triangle> all;
  const auto sorted = [](Triangle t) {
    std::sort(t.begin(), t.end());
    return t;
  };
  for (const Triangle& t : other.triangles)
    all.insert(sorted(t));
  return std::all_of(one.triangles.begin(), one.triangles.end(), [&](const Triangle& t) {
    return all.contains(sorted({image[t[0]], image[t[1]], image[t[2]]}));
  });
}

bool is_exact_image(const TriMesh& original, const TriMesh& image, const Plane& plane) {
  const std::array<const TriMesh*, 2> meshes = {&original, &image};
  const auto twin = find_twins(meshes)[1];
  if (!twin || !twin->match.mirrored) return false;
  const double tolerance = k_twin_tolerance * bounding_box_diagonal(original);
  for (std::size_t v = 0; v < original.positions.size(); ++v) {
    const Vec3 there = image.positions[twin->match.vertex[v]];
    if (!(norm(mirrored(plane, original.positions[v]) - there) <= tolerance)) return false;
  }
  return true;
}

double area_of(const TriMesh& mesh) {
  double area = 0.0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 a = mesh.positions[t[0]];
    area += norm(cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a));
  }
  return area;
}

/// Without crumbs that a plane cuts off, where a border runs along it.
TriMesh without_crumbs(const TriMesh& mesh) {
  constexpr double k_crumbs = 0.01;  // of the area
  std::vector<NamedPatch> parts = split(mesh, "");
  const auto largest = std::max_element(
      parts.begin(), parts.end(),
      [](const NamedPatch& a, const NamedPatch& b) { return area_of(a.mesh) < area_of(b.mesh); });
  const bool has_more = area_of(largest->mesh) < (1.0 - k_crumbs) * area_of(mesh);
  if (has_more) return mesh;
  return std::move(largest->mesh);
}

bool is_exactly_across(const TriMesh& mesh, const Plane& plane) {
  const Symmetry symmetry = symmetry_in(Patch(mesh), plane);
  return !symmetry.image.empty() && have_same_triangles(mesh, mesh, symmetry.image);
}

}  // namespace

std::vector<MirrorPiece> mirror_pieces(std::span<const TriMesh> pieces, const Plane& plane,
                                       MirrorSide side, double tolerance) {
  std::vector<std::unique_ptr<PlacedPiece>> placed;
  placed.reserve(pieces.size());
  for (const TriMesh& piece : pieces)
    placed.push_back(std::make_unique<PlacedPiece>(piece, plane));
  std::vector<MirrorPiece> found(pieces.size());
  std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    if (placed[p]->is_empty()) continue;
    if (placed[p]->reaches_across()) {
      if (const auto own = distance_between(*placed[p], *placed[p], plane, tolerance))
        found[p] = {MirrorPiece::Kind::across, p, *own};
      continue;
    }
    if (placed[p]->is_above() != (side == MirrorSide::above)) continue;
    for (std::size_t q = 0; q < pieces.size(); ++q) {
      if (placed[q]->is_empty() || placed[q]->is_above() == placed[p]->is_above()) continue;
      const auto distance = distance_between(*placed[p], *placed[q], plane, tolerance);
      if (distance) pairs.emplace_back(*distance, p, q);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  for (const auto& [distance, p, q] : pairs) {
    if (found[p].kind != MirrorPiece::Kind::alone || found[q].kind != MirrorPiece::Kind::alone)
      continue;
    found[p] = {MirrorPiece::Kind::original, q, distance};
    found[q] = {MirrorPiece::Kind::image, p, distance};
  }
  return found;
}

std::vector<TriMesh> symmetric_pieces(std::vector<TriMesh> pieces,
                                      std::span<const MirrorPiece> found, const Plane& plane,
                                      MirrorSide side) {
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    const TriMesh& original = pieces[found[p].of];
    if (found[p].kind == MirrorPiece::Kind::image) {
      if (!is_exact_image(original, pieces[p], plane)) pieces[p] = mirrored(plane, original);
    } else if (found[p].kind == MirrorPiece::Kind::across && !is_exactly_across(original, plane)) {
      pieces[p] = without_crumbs(symmetric_mesh(Patch(original), plane, side).mesh);
    }
  }
  return pieces;
}

}  // namespace planish
