#include "mesh/repair/facing.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "mesh/edge_sides.h"
#include "mesh/repair/sheets.h"
#include "mesh/search/first_hit.h"

namespace planish {

namespace {

// Normals of opposite triangles differ by less than 30 degrees.
constexpr double k_parallel = 0.8660254037844386;
// Distances are the median within this share.
constexpr double k_spread = 0.2;
// A side is at least this many times as large across as the wall is thick.
constexpr double k_least_extent = 20.0;
// The share of the area, without rims, that faces the other side.
constexpr double k_facing_area = 0.9;
// Of the area of a sample, with rims: less than that is no wall.
constexpr double k_sampled_area = 0.5;
constexpr std::size_t k_sample = 256;
// What is nearer than this is the triangle itself.
constexpr double k_nothing = 1e-9;

/// What a ray from a triangle met.
struct Facer {
  double distance = 0.0;
  Index opposite = FacingTriangles::none;
};

class Rays {
 public:
  explicit Rays(const TriMesh& mesh) : mesh_(mesh), tree_(mesh), areas_(unit_areas(mesh)) {
    for (const Triangle& t : mesh.triangles) {
      const Vec3 normal = cross(mesh.positions[t[1]] - mesh.positions[t[0]],
                                mesh.positions[t[2]] - mesh.positions[t[0]]);
      const double length = norm(normal);
      normals_.push_back(length > 0.0 ? 1.0 / length * normal : Vec3{});
    }
  }

  const std::vector<double>& areas() const { return areas_; }

  Facer from(Index t, Facing way) const {
    if (normals_[t] == Vec3{}) return {};
    if (way == Facing::apart) return one_way(t, -normals_[t], -1.0);
    if (way == Facing::towards) return one_way(t, normals_[t], -1.0);
    const Facer above = one_way(t, normals_[t], 1.0), below = one_way(t, -normals_[t], 1.0);
    if (above.opposite == FacingTriangles::none) return below;
    if (below.opposite == FacingTriangles::none) return above;
    return below.distance < above.distance ? below : above;
  }

 private:
  /// @param sign of the product of the normals that is asked for
  Facer one_way(Index t, Vec3 direction, double sign) const {
    const Triangle& corners = mesh_.triangles[t];
    Vec3 middle = mesh_.positions[corners[0]] + mesh_.positions[corners[1]];
    middle = 1.0 / 3.0 * (middle + mesh_.positions[corners[2]]);
    const auto hit = first_hit(tree_, middle, direction, k_nothing);
    if (!hit || sign * dot(normals_[t], normals_[hit->triangle]) < k_parallel) return {};
    return {hit->distance, hit->triangle};
  }

  const TriMesh& mesh_;
  BoxTree tree_;
  std::vector<double> areas_;
  std::vector<Vec3> normals_;
};

/// The distance on half of the area of those that face something; 0 where none does.
double median(const std::vector<Facer>& facers, const std::vector<double>& areas) {
  std::vector<std::pair<double, double>> distances;
  double whole = 0.0;
  for (std::size_t i = 0; i < facers.size(); ++i) {
    if (facers[i].opposite == FacingTriangles::none) continue;
    distances.emplace_back(facers[i].distance, areas[i]);
    whole += areas[i];
  }
  std::sort(distances.begin(), distances.end());
  double below = 0.0;
  for (const auto& [distance, area] : distances) {
    below += area;
    if (2.0 * below >= whole) return distance;
  }
  return 0.0;
}

bool is_near(const Facer& facer, double distance) {
  return facer.opposite != FacingTriangles::none &&
         std::abs(facer.distance - distance) <= k_spread * distance;
}

/// Whether it is worth while to send rays from all triangles.
bool may_face(const Rays& rays, Facing way) {
  const std::size_t count = rays.areas().size();
  const std::size_t step = std::max<std::size_t>(1, count / k_sample);
  std::vector<Facer> facers;
  std::vector<double> areas;
  for (std::size_t t = 0; t < count; t += step) {
    facers.push_back(rays.from(static_cast<Index>(t), way));
    areas.push_back(rays.areas()[t]);
  }
  const double distance = median(facers, areas);
  double whole = 0.0, near = 0.0;
  for (std::size_t i = 0; i < facers.size(); ++i) {
    whole += areas[i];
    if (is_near(facers[i], distance)) near += areas[i];
  }
  return near > k_sampled_area * whole;
}

/// The length of the edges between triangles that face the other side and those that do not: the
/// two borders of rims.
double length_of_rims(const TriMesh& mesh, const std::vector<Index>& opposite) {
  const std::vector<EdgeSide> sides = sorted_sides(mesh);
  double length = 0.0;
  for (const EdgeSides& edge : group_by_edge(sides)) {
    if (edge.size() != 2) continue;
    const bool one = opposite[edge.begin[0].triangle] == FacingTriangles::none;
    const bool other = opposite[edge.begin[1].triangle] == FacingTriangles::none;
    if (one != other)
      length += norm(mesh.positions[edge.begin->high] - mesh.positions[edge.begin->low]);
  }
  return length;
}

std::optional<FacingTriangles> facing(const TriMesh& mesh, const Rays& rays, Facing way) {
  if (!may_face(rays, way)) return std::nullopt;
  const std::size_t count = mesh.triangles.size();
  std::vector<Facer> facers;
  facers.reserve(count);
  for (std::size_t t = 0; t < count; ++t)
    facers.push_back(rays.from(static_cast<Index>(t), way));
  FacingTriangles result{way, median(facers, rays.areas()),
                         std::vector<Index>(count, FacingTriangles::none)};
  double whole = 0.0, near = 0.0;
  for (std::size_t t = 0; t < count; ++t) {
    whole += rays.areas()[t];
    if (!is_near(facers[t], result.distance)) continue;
    near += rays.areas()[t];
    result.opposite[t] = facers[t].opposite;
  }
  if (!(result.distance * k_least_extent <= std::sqrt(0.5 * near))) return std::nullopt;
  // A rim is as wide as the wall is thick, and has two borders.
  const double rims = 0.5 * result.distance * length_of_rims(mesh, result.opposite);
  if (near < k_facing_area * (whole - 1.2 * rims)) return std::nullopt;
  return result;
}

}  // namespace

std::optional<FacingTriangles> find_facing(const TriMesh& mesh) {
  const Rays rays(mesh);
  for (const Facing way : {Facing::apart, Facing::towards, Facing::same_way}) {
    if (auto found = facing(mesh, rays, way)) return found;
  }
  return std::nullopt;
}

}  // namespace planish
