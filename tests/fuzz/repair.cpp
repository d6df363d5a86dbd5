// Mending any mesh within any length.

#include <algorithm>
#include <cmath>
#include <vector>

#include <planish/mesh/inspect.h>
#include <planish/mesh/patch.h>
#include <planish/mesh/repair.h>
#include <planish/mesh/wall.h>
#include <planish/mesh/weld.h>

#include "fuzz/bytes_to_patch.h"
#include "fuzz/check.h"
#include "support/meshes.h"

using namespace planish;

namespace {

/// A mesh with dirt of several kinds.
TriMesh dirty_mesh(fuzz::Bytes& bytes) {
  TriMesh mesh = fuzz::mesh_from(bytes);
  const std::size_t kind = bytes.whole(0, 7);
  if (kind == 1) {  // every triangle by itself
    mesh = meshes::soup_of(mesh);
  } else if (kind < 5 && kind > 1) {  // a second one, reversed, shifted or both
    TriMesh other = kind == 3 ? mesh : turned_over(mesh);
    const Vec3 shift = kind == 2 ? Vec3{} : Vec3{4.0 * bytes.fraction(), 0.0, bytes.fraction()};
    const auto count = static_cast<Index>(mesh.positions.size());
    for (const Vec3 p : other.positions)
      mesh.positions.push_back(p + shift);
    for (const Triangle& t : other.triangles)
      mesh.triangles.push_back({t[0] + count, t[1] + count, t[2] + count});
  }
  for (std::size_t more = bytes.whole(0, 7); more > 4; --more) {
    const auto vertex = [&] {
      return static_cast<Index>(
          bytes.whole(0, std::min<std::size_t>(mesh.positions.size(), 65536) - 1));
    };
    mesh.triangles.push_back({vertex(), vertex(), vertex()});
  }
  if (bytes.whole(0, 7) == 7) {
    for (Triangle& t : mesh.triangles) {
      if (bytes.flag()) std::swap(t[1], t[2]);
    }
  }
  return mesh;
}

double length_from(fuzz::Bytes& bytes) {
  const std::size_t kind = bytes.whole(0, 7);
  if (kind < 3) return bytes.any_double();
  return kind == 3 ? 0.0 : std::ldexp(1.0, static_cast<int>(bytes.whole(0, 40)) - 30);
}

void check_sources(const RepairedMesh& repaired, const TriMesh& mesh) {
  const TriMesh& result = repaired.mesh;
  fuzz::check(repaired.source.size() == result.triangles.size() &&
                  repaired.vertex_source.size() == result.positions.size(),
              "everything has a source");
  fuzz::check(result.positions.size() >= mesh.positions.size(), "vertices stay");
  for (std::size_t v = 0; v < result.positions.size(); ++v) {
    const Index source = repaired.vertex_source[v];
    fuzz::check(source < mesh.positions.size(), "vertices come from the mesh");
    fuzz::check(result.positions[v] == mesh.positions[source], "positions stay");
    fuzz::check(v >= mesh.positions.size() || source == v, "vertices keep their numbers");
  }
  for (std::size_t t = 0; t < result.triangles.size(); ++t) {
    const Index source = repaired.source[t];
    fuzz::check(source == RepairedMesh::none || source < mesh.triangles.size(),
                "triangles come from the mesh");
    for (const Index v : result.triangles[t])
      fuzz::check(v < result.positions.size(), "indices are in range");
  }
}

bool is_manifold(const TriMesh& mesh) {
  return Connectivity::build(mesh).has_value();
}

void check_welding(const TriMesh& mesh, double length) {
  const WeldedMesh welded = weld(mesh, length);
  check_sources(welded, mesh);
  if (!is_manifold(mesh)) return;
  fuzz::check(is_manifold(welded.mesh), "what was a manifold is one welded");
  fuzz::check(welded.mesh.triangles.size() >= mesh.triangles.size(), "no triangle is lost");
  const auto before = inspect(mesh).topology, after = inspect(welded.mesh).topology;
  fuzz::check(after.components <= before.components, "welding joins");
}

void check_filling(const TriMesh& mesh, double length) {
  const FilledMesh filled = fill_holes(mesh, length);
  check_sources(filled, mesh);
  if (!is_manifold(mesh)) return;
  fuzz::check(is_manifold(filled.mesh), "what was a manifold is one filled");
  const auto before = inspect(mesh).topology, after = inspect(filled.mesh).topology;
  fuzz::check(after.components == before.components, "pieces stay");
  fuzz::check((before.border_loops > 0) == (after.border_loops > 0), "outer borders stay");
}

void check_dividing(const TriMesh& mesh) {
  const SeparatedMesh separated = separate_touching(mesh);
  check_sources(separated, mesh);
  fuzz::check(separate_touching(separated.mesh).places == 0, "nothing touches any more");
  const SeparatedMesh divided = divide_at_nonmanifold_edges(mesh);
  check_sources(divided, mesh);
  fuzz::check(divided.mesh.triangles.size() == mesh.triangles.size(), "triangles stay");
}

void check_cleaning(const TriMesh& mesh) {
  const CleanedMesh clean = remove_redundant_triangles(mesh);
  check_sources(clean, mesh);
  fuzz::check(clean.mesh.triangles.size() + clean.removed() == mesh.triangles.size(),
              "what is left out is counted");
  fuzz::check(!is_manifold(mesh) || (clean.collapsed == 0 && clean.fins == 0),
              "a manifold has no other dirt than doubled sheets");
  const OrientedMesh oriented = orient_consistently(mesh);
  check_sources(oriented, mesh);
  fuzz::check(orient_consistently(oriented.mesh).turned == 0, "what was turned agrees");
  const Crumbs crumbs = find_crumbs(mesh);
  fuzz::check(crumbs.area_share >= 0.0 && crumbs.area_share <= 0.1, "crumbs are few");
  fuzz::check(crumbs.triangles.size() < mesh.triangles.size() || mesh.triangles.empty(),
              "something is no crumb");
  check_sources(without_triangles(mesh, crumbs.triangles), mesh);
}

void check_wall(const TriMesh& mesh) {
  const auto wall = find_wall(mesh);
  if (!wall) return;
  fuzz::check(wall->thickness > 0.0 && wall->part.size() == mesh.triangles.size(),
              "a wall is of the mesh");
  for (const WallPart side : {WallPart::outer, WallPart::inner}) {
    const RepairedMesh taken = take_side(mesh, *wall, side);
    check_sources(taken, mesh);
    fuzz::check(!taken.mesh.triangles.empty(), "a wall has two sides");
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Bytes bytes(data, size);
  const double length = length_from(bytes);
  const TriMesh mesh = dirty_mesh(bytes);
  fuzz::allow_refusal([&] { check_cleaning(mesh); });
  fuzz::allow_refusal([&] { check_dividing(mesh); });
  fuzz::allow_refusal([&] { check_welding(mesh, length); });
  fuzz::allow_refusal([&] { find_touching_pieces(mesh, length); });
  fuzz::allow_refusal([&] { check_filling(mesh, length); });
  fuzz::allow_refusal([&] { check_filling(separate_touching(mesh).mesh, length); });
  fuzz::allow_refusal([&] { check_wall(mesh); });
  return 0;
}
