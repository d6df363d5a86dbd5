#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include <planish/mesh/carry.h>

#include "core/math.h"
#include "mesh/carry/line_pieces.h"
#include "mesh/carry/planar_trace.h"
#include "mesh/carry/surface_trace.h"
#include "mesh/mean_edge.h"

namespace planish {

namespace {

constexpr double k_one_place = 1e-9;  // in sizes of the mesh
constexpr double k_reach = 1e-3;      // in mean edges
constexpr double k_farthest = 1e6;    // in sizes of the mesh
constexpr std::size_t k_most_places = 20'000'000;

bool is_near(Vec3 p, Vec3 middle) {
  const Vec3 apart = p - middle;
  return std::max({std::abs(apart.x), std::abs(apart.y), std::abs(apart.z)}) <= k_farthest;
}

[[noreturn]] void fail_far(const SourceLocation& place) {
  throw Error(ErrorCode::too_large,
              "what is drawn goes a million sizes of the mesh away from it: is it in other units, "
              "or drawn over another mesh?",
              place);
}

void check_near(const DrawnLines& drawn, Vec3 middle, double scale) {
  for (const DrawnLine& line : drawn.lines) {
    for (const Vec3 p : line.points) {
      if (!is_near(scale * p, middle)) fail_far(line.place);
    }
  }
  for (const Vec3 p : drawn.points) {
    if (!is_near(scale * p, middle)) fail_far({});
  }
}

/// Whether what is drawn lies in the plane of a flat mesh.
bool is_in_plane(const DrawnLines& drawn, double z, double scale, double reach) {
  const auto is_off = [&](Vec3 p) { return !(std::abs(scale * p.z - z) <= reach); };
  return std::none_of(drawn.points.begin(), drawn.points.end(), is_off) &&
         std::none_of(drawn.lines.begin(), drawn.lines.end(), [&](const DrawnLine& line) {
           return std::any_of(line.points.begin(), line.points.end(), is_off);
         });
}

SurfacePoint surface_place(const PlaceOnTriangle& place, const TriMesh& mesh) {
  return {mesh.triangles[place.triangle], place.shares};
}

/// Of a line that goes through a corner by several edges that meet there, once. A line that ended
/// where it begins still does.
std::vector<SurfacePoint> surface_line(const std::vector<PlaceOnTriangle>& places,
                                       const TriMesh& mesh) {
  std::vector<SurfacePoint> line;
  line.reserve(places.size());
  std::optional<Vec3> last;
  for (const PlaceOnTriangle& place : places) {
    const Vec3 p = point_of(place, mesh);
    if (last && norm(p - *last) <= k_least_share) continue;
    line.push_back(surface_place(place, mesh));
    last = p;
  }
  const bool is_closed = places.size() > 2 && places.front() == places.back();
  if (is_closed && line.size() > 1) line.back() = line.front();
  return line;
}

template <class Trace>
TracedLines traced(const TriMesh& mesh, const DrawnLines& drawn, double scale, const Trace& trace) {
  TracedLines result;
  const auto measure = [&](Vec3 p) {
    const auto place = trace.place_of(p);
    if (place) {
      const Vec3 apart = point_of(*place, mesh) - p;
      result.farthest = std::max(result.farthest, math::hypot(apart.x, apart.y, apart.z) / scale);
    }
    return place;
  };
  LinePieces pieces;
  const auto are_one = [&](const PlaceOnTriangle& a, const PlaceOnTriangle& b) {
    return norm(point_of(a, mesh) - point_of(b, mesh)) <= k_one_place;
  };
  for (const DrawnLine& line : drawn.lines) {
    const std::size_t first = pieces.pieces().size();
    for (std::size_t i = 1; i < line.points.size(); ++i) {
      trace.follow(scale * line.points[i - 1], scale * line.points[i], pieces);
      if (pieces.count() > k_most_places) {
        throw Error(
            ErrorCode::too_large,
            "the lines up to this one cross more than 20 million edges: carry fewer at once",
            line.place);
      }
    }
    for (const Vec3 p : line.points)
      measure(scale * p);
    pieces.end();
    if (line.points.size() > 2 && line.points.front() == line.points.back())
      pieces.close(first, are_one);
  }
  for (const auto& piece : pieces.pieces()) {
    std::vector<SurfacePoint> line = surface_line(piece, mesh);
    if (line.size() > 1) result.lines.push_back(std::move(line));
  }
  for (const Vec3 p : drawn.points) {
    if (const auto place = measure(scale * p)) {
      result.points.push_back(surface_place(*place, mesh));
    } else {
      ++result.outside_points;
    }
  }
  result.outside_length = pieces.outside() / scale;
  return result;
}

}  // namespace

TracedLines trace_lines(const Patch& patch, const DrawnLines& drawn) {
  if (patch.triangles().empty()) throw Error(ErrorCode::no_triangles, "the mesh has no triangles");
  const double scale = patch.unit_scale();
  const TriMesh mesh = scaled(patch.mesh(), scale);
  const double edge = mean_edge_length(mesh);
  const Vec3 some = mesh.positions[mesh.triangles.front().front()];
  check_near(drawn, some, scale);
  const double reach = k_reach * edge;
  if (is_flat(mesh) && is_in_plane(drawn, some.z, scale, reach))
    return traced(mesh, drawn, scale, PlanarTrace(mesh, reach));
  return traced(mesh, drawn, scale, SurfaceTrace(mesh, reach, k_most_edges_off * edge, 0.5 * edge));
}

bool is_flat(const TriMesh& mesh) {
  if (mesh.triangles.empty()) return false;
  const double z = mesh.positions[mesh.triangles.front().front()].z;
  return std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](Index v) { return mesh.positions[v].z == z; });
  });
}

void check_same_triangles(const TriMesh& one, const TriMesh& other) {
  const std::string advice =
      "; take a pair that one run of flatten wrote, as flat.obj and processed.obj";
  if (one.triangles.size() != other.triangles.size()) {
    throw Error(ErrorCode::malformed_file,
                "the meshes are no pair: one has " + std::to_string(one.triangles.size()) +
                    " triangles, the other " + std::to_string(other.triangles.size()) + advice);
  }
  const auto differ =
      std::mismatch(one.triangles.begin(), one.triangles.end(), other.triangles.begin());
  if (differ.first == one.triangles.end()) return;
  throw Error(ErrorCode::malformed_file,
              "the meshes are no pair: triangle " +
                  std::to_string(differ.first - one.triangles.begin()) +
                  ", counted from 0, has other corners in the one than in the other" + advice);
}

}  // namespace planish
