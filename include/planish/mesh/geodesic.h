#pragma once

#include <optional>
#include <span>
#include <vector>

#include <planish/core/context.h>
#include <planish/mesh/carry.h>
#include <planish/mesh/patch.h>

namespace planish {

/// A line over a surface that is straight in every triangle.
struct GeodesicPath {
  /// Two or more, two that follow each other on one triangle. Of a place on an edge the third share
  /// is 0, of one at a vertex the shares are 1, 0, 0; but the ends are as they were given.
  std::vector<SurfacePoint> points;
  double length = 0.0;  ///< model units
};

/// The shortest path over the surface from one place to another, of several always the same one.
/// Exact but for rounding; triangles without area can hide a shorter one. It bends at vertices with
/// an angle sum above 2 pi and at the border.
/// @throws Error several_components where no path leads there; option_out_of_range for a place that
///   is on no triangle; what require() with Purpose::measure throws; Cancelled
GeodesicPath geodesic(const Patch& patch, const SurfacePoint& from, const SurfacePoint& to,
                      const Context& context = {});

/// The path drawn tight between its ends, and pulled over each vertex at which that makes it
/// shorter, until it is a shortest path among those near it. Never longer, but for rounding.
/// @param path two places or more, two that follow each other on one triangle
/// @throws Error option_out_of_range for any other path; else as geodesic()
GeodesicPath shortened(const Patch& patch, std::span<const SurfacePoint> path,
                       const Context& context = {});

/// The same for a loop, which may move as a whole. One that nothing holds shrinks to two equal
/// points, of length 0.
/// @param loop its last place is the first one again
GeodesicPath shortened_loop(const Patch& patch, std::span<const SurfacePoint> loop,
                            const Context& context = {});

/// Goes straight on over the surface: across an edge as if the two triangles lay in a plane, across
/// a vertex with the same angle on both sides (Polthier and Schmies 1998). Ends at the border,
/// shorter than asked then.
/// @param from at a vertex or on an edge, the direction is that in the triangle which it names
/// @param direction of any length; its component in the plane of that triangle counts
/// @param length model units, >= 0
/// @throws Error option_out_of_range for a direction with no such component or another length;
///   too_large for a path of more than 20 million places; else as geodesic()
GeodesicPath straightest(const Patch& patch, const SurfacePoint& from, Vec3 direction,
                         double length, const Context& context = {});

/// Rings around limbs, necks and handles: closed paths that are the shortest among those near them,
/// at places where the surface is wider by 5 % on either side, within half of the ring's length. By
/// length; of those within a quarter of their length of each other the shortest. Looked for from
/// 150 places spread over the mesh; none shorter than 6 mean edges.
/// @throws Error what require() with Purpose::measure throws; Cancelled
std::vector<GeodesicPath> narrow_rings(const Patch& patch, const Context& context = {});

/// The ring at a place: the shortest loop there that does not merely go around a bump, drawn to the
/// narrow place next to it. Where that is farther than a quarter of its length, it stays where it
/// is and has a corner near the place.
/// @return nothing where no loop goes around anything
/// @throws Error option_out_of_range for a place that is on no triangle; else as narrow_rings()
std::optional<GeodesicPath> ring_at(const Patch& patch, const SurfacePoint& place,
                                    const Context& context = {});

}  // namespace planish
