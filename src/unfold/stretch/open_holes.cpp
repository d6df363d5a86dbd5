#include "unfold/stretch/open_holes.h"

#include <array>
#include <cstddef>
#include <utility>

#include "mesh/polygon/divide_polygon.h"

namespace planish {

namespace {

/// A triangle at rest where it lies.
RestTriangle as_it_lies(const Triangle& t, const std::vector<Vec2>& flat) {
  const Vec2 side = flat[t[1]] - flat[t[0]], other = flat[t[2]] - flat[t[0]];
  const double length = norm(side);
  return {length, {dot(side, other) / length, cross(side, other) / length}};
}

/// Triangles that cover a hole as it lies.
std::optional<std::vector<Triangle>> cover_of(const Disk& disk, std::size_t hole,
                                              const std::vector<Vec3>& places) {
  std::vector<Index> corners;  // counter-clockwise: the disk is on the left of its border
  for (std::size_t k = disk.loops.end(hole); k-- > disk.loops.begin(hole);)
    corners.push_back(disk.border[k]);
  if (corners.size() == 3) return {{{corners[0], corners[1], corners[2]}}};
  return divide_polygon(corners, places);
}

/// The disk with its holes covered as they lie; nothing where one crosses itself.
std::optional<Disk> covered(const Disk& disk, const std::vector<Vec2>& flat) {
  std::vector<Vec3> places;
  places.reserve(flat.size());
  for (const Vec2 p : flat)
    places.push_back({p.x, p.y, 0.0});
  Disk whole = disk;
  for (std::size_t hole = 1; hole < disk.loops.count(); ++hole) {
    const auto triangles = cover_of(disk, hole, places);
    if (!triangles) return std::nullopt;
    for (const Triangle& t : *triangles) {
      whole.triangles.push_back(t);
      whole.rest.push_back(as_it_lies(t, flat));
    }
  }
  if (!all_upright(whole, flat)) return std::nullopt;
  return whole;
}

}  // namespace

std::optional<LeastStretch> with_open_holes(const Disk& disk, const Disk& filled,
                                            std::vector<Vec2> start, int max_iterations,
                                            ThreadPool& pool,
                                            const std::function<void()>& after_step) {
  constexpr int most_rounds = 20;
  constexpr double least_gain = 0.01;
  LeastStretch best;
  {
    StretchSystem system(filled, pool);
    best = minimise_stretch(filled, system, std::move(start), max_iterations, after_step);
  }
  best.flat.resize(disk.vertex_count);
  for (int round = 0; round < most_rounds; ++round) {
    const std::optional<Disk> whole = covered(disk, best.flat);
    if (!whole) break;
    StretchSystem system(*whole, pool);
    LeastStretch next = minimise_stretch(*whole, system, best.flat, max_iterations, after_step);
    if (holes_cross(disk, next.flat)) break;
    next.iterations += best.iterations;
    const double before = total_energy(disk, best.flat), now = total_energy(disk, next.flat);
    best = std::move(next);
    if (!(now < (1.0 - least_gain) * before)) break;
  }
  if (holes_cross(disk, best.flat)) return std::nullopt;
  return best;
}

}  // namespace planish
