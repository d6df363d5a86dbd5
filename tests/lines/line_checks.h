#pragma once

// What holds of all lines that are made edges of a mesh, and of the mesh cut open along them.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include <planish/core/error.h>
#include <planish/mesh/cut.h>
#include <planish/mesh/imprint.h>
#include <planish/mesh/inspect.h>
#include <planish/mesh/surface_line.h>
#include <planish/mesh/tri_mesh.h>

namespace planish::lines {

/// What imprinting did, over many runs.
struct Figures {
  std::size_t lines = 0;
  std::size_t triangles = 0;  ///< that are new
  std::size_t thin = 0;       ///< of these with an angle below 5 degrees that the old one has not
  std::size_t given = 0;      ///< of the thin ones: the angle is one of lines and edges of the mesh
  double farthest = 0.0;      ///< that a path is from its line beside the snapping, of the diagonal
  double snap = 0.0;          ///< the farthest, of the diagonal
  double stretch = 0.0;       ///< that a path is longer or shorter than its line, relative

  double thin_share() const {
    return static_cast<double>(thin) / static_cast<double>(std::max<std::size_t>(triangles, 1));
  }

  void add(const Figures& other) {
    lines += other.lines;
    triangles += other.triangles;
    thin += other.thin;
    given += other.given;
    farthest = std::max(farthest, other.farthest);
    snap = std::max(snap, other.snap);
    stretch = std::max(stretch, other.stretch);
  }
};

inline Vec3 area_vector(const TriMesh& mesh, const Triangle& t) {
  const Vec3 a = mesh.positions[t[0]];
  return 0.5 * cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a);
}

struct SmallestAngle {
  double degrees = 180.0;
  std::size_t corner = 0;
};

inline SmallestAngle smallest_angle(const TriMesh& mesh, const Triangle& t) {
  SmallestAngle smallest;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 a = mesh.positions[t[k]];
    const Vec3 u = mesh.positions[t[(k + 1) % 3]] - a, v = mesh.positions[t[(k + 2) % 3]] - a;
    const double degrees = std::atan2(norm(cross(u, v)), dot(u, v)) / 0.017453292519943295;
    if (degrees < smallest.degrees) smallest = {degrees, k};
  }
  return smallest;
}

/// To a line of points, which may be one.
inline double distance_to(Vec3 p, const std::vector<Vec3>& line) {
  double nearest = norm(p - line.front());
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vec3 along = line[i] - line[i - 1], to = p - line[i - 1];
    const double length = dot(along, along);
    const double share = length > 0.0 ? std::clamp(dot(to, along) / length, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, norm(to - share * along));
  }
  return nearest;
}

inline double length_of(const std::vector<Vec3>& line) {
  double length = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i)
    length += norm(line[i] - line[i - 1]);
  return length;
}

using EdgeOfTwo = std::array<Index, 2>;

inline EdgeOfTwo edge_between(Index v, Index w) {
  return {std::min(v, w), std::max(v, w)};
}

inline double border_length(const Patch& patch) {
  double length = 0.0;
  for (const auto& loop : patch.border_loops()) {
    for (std::size_t k = 0; k < loop.size(); ++k)
      length += norm(patch.positions()[loop[(k + 1) % loop.size()]] - patch.positions()[loop[k]]);
  }
  return length;
}

/// Points at which a line turns by more than 10 degrees.
inline std::size_t corners_of(const std::vector<Vec3>& line) {
  constexpr double cosine = 0.984807753012208;
  std::size_t corners = 0;
  for (std::size_t i = 2; i < line.size(); ++i) {
    const Vec3 before = line[i - 1] - line[i - 2], after = line[i] - line[i - 1];
    corners += dot(before, after) < cosine * norm(before) * norm(after);
  }
  return corners;
}

/// Which edges are parts of lines, or of edges of the mesh.
class GivenEdges {
 public:
  GivenEdges(const TriMesh& mesh, const ImprintedMesh& imprinted)
      : vertices_(mesh.positions.size()), imprinted_(imprinted) {
    for (const auto& path : imprinted.paths) {
      for (std::size_t i = 1; i < path.size(); ++i)
        lines_.push_back(edge_between(path[i - 1], path[i]));
    }
    std::sort(lines_.begin(), lines_.end());
  }

  bool contains(Index v, Index w) const {
    if (std::binary_search(lines_.begin(), lines_.end(), edge_between(v, w))) return true;
    std::vector<Index> around = carriers(v);
    for (const Index other : carriers(w)) {
      if (std::find(around.begin(), around.end(), other) == around.end()) around.push_back(other);
    }
    return around.size() <= 2;
  }

 private:
  std::vector<Index> carriers(Index v) const {
    if (v < vertices_) return {v};
    const SurfacePoint& place = imprinted_.new_vertices[v - vertices_];
    std::vector<Index> all;
    for (std::size_t k = 0; k < 3; ++k) {
      if (place.shares[k] > 0.0) all.push_back(place.corners[k]);
    }
    return all;
  }

  std::size_t vertices_;
  const ImprintedMesh& imprinted_;
  std::vector<EdgeOfTwo> lines_;
};

/// Counts the thin ones of the new triangles.
inline void count_thin(const TriMesh& mesh, const ImprintedMesh& imprinted, Figures& figures) {
  constexpr double thin = 5.0;
  const GivenEdges given(mesh, imprinted);
  std::vector<std::size_t> parts(mesh.triangles.size(), 0);
  for (const Index whole : imprinted.triangle_of)
    ++parts[whole];
  for (std::size_t n = 0; n < imprinted.mesh.triangles.size(); ++n) {
    const Index whole = imprinted.triangle_of[n];
    if (parts[whole] == 1) continue;
    ++figures.triangles;
    const Triangle& t = imprinted.mesh.triangles[n];
    const SmallestAngle angle = smallest_angle(imprinted.mesh, t);
    if (angle.degrees >= thin || smallest_angle(mesh, mesh.triangles[whole]).degrees < thin)
      continue;
    ++figures.thin;
    const auto corner = [&](std::size_t k) { return t[(angle.corner + k) % 3]; };
    if (given.contains(corner(0), corner(1)) && given.contains(corner(0), corner(2)))
      ++figures.given;
  }
}

/// Whether the triangles are those of the mesh, divided: the same surface, no triangle turned over.
/// @return what is wrong, else nothing
inline std::string wrong_surface(const Patch& patch, const ImprintedMesh& imprinted,
                                 const Patch& result) {
  const TriMesh &mesh = patch.mesh(), &now = imprinted.mesh;
  const std::size_t n = mesh.positions.size();
  if (now.positions.size() < n ||
      std::memcmp(now.positions.data(), mesh.positions.data(), n * sizeof(Vec3)) != 0)
    return "a vertex has moved";
  if (imprinted.new_vertices.size() != now.positions.size() - n ||
      imprinted.triangle_of.size() != now.triangles.size())
    return "counts do not agree";
  const Inspection &before = patch.inspection(), &after = result.inspection();
  if (const auto problem = blocking_problem(after, Purpose::measure))
    return "the mesh is not sound any more: " + problem->message;
  if (after.topology.border_loops != before.topology.border_loops ||
      after.topology.components != before.topology.components ||
      after.topology.euler_characteristic != before.topology.euler_characteristic)
    return "the topology is another";
  const double rounding = 1e-13 * std::pow(bounding_box_diagonal(mesh), 2);
  std::vector<double> area(mesh.triangles.size(), 0.0);
  for (std::size_t t = 0; t < now.triangles.size(); ++t) {
    const Index whole = imprinted.triangle_of[t];
    const Vec3 normal = area_vector(mesh, mesh.triangles[whole]);
    const double size = norm(normal);
    const double share = dot(area_vector(now, now.triangles[t]), normal) / std::max(size, 1e-300);
    area[whole] += share;
    if (share < -rounding) return "triangle " + std::to_string(whole) + " has a part turned over";
  }
  for (std::size_t t = 0; t < area.size(); ++t) {
    if (std::abs(area[t] - norm(area_vector(mesh, mesh.triangles[t]))) > rounding)
      return "triangle " + std::to_string(t) + " has another area";
  }
  return {};
}

/// Whether each path is where its line is, within 1e-5 of the diagonal beside what was snapped, as
/// long to 0.1 %, and along edges.
inline std::string wrong_paths(const TriMesh& mesh, std::span<const SurfaceLine> lines,
                               const ImprintedMesh& imprinted, const Patch& result,
                               Figures& figures) {
  if (imprinted.paths.size() != lines.size()) return "there are more or fewer paths than lines";
  const double scale = bounding_box_diagonal(mesh);
  figures.snap = std::max(figures.snap, imprinted.farthest_snap / scale);
  for (std::size_t l = 0; l < lines.size(); ++l) {
    const auto& path = imprinted.paths[l];
    const std::string name = "line " + std::to_string(l);
    if (path.empty() || lines[l].empty()) {
      if (!path.empty() || !lines[l].empty()) return name + " has no path";
      continue;
    }
    std::vector<Vec3> drawn, made;
    for (const SurfacePoint& point : lines[l])
      drawn.push_back(position_of(point, mesh.positions));
    for (const Index v : path)
      made.push_back(imprinted.mesh.positions[v]);
    for (std::size_t i = 1; i < path.size(); ++i) {
      const auto ring = result.ring(path[i - 1]);
      if (std::find(ring.begin(), ring.end(), path[i]) == ring.end())
        return name + " leaves the edges";
    }
    double apart = 0.0;
    for (const Vec3 p : made)
      apart = std::max(apart, distance_to(p, drawn));
    for (const Vec3 p : drawn)
      apart = std::max(apart, distance_to(p, made));
    const double beside = (apart - imprinted.farthest_snap) / scale;
    figures.farthest = std::max(figures.farthest, beside);
    if (beside > 1e-5) return name + " was led elsewhere, by " + std::to_string(apart / scale);
    const double length = length_of(drawn), now = length_of(made);
    if (length < 50.0 * imprinted.farthest_snap) continue;  // snapping decides about these
    // Where an end or a corner is moved, the pieces beside it are longer or shorter by that.
    const auto moved = static_cast<double>(1 + corners_of(drawn));
    const double differs = std::abs(now - length) - 2.0 * moved * imprinted.farthest_snap;
    if (length > 1e-6 * scale) figures.stretch = std::max(figures.stretch, differs / length);
    if (differs > 1e-3 * length + 1e-9 * scale)
      return name + " has another length: " + std::to_string(now / length - 1.0);
  }
  return {};
}

/// Whether the mesh can be cut open along its paths, and the sides of each are as long as it. Paths
/// that cut nothing open are refused, and left out.
inline std::string wrong_cut(const ImprintedMesh& imprinted, const Patch& patch) {
  std::vector<CutPath> paths;
  for (std::size_t l = 0; l < imprinted.paths.size(); ++l) {
    if (imprinted.paths[l].size() > 1)
      paths.push_back({imprinted.paths[l], {.path = {}, .line = l + 1}});
  }
  while (!paths.empty()) {
    try {
      const CutMesh cut = cut_open(patch, paths);
      const Patch opened(cut.mesh);
      if (blocking_problem(opened.inspection(), Purpose::measure))
        return "the mesh that was cut open is no manifold";
      if (cut.mesh.triangles.size() != imprinted.mesh.triangles.size())
        return "cutting changes the number of triangles";
      for (std::size_t v = 0; v < cut.source.size(); ++v) {
        if (!(cut.mesh.positions[v] == imprinted.mesh.positions[cut.source[v]]))
          return "cutting moves a vertex";
      }
      const double expected = border_length(patch) + 2.0 * cut.length;
      if (std::abs(border_length(opened) - expected) > 1e-9 * expected)
        return "the sides of a cut are not as long as it";
      return {};
    } catch (const Error& error) {
      const auto line = error.place().line;
      if (error.code() != ErrorCode::misplaced_cut || !line)
        return std::string("cutting fails: ") + error.what();
      const auto is_it = [&](const CutPath& path) { return path.place.line == line; };
      if (std::erase_if(paths, is_it) == 0) return "an error names a line that is none";
    }
  }
  return {};
}

/// All of this.
inline std::string wrong_imprint(const Patch& patch, std::span<const SurfaceLine> lines,
                                 const ImprintedMesh& imprinted, Figures& figures) {
  const Patch result(imprinted.mesh);
  std::string wrong = wrong_surface(patch, imprinted, result);
  count_thin(patch.mesh(), imprinted, figures);
  if (wrong.empty()) wrong = wrong_paths(patch.mesh(), lines, imprinted, result, figures);
  if (wrong.empty()) wrong = wrong_cut(imprinted, result);
  return wrong;
}

}  // namespace planish::lines
