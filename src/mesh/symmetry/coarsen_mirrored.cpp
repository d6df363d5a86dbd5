#include "mesh/symmetry/coarsen_mirrored.h"

#include <algorithm>
#include <utility>

#include <planish/mesh/inspect.h>

namespace planish {

namespace {

struct UpperHalf {
  TriMesh mesh;
  std::vector<Index> source;        // of the patch, increasing
  std::vector<unsigned char> kept;  // by vertex
  std::size_t on_plane = 0;         // vertices
};

UpperHalf upper_half(const Patch& patch, const MirrorOrbits& orbits,
                     std::span<const unsigned char> keep) {
  UpperHalf half;
  std::vector<Index> number(patch.vertex_count(), 0);
  for (Index v = 0; v < patch.vertex_count(); ++v) {
    if (orbits.is_below(v)) continue;
    number[v] = static_cast<Index>(half.source.size());
    half.source.push_back(v);
    half.mesh.positions.push_back(patch.positions()[v]);
    const bool at_end = orbits.is_on_plane(v) && patch.connectivity().is_border(v);
    half.kept.push_back(at_end || (!keep.empty() && keep[v] != 0) ? 1 : 0);
    half.on_plane += orbits.is_on_plane(v) ? 1 : 0;
  }
  for (const Triangle& t : patch.triangles()) {
    const bool below = std::any_of(t.begin(), t.end(), [&](Index v) { return orbits.is_below(v); });
    if (!below) half.mesh.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
  }
  return half;
}

/// A half and its mirror image.
/// @param triangles by the numbers of the patch
CoarsePatch whole_of(const Patch& patch, const MirrorOrbits& orbits,
                     const std::vector<Triangle>& triangles) {
  CoarsePatch whole;
  for (const Triangle& t : triangles) {
    for (const Index v : t) {
      whole.source.push_back(v);
      whole.source.push_back(orbits.image(v));
    }
  }
  std::sort(whole.source.begin(), whole.source.end());
  whole.source.erase(std::unique(whole.source.begin(), whole.source.end()), whole.source.end());
  for (const Index v : whole.source)
    whole.mesh.positions.push_back(patch.positions()[v]);
  const auto number = [&](Index v) {
    return static_cast<Index>(std::lower_bound(whole.source.begin(), whole.source.end(), v) -
                              whole.source.begin());
  };
  for (const auto& [a, b, c] : triangles)
    whole.mesh.triangles.push_back({number(a), number(b), number(c)});
  for (const auto& [a, b, c] : triangles)
    whole.mesh.triangles.push_back(
        {number(orbits.image(a)), number(orbits.image(c)), number(orbits.image(b))});
  return whole;
}

/// One part with as many loops of the border, as methods take it. Halves may meet in more than the
/// line on the plane where triangles are large against them.
bool is_of_same_kind(const TriMesh& mesh, const Patch& patch) {
  const Inspection found = inspect(mesh);
  const Topology &after = found.topology, &before = patch.inspection().topology;
  return !blocking_problem(found, Purpose::evolve) && after.components == before.components &&
         after.border_loops == before.border_loops && after.genus == before.genus;
}

}  // namespace

std::optional<CoarsePatch> coarsen_mirrored(const Patch& patch, const MirrorOrbits& orbits,
                                            std::size_t vertices, CoarseBorder border,
                                            std::span<const unsigned char> keep,
                                            const ThreadPool* pool) {
  if (!orbits.is_symmetric()) return {};
  UpperHalf half = upper_half(patch, orbits, keep);
  const Patch upper(std::move(half.mesh));
  const bool can_be =
      !blocking_problem(upper.inspection(), Purpose::evolve) && can_be_coarsened(upper);
  if (!can_be) return {};
  // About every second vertex on the plane is left.
  const std::size_t left = (vertices + half.on_plane / 2) / 2;
  const CoarsePatch coarse = coarsen(upper, left, border, half.kept, pool);
  std::vector<Triangle> triangles;
  for (const Triangle& t : coarse.mesh.triangles) {
    const auto fine = [&](Index v) { return half.source[coarse.source[v]]; };
    triangles.push_back({fine(t[0]), fine(t[1]), fine(t[2])});
  }
  CoarsePatch whole = whole_of(patch, orbits, triangles);
  if (!is_of_same_kind(whole.mesh, patch)) return {};
  return whole;
}

}  // namespace planish
