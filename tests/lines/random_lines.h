#pragma once

// Lines of many kinds on any mesh, at random.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

#include <planish/mesh/carry.h>
#include <planish/mesh/geodesic.h>
#include <planish/mesh/patch.h>
#include <planish/mesh/surface_line.h>

#include "support/meshes.h"

namespace planish::lines {

/// What is drawn at random. See Drawer.
enum class Kind {
  polylines,  ///< through places of the surface, far apart
  strokes,    ///< short steps that wander, points beside the surface by up to half an edge
  geodesics,  ///< shortest ways between two places
  planes,     ///< sections, every second one through three vertices
  loops,      ///< closed, small and large
  leaving,    ///< off the surface and back
  crossing,   ///< stars that cross themselves, and spirals
  borders,    ///< along the border, or near it; along edges where there is none
  vertices,   ///< through vertices but for 1e-12 to 1e-2 of an edge, along edges likewise
  twins,      ///< a line and the same again, 0 to 1e-3 of an edge beside it
  points,     ///< one place, once or several times, and the tiniest lines
  mixed,      ///< of each kind one
};
constexpr std::array<std::string_view, 12> k_kinds = {
    "polylines", "strokes", "geodesics", "planes", "loops",  "leaving",
    "crossing",  "borders", "vertices",  "twins",  "points", "mixed"};

class Drawer {
 public:
  Drawer(const Patch& patch, std::uint64_t seed) : patch_(patch), random_(seed) {
    double sum = 0.0;
    std::size_t count = 0;
    for (const Triangle& t : patch.triangles()) {
      for (std::size_t k = 0; k < 3; ++k, ++count)
        sum += norm(at(t[(k + 1) % 3]) - at(t[k]));
    }
    edge_ = sum / static_cast<double>(count);
  }

  /// From 0 to 1.
  double share() { return 0.5 + 0.5 * random_.number(); }
  /// From 0 on, below `count`.
  std::size_t pick(std::size_t count) {
    const auto index = static_cast<std::size_t>(share() * static_cast<double>(count));
    return std::min(index, count - 1);
  }

  /// At least `count` lines but where all of them lie off the surface.
  std::vector<SurfaceLine> lines(Kind kind, std::size_t count) {
    std::vector<SurfaceLine> all;
    drawn_ = {};
    for (std::size_t k = 0; k < count; ++k) {
      const Kind now = kind == Kind::mixed ? static_cast<Kind>(k % (k_kinds.size() - 1)) : kind;
      for (SurfaceLine& line : some(now))
        all.push_back(std::move(line));
    }
    for (SurfaceLine& line : trace_lines(patch_, drawn_).lines)
      all.push_back(std::move(line));
    return all;
  }

 private:
  Vec3 at(Index v) const { return patch_.positions()[v]; }

  SurfacePoint place() {
    const Triangle t = patch_.triangles()[pick(patch_.triangles().size())];
    double a = share(), b = share();
    if (a + b > 1.0) a = 1.0 - a, b = 1.0 - b;
    return {t, {1.0 - a - b, a, b}};
  }
  Vec3 point() { return position_of(place(), patch_.positions()); }
  Vec3 away(double size) { return meshes::random_point(random_, size); }
  /// From 1 down to 10^-decades, evenly in its logarithm.
  double small(double decades) { return std::pow(10.0, -decades * share()); }

  /// Remembers what is drawn, to be found on the surface with the rest.
  std::vector<SurfaceLine> draw(std::vector<Vec3> points) {
    drawn_.lines.push_back({std::move(points)});
    return {};
  }

  std::vector<SurfaceLine> some(Kind kind) {
    switch (kind) {
      case Kind::polylines:
        return draw(points_of(2 + pick(6)));
      case Kind::strokes:
        return draw(stroke());
      case Kind::geodesics:
        return {geodesic(patch_, place(), place()).points};
      case Kind::planes:
        return section();
      case Kind::loops:
        return draw(loop());
      case Kind::leaving:
        return draw(leaving());
      case Kind::crossing:
        return draw(crossing());
      case Kind::borders:
        return border();
      case Kind::vertices:
        return near_vertices();
      case Kind::twins:
        return twins();
      case Kind::points:
        return tiny();
      case Kind::mixed:
        break;
    }
    return {};
  }

  std::vector<Vec3> points_of(std::size_t count) {
    std::vector<Vec3> points;
    for (std::size_t k = 0; k < count; ++k)
      points.push_back(point());
    return points;
  }

  std::vector<Vec3> stroke() {
    std::vector<Vec3> points = {point()};
    Vec3 along = away(edge_);
    for (std::size_t k = 0; k < 40; ++k) {
      along = 0.8 * along + away(0.5 * edge_);
      points.push_back(points.back() + share() * along);
    }
    for (Vec3& p : points)
      p += away(0.3 * edge_);
    return points;
  }

  std::vector<SurfaceLine> section() {
    const std::vector<Vec3> p = points_of(3);
    Vec3 a = p[0], b = p[1], c = p[2];
    if (pick(2) == 0) {
      const auto vertex = [&] {
        return at(patch_.triangles()[pick(patch_.triangles().size())][0]);
      };
      a = vertex(), b = vertex(), c = vertex();
    }
    const Vec3 normal = cross(b - a, c - a);
    if (!(norm(normal) > 0.0)) return {};
    const double snap = pick(2) == 0 ? 0.0 : 1e-6 * bounding_box_diagonal(patch_.mesh());
    return plane_section(patch_, {normal, dot(normal, a)}, snap);
  }

  std::vector<Vec3> loop() {
    if (pick(2) == 0) {
      std::vector<Vec3> points = points_of(3 + pick(3));
      points.push_back(points.front());
      return points;
    }
    const Vec3 middle = point(), u = away(1.0), v = away(1.0);
    const double size = edge_ * 10.0 * small(3.0);
    std::vector<Vec3> points;
    const std::size_t count = 3 + pick(30);
    for (std::size_t k = 0; k < count; ++k) {
      const double turn =
          2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(count);
      points.push_back(middle + size * (std::cos(turn) * u + std::sin(turn) * v));
    }
    points.push_back(points.front());
    return points;
  }

  std::vector<Vec3> leaving() {
    std::vector<Vec3> points = points_of(2 + pick(4));
    const double size = bounding_box_diagonal(patch_.mesh());
    points.insert(points.begin() + static_cast<std::ptrdiff_t>(pick(points.size() + 1)),
                  point() + away(size * small(2.0)));
    return points;
  }

  std::vector<Vec3> crossing() {
    const Vec3 middle = point(), u = away(3.0 * edge_), v = away(3.0 * edge_);
    const bool is_star = pick(2) == 0;
    const std::size_t count = 5 + 2 * pick(3);
    std::vector<Vec3> points;
    for (std::size_t k = 0; k <= count; ++k) {
      const double steps = static_cast<double>(is_star ? k * (count / 2) : k);
      const double turn = 2.0 * std::numbers::pi * steps / static_cast<double>(count);
      const double size = is_star ? 1.0 : 1.0 - share();
      points.push_back(middle + size * (std::cos(turn) * u + std::sin(turn) * v));
    }
    return points;
  }

  /// Vertices that hang together, along the border where there is one.
  std::vector<Index> chain(std::size_t count) {
    std::vector<Index> path;
    if (!patch_.border_loops().empty()) {
      const auto& loop = patch_.border_loops()[pick(patch_.border_loops().size())];
      const std::size_t first = pick(loop.size());
      for (std::size_t k = 0; k < std::min(count, loop.size()); ++k)
        path.push_back(loop[(first + k) % loop.size()]);
      return path;
    }
    path.push_back(patch_.triangles()[pick(patch_.triangles().size())][0]);
    for (std::size_t k = 1; k < count; ++k) {
      const auto ring = patch_.ring(path.back());
      path.push_back(ring[pick(ring.size())]);
    }
    return path;
  }

  std::vector<SurfaceLine> border() {
    const std::vector<Index> path = chain(2 + pick(20));
    if (pick(2) == 0) return {line_along_edges(patch_, path)};
    std::vector<Vec3> points;
    const double size = 2.0 * edge_ * small(9.0);
    for (const Index v : path)
      points.push_back(at(v) + away(size));
    return draw(std::move(points));
  }

  std::vector<SurfaceLine> near_vertices() {
    std::vector<Index> path = {patch_.triangles()[pick(patch_.triangles().size())][0]};
    for (std::size_t k = 1; k < 12; ++k) {
      const auto ring = patch_.ring(path.back());
      path.push_back(ring[pick(ring.size())]);
    }
    const double size = edge_ * std::pow(10.0, -12.0 + 10.0 * share());
    std::vector<Vec3> points;
    for (const Index v : path)
      points.push_back(at(v) + away(size));
    return draw(std::move(points));
  }

  std::vector<SurfaceLine> twins() {
    const std::vector<Vec3> points = points_of(2 + pick(2));
    const double size = pick(4) == 0 ? 0.0 : edge_ * std::pow(10.0, -12.0 + 9.0 * share());
    std::vector<Vec3> moved;
    for (const Vec3 p : points)
      moved.push_back(p + away(size));
    draw(points);
    return draw(std::move(moved));
  }

  std::vector<SurfaceLine> tiny() {
    const SurfacePoint one = place();
    switch (pick(4)) {
      case 0:
        return {{one}};
      case 1:
        return {{one, one, one}};
      case 2:
        return {{}};
      default: {
        const Vec3 p = position_of(one, patch_.positions());
        const double size = edge_ * std::pow(10.0, -14.0 + 14.0 * share());
        return draw({p, p + away(size), p + away(size)});
      }
    }
  }

  const Patch& patch_;
  meshes::Random random_;
  DrawnLines drawn_;
  double edge_ = 0.0;
};

}  // namespace planish::lines
