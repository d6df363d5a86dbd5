#include "mesh/match/symmetric_whole.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

#include "core/math.h"

namespace planish {

namespace {

/// Vertices from end to end along the border.
using BorderPath = std::vector<Index>;

std::vector<BorderPath> paths_between(const Patch& half, std::array<Index, 2> ends) {
  std::vector<BorderPath> paths;
  for (const std::vector<Index>& loop : half.border_loops()) {
    const auto place = [&](Index v) {
      return static_cast<std::size_t>(std::find(loop.begin(), loop.end(), v) - loop.begin());
    };
    const std::size_t n = loop.size(), a = place(ends[0]), b = place(ends[1]);
    if (a == n || b == n || a == b) continue;
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
      BorderPath& path = paths.emplace_back();
      for (std::size_t k = from; k != to; k = (k + 1) % n)
        path.push_back(loop[k]);
      path.push_back(loop[to]);
    }
  }
  return paths;
}

double length_along(const BorderPath& path, const std::vector<Vec3>& positions) {
  double length = 0.0;
  for (std::size_t k = 1; k < path.size(); ++k)
    length += norm(positions[path[k]] - positions[path[k - 1]]);
  return length;
}

Vec3 without_part_along(Vec3 v, Vec3 unit) {
  return v - dot(v, unit) * unit;
}

Vec3 some_direction_across(Vec3 unit) {
  const Vec3 axis = std::abs(unit.x) < 0.6 ? Vec3{1.0, 0.0, 0.0} : Vec3{0.0, 1.0, 0.0};
  const Vec3 across = without_part_along(axis, unit);
  return 1.0 / norm(across) * across;
}

/// From a straight fold into the patch: the plane of mirror images is at right angles to that.
Vec3 direction_into(const Patch& half, const BorderPath& path, Vec3 along) {
  std::vector<bool> on_path(half.vertex_count(), false);
  for (const Index v : path)
    on_path[v] = true;
  Vec3 sum;
  for (const Triangle& t : half.triangles()) {
    const auto on = std::count_if(t.begin(), t.end(), [&](Index v) { return on_path[v]; });
    if (on != 2) continue;
    const Index inner = *std::find_if(t.begin(), t.end(), [&](Index v) { return !on_path[v]; });
    const Vec3 from = half.positions()[path.front()];
    sum = sum + without_part_along(half.positions()[inner] - from, along);
  }
  return sum;
}

/// Whether the patch meets a plane along a fold at right angles, by 30 degrees as a rule: else its
/// whole would have a crease there, which a fold that bulges cannot have.
bool stands_across(const Patch& half, const BorderPath& path, Vec3 normal) {
  constexpr double k_least_cosine = 0.86;
  const std::vector<Vec3>& p = half.positions();
  std::vector<std::size_t> place(half.vertex_count(), 0);
  for (std::size_t k = 0; k < path.size(); ++k)
    place[path[k]] = k + 1;
  double across = 0.0, all = 0.0;
  for (const Triangle& t : half.triangles()) {
    for (int k = 0; k < 3; ++k) {
      const Index a = t[k], b = t[(k + 1) % 3];
      if (place[a] == 0 || place[b] == 0 || place[a] + 1 != place[b]) continue;
      const Vec3 edge = p[b] - p[a];
      const double length = norm(edge);
      if (!(length > 0.0)) continue;
      const Vec3 into = without_part_along(p[t[(k + 2) % 3]] - p[a], 1.0 / length * edge);
      if (!(norm(into) > 0.0)) continue;
      across += length * std::abs(dot(into, normal)) / norm(into);
      all += length;
    }
  }
  return across >= k_least_cosine * all;
}

/// The plane through both ends that leaves the others least; nothing where they leave it too far.
std::optional<Plane> plane_of(const Patch& half, const BorderPath& path) {
  const std::vector<Vec3>& p = half.positions();
  const Vec3 start = p[path.front()], chord = p[path.back()] - start;
  const double length = length_along(path, p);
  if (!(norm(chord) > k_most_off_plane * length)) return std::nullopt;
  const Vec3 along = 1.0 / norm(chord) * chord;
  const Vec3 u = some_direction_across(along), w = cross(along, u);
  double uu_less_ww = 0.0, uw = 0.0, farthest = 0.0;
  for (const Index v : path) {
    const double a = dot(p[v] - start, u), b = dot(p[v] - start, w);
    uu_less_ww += a * a - b * b;
    uw += a * b;
    farthest = std::max(farthest, math::hypot(a, b));
  }
  const double most = k_most_off_plane * length;
  Vec3 normal;
  if (farthest > most) {
    // Across the direction in which the fold bulges most.
    const double angle = 0.5 * (math::atan2(2.0 * uw, uu_less_ww) + std::numbers::pi);
    normal = math::cos(angle) * u + math::sin(angle) * w;
    if (!stands_across(half, path, normal)) return std::nullopt;
  } else {
    const Vec3 into = direction_into(half, path, along);
    if (!(norm(into) > 0.0)) return std::nullopt;
    normal = 1.0 / norm(into) * into;
  }
  const bool is_plane = std::all_of(path.begin(), path.end(), [&](Index v) {
    return std::abs(dot(p[v] - start, normal)) <= most;
  });
  return is_plane ? std::optional(Plane{normal, dot(normal, start)}) : std::nullopt;
}

/// Whether an edge inside of the half joins two places of the fold: both halves would have it.
bool has_chord(const Patch& half, const BorderPath& path) {
  std::vector<std::size_t> place(half.vertex_count(), 0);
  for (std::size_t k = 0; k < path.size(); ++k)
    place[path[k]] = k + 1;
  const auto is_chord = [&](Index v, Index w) {
    if (place[v] == 0 || place[w] == 0) return false;
    return std::max(place[v], place[w]) - std::min(place[v], place[w]) > 1;
  };
  return std::any_of(half.triangles().begin(), half.triangles().end(), [&](const Triangle& t) {
    return is_chord(t[0], t[1]) || is_chord(t[1], t[2]) || is_chord(t[2], t[0]);
  });
}

SymmetricWhole whole_of(const Patch& half, const BorderPath& path, const Plane& plane) {
  std::vector<bool> on_fold(half.vertex_count(), false);
  for (const Index v : path)
    on_fold[v] = true;
  SymmetricMesh whole = with_mirror_image(half.mesh(), on_fold, plane);
  return {Patch(std::move(whole.mesh)), std::move(whole.image), plane, half.vertex_count()};
}

}  // namespace

std::optional<SymmetricWhole> symmetric_whole(const Patch& half, std::array<Index, 2> ends) {
  std::optional<Plane> plane;
  BorderPath fold;
  double least = std::numeric_limits<double>::infinity();
  for (BorderPath& path : paths_between(half, ends)) {
    const double length = length_along(path, half.positions());
    if (!(length < least)) continue;
    const std::optional<Plane> some = plane_of(half, path);
    if (!some || has_chord(half, path)) continue;
    plane = some;
    fold = std::move(path);
    least = length;
  }
  if (!plane) return std::nullopt;
  return whole_of(half, fold, *plane);
}

SymmetricMesh with_mirror_image(TriMesh half, const std::vector<bool>& is_welded,
                                const Plane& plane) {
  SymmetricMesh whole{std::move(half), {}};
  TriMesh& mesh = whole.mesh;
  const std::size_t vertices = mesh.positions.size(), triangles = mesh.triangles.size();
  whole.image.resize(vertices);
  for (Index v = 0; v < vertices; ++v) {
    whole.image[v] = v;
    if (is_welded[v]) {
      mesh.positions[v] = foot_on(plane, mesh.positions[v]);
      continue;
    }
    whole.image[v] = static_cast<Index>(mesh.positions.size());
    mesh.positions.push_back(mirrored(plane, mesh.positions[v]));
    whole.image.push_back(v);
  }
  for (std::size_t k = 0; k < triangles; ++k) {
    const Triangle t = mesh.triangles[k];
    mesh.triangles.push_back({whole.image[t[0]], whole.image[t[2]], whole.image[t[1]]});
  }
  return whole;
}

}  // namespace planish
