#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include <planish/mesh/inspect.h>
#include <planish/mesh/patch.h>

#include "geometry/curve_size.h"
#include "mesh/border_loops.h"
#include "mesh/inspect_manifold.h"
#include "mesh/manifold_defects.h"

namespace planish {

namespace {

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

void add(std::vector<Problem>& problems, ErrorCode code, std::string message, std::size_t count,
         std::size_t first) {
  if (count > 0) problems.push_back({code, std::move(message), count, first});
}

/// Where few digits of large coordinates may have brought vertices together, what to do; else
/// nothing.
std::string way_on_if_far(const TriMesh& mesh) {
  constexpr double k_far = 1000.0;  // times as far from the origin as the mesh is large
  double farthest = 0.0;
  for (const Triangle& tri : mesh.triangles) {
    for (const Index v : tri) {
      const Vec3 p = mesh.positions[v];
      farthest = std::max({farthest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    }
  }
  if (!(farthest > k_far * bounding_box_diagonal(mesh))) return {};
  return "; the mesh is far from the origin: if it has coordinates of few digits, which bring "
         "vertices together, move it to the origin in the program that made it, and export it "
         "again";
}

void find_bad_coordinates(const TriMesh& mesh, std::vector<Problem>& problems) {
  std::size_t count = 0, first = 0;
  for (std::size_t v = mesh.positions.size(); v-- > 0;) {
    const Vec3 p = mesh.positions[v];
    if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) continue;
    ++count;
    first = v;
  }
  add(problems, ErrorCode::non_finite_coordinate,
      counted(count, "vertex has a coordinate that is", "vertices have a coordinate that is") +
          " not a finite number; the first is vertex " + std::to_string(first),
      count, first);
}

void find_bad_indices(const TriMesh& mesh, std::vector<Problem>& problems) {
  std::size_t count = 0, first = 0;
  for (std::size_t t = mesh.triangles.size(); t-- > 0;) {
    const auto& triangle = mesh.triangles[t];
    const bool good = std::all_of(triangle.begin(), triangle.end(),
                                  [&](Index v) { return v < mesh.positions.size(); });
    if (good) continue;
    ++count;
    first = t;
  }
  add(problems, ErrorCode::index_out_of_range,
      counted(count, "triangle names", "triangles name") +
          " a vertex that does not exist; the first is triangle " + std::to_string(first),
      count, first);
}

void find_unreferenced(const TriMesh& mesh, std::vector<Problem>& problems) {
  std::vector<unsigned char> used(mesh.positions.size(), 0);
  for (const Triangle& t : mesh.triangles) {
    for (const Index v : t)
      used[v] = 1;
  }
  const auto count = static_cast<std::size_t>(std::count(used.begin(), used.end(), 0));
  const auto first =
      static_cast<std::size_t>(std::find(used.begin(), used.end(), 0) - used.begin());
  add(problems, ErrorCode::unreferenced_vertex,
      counted(count, "vertex is", "vertices are") +
          " used by no triangle, kept as they are and not measured; the first is vertex " +
          std::to_string(first),
      count, first);
}

void find_zero_lengths_and_areas(const TriMesh& mesh, std::vector<Problem>& problems) {
  const double scale = unit_scale(mesh);
  std::vector<std::pair<Index, Index>> points;  // edges of length zero
  std::size_t flat = 0, first_flat = 0;
  for (std::size_t t = mesh.triangles.size(); t-- > 0;) {
    const Triangle& tri = mesh.triangles[t];
    double longest = 0.0;
    bool has_point = false;
    for (int k = 0; k < 3; ++k) {
      const Index a = tri[k], b = tri[(k + 1) % 3];
      const Vec3 side = scale * mesh.positions[b] - scale * mesh.positions[a];
      const double squared = dot(side, side);
      longest = std::max(longest, squared);
      if (a == b || squared > 0.0) continue;
      has_point = true;
      points.emplace_back(std::min(a, b), std::max(a, b));
    }
    const Vec3 at = scale * mesh.positions[tri[0]];
    const Vec3 normal =
        cross(scale * mesh.positions[tri[1]] - at, scale * mesh.positions[tri[2]] - at);
    if (has_point || norm(normal) > 1e-15 * longest) continue;
    ++flat;
    first_flat = t;
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (!points.empty()) {
    const auto [a, b] = points.front();
    add(problems, ErrorCode::zero_length_edge,
        counted(points.size(), "edge has", "edges have") +
            " length zero, where angles are not defined; the first joins vertices " +
            std::to_string(a) + " and " + std::to_string(b) + ": merge or move them" +
            way_on_if_far(mesh),
        points.size(), a);
  }
  add(problems, ErrorCode::zero_area,
      counted(flat, "triangle has", "triangles have") +
          " no area: its corners lie on a line; the first is triangle " +
          std::to_string(first_flat),
      flat, first_flat);
}

/// Numbers the connected parts of the used vertices; unused vertices get no_part.
struct Parts {
  static constexpr Index no_part = static_cast<Index>(-1);
  std::vector<Index> part_of;
  std::size_t count = 0;

  /// The first vertex of a part.
  std::size_t first_of(std::size_t part) const {
    return static_cast<std::size_t>(
        std::find(part_of.begin(), part_of.end(), static_cast<Index>(part)) - part_of.begin());
  }
};

Parts find_parts(const TriMesh& mesh) {
  std::vector<Index> parent(mesh.positions.size());
  std::iota(parent.begin(), parent.end(), Index{0});
  const auto root = [&parent](Index v) {
    while (parent[v] != v)
      v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const Triangle& t : mesh.triangles) {
    for (int k = 1; k < 3; ++k) {
      const Index a = root(t[0]), b = root(t[k]);
      parent[std::max(a, b)] = std::min(a, b);  // so that numbers rise with the first vertex
    }
  }
  Parts parts;
  parts.part_of.assign(parent.size(), Parts::no_part);
  std::vector<unsigned char> used(parent.size(), 0);
  for (const Triangle& t : mesh.triangles) {
    for (const Index v : t)
      used[v] = 1;
  }
  for (std::size_t v = 0; v < parent.size(); ++v) {
    if (used[v] == 0) continue;
    const Index r = root(static_cast<Index>(v));
    parts.part_of[v] = r == v ? static_cast<Index>(parts.count++) : parts.part_of[r];
  }
  return parts;
}

std::size_t edge_count(const Connectivity& connectivity) {
  std::size_t ends = 0;
  for (Index v = 0; v < connectivity.vertex_count(); ++v)
    ends += connectivity.ring(v).size();
  return ends / 2;
}

/// Border loops that are no holes in the plane.
void find_tubes(const TriMesh& mesh, const Connectivity& connectivity, const Topology& topology,
                std::vector<Problem>& problems) {
  const auto& loops = connectivity.border_loops();
  if (topology.components != 1 || loops.size() < 2) return;
  const double scale = unit_scale(mesh);
  const BorderKinds kinds = border_kinds(mesh.positions, connectivity, scale);
  const std::vector<std::size_t>& ends = kinds.tube_ends;
  std::vector<std::size_t> slits;
  for (std::size_t k = 0; k < loops.size(); ++k) {
    if (k != kinds.outline && is_slit(mesh.positions, scale, loops[k])) slits.push_back(k);
  }
  const auto vertex = [&](const std::vector<std::size_t>& some) { return loops[some[0]].front(); };
  if (!slits.empty()) {
    add(problems, ErrorCode::several_border_loops,
        "a seam inside the mesh is open: " +
            counted(slits.size(), "border loop encloses", "border loops enclose") +
            " nothing, the first with vertex " + std::to_string(vertex(slits)),
        slits.size(), vertex(slits));
  } else if (!ends.empty()) {
    add(problems, ErrorCode::several_border_loops,
        "the surface is a tube: the border loop with vertex " + std::to_string(vertex(ends)) +
            " goes around it and is no hole in flat sheet",
        ends.size(), vertex(ends));
  }
}

void describe_manifold(const TriMesh& mesh, const Connectivity& connectivity, Inspection& result) {
  Topology& topology = result.topology;
  const Parts parts = find_parts(mesh);
  const auto& loops = connectivity.border_loops();
  std::vector<unsigned char> has_border(parts.count, 0);
  for (const auto& loop : loops)
    has_border[parts.part_of[loop.front()]] = 1;
  const auto used =
      static_cast<std::size_t>(std::count_if(parts.part_of.begin(), parts.part_of.end(),
                                             [](Index part) { return part != Parts::no_part; }));
  topology.components = parts.count;
  topology.border_loops = loops.size();
  topology.edges = edge_count(connectivity);
  topology.inner_vertices = connectivity.inner_vertices().size();
  topology.euler_characteristic =
      static_cast<long long>(used + topology.triangles) - static_cast<long long>(topology.edges);
  topology.genus = static_cast<std::size_t>(2 * static_cast<long long>(parts.count) -
                                            static_cast<long long>(loops.size()) -
                                            topology.euler_characteristic) /
                   2;
  const auto closed = static_cast<std::size_t>(std::count(has_border.begin(), has_border.end(), 0));
  const auto first_closed = parts.first_of(static_cast<std::size_t>(
      std::find(has_border.begin(), has_border.end(), 0) - has_border.begin()));
  add(result.problems, ErrorCode::closed_surface,
      (parts.count == 1 ? "the surface is closed"
                        : counted(closed, "component is", "components are") +
                              " closed, the first with vertex " + std::to_string(first_closed)) +
          "; a patch needs a border",
      closed, first_closed);
  if (parts.count > 1) {
    add(result.problems, ErrorCode::several_components,
        "the mesh has " + std::to_string(parts.count) + " components, the second with vertex " +
            std::to_string(parts.first_of(1)) + "; a pattern is made from one",
        parts.count, parts.first_of(1));
  }
  find_tubes(mesh, connectivity, topology, result.problems);
  add(result.problems, ErrorCode::handles,
      "the patch has " + counted(topology.genus, "handle", "handles") + " (Euler characteristic " +
          std::to_string(topology.euler_characteristic) + "); only a disk can be laid flat",
      topology.genus, 0);
  if (topology.inner_vertices == 0) {
    add(result.problems, ErrorCode::no_inner_vertex,
        parts.count > 1 ? "no vertex is inside: the triangles do not share vertices"
                        : "no vertex is inside, so there is nothing to measure or move",
        1, 0);
  }
}

/// The least demanding purpose that a problem prevents, if any.
std::optional<Purpose> blocked_from(ErrorCode code) {
  switch (code) {
    case ErrorCode::index_out_of_range:
    case ErrorCode::no_triangles:
    case ErrorCode::non_finite_coordinate:
    case ErrorCode::repeated_index:
    case ErrorCode::duplicate_triangle:
    case ErrorCode::non_manifold_edge:
    case ErrorCode::non_manifold_vertex:
    case ErrorCode::non_orientable:
    case ErrorCode::inconsistent_orientation:
    case ErrorCode::zero_length_edge:
      return Purpose::measure;
    case ErrorCode::closed_surface:
      return Purpose::evolve;
    case ErrorCode::several_components:
    case ErrorCode::several_border_loops:
    case ErrorCode::handles:
      return Purpose::unfold;
    default:
      return std::nullopt;
  }
}

void sort_worst_first(std::vector<Problem>& problems) {
  const auto rank = [](const Problem& problem) {
    const auto purpose = blocked_from(problem.code);
    return purpose ? static_cast<int>(*purpose) : 3;
  };
  std::stable_sort(problems.begin(), problems.end(),
                   [&](const Problem& a, const Problem& b) { return rank(a) < rank(b); });
}

}  // namespace

Inspection inspect_entries(const TriMesh& mesh) {
  Inspection result;
  result.topology.vertices = mesh.positions.size();
  result.topology.triangles = mesh.triangles.size();
  if (mesh.triangles.empty()) {
    add(result.problems, ErrorCode::no_triangles, "the mesh has no triangles", 1, 0);
    return result;
  }
  find_bad_coordinates(mesh, result.problems);
  find_bad_indices(mesh, result.problems);
  return result;
}

Inspection inspect(const TriMesh& mesh) {
  Inspection result = inspect_entries(mesh);
  if (!result.problems.empty()) return result;
  if (const auto connectivity = Connectivity::build(mesh))
    return inspect_manifold(mesh, *connectivity);
  const ManifoldDefects defects = find_manifold_defects(mesh);
  result.problems = defects.problems;
  for (Problem& problem : result.problems) {
    if (problem.code == ErrorCode::duplicate_triangle) problem.message += way_on_if_far(mesh);
  }
  result.topology.components = find_parts(mesh).count;
  result.topology.edges = defects.edges;
  result.topology.euler_characteristic =
      static_cast<long long>(defects.used_vertices + mesh.triangles.size()) -
      static_cast<long long>(defects.edges);
  find_zero_lengths_and_areas(mesh, result.problems);
  find_unreferenced(mesh, result.problems);
  sort_worst_first(result.problems);
  return result;
}

Inspection inspect_manifold(const TriMesh& mesh, const Connectivity& connectivity) {
  Inspection result = inspect_entries(mesh);
  if (!result.problems.empty()) return result;
  find_zero_lengths_and_areas(mesh, result.problems);
  describe_manifold(mesh, connectivity, result);
  find_unreferenced(mesh, result.problems);
  sort_worst_first(result.problems);
  return result;
}

Inspection inspect_moved(const Inspection& inspected, const TriMesh& mesh,
                         const Connectivity& connectivity) {
  const bool was_finite = std::none_of(
      inspected.problems.begin(), inspected.problems.end(),
      [](const Problem& problem) { return problem.code == ErrorCode::non_finite_coordinate; });
  Inspection result = inspect_entries(mesh);
  if (!result.problems.empty()) return result;
  if (!was_finite) return inspect_manifold(mesh, connectivity);
  result.topology = inspected.topology;
  find_zero_lengths_and_areas(mesh, result.problems);
  for (const Problem& problem : inspected.problems) {
    if (problem.code != ErrorCode::zero_length_edge && problem.code != ErrorCode::zero_area)
      result.problems.push_back(problem);
  }
  sort_worst_first(result.problems);
  return result;
}

std::optional<Problem> blocking_problem(const Inspection& inspection, Purpose purpose) {
  for (const Problem& problem : inspection.problems) {
    // Loose triangles would come back as they were, and no other problem tells the cause.
    const bool soup = problem.code == ErrorCode::no_inner_vertex &&
                      inspection.topology.components > 1 && purpose != Purpose::measure;
    if (soup) return problem;
  }
  for (const Problem& problem : inspection.problems) {
    const auto from = blocked_from(problem.code);
    if (from && *from <= purpose) return problem;
  }
  return std::nullopt;
}

namespace {

/// A problem where a mesh lacks enough triangles that its file may have been cut short; else
/// nothing.
std::string unused_vertices_text(const Inspection& inspection) {
  constexpr double k_many = 0.05;
  for (const Problem& problem : inspection.problems) {
    const double most = k_many * static_cast<double>(inspection.topology.vertices);
    if (problem.code != ErrorCode::unreferenced_vertex ||
        static_cast<double>(problem.count) <= most) {
      continue;
    }
    return ". " + std::to_string(problem.count) + " of " +
           counted(inspection.topology.vertices, "vertex is", "vertices are") +
           " used by no triangle: is the file whole?";
  }
  return {};
}

}  // namespace

void require(const Inspection& inspection, Purpose purpose) {
  if (const auto problem = blocking_problem(inspection, purpose)) {
    throw Error(problem->code, problem->message + unused_vertices_text(inspection),
                {.path = {}, .first = problem->first, .count = problem->count});
  }
}

}  // namespace planish
