// Compares geodesic() with the exact shortest paths of CGAL (Xin and Wang) on 1,000 pairs of
// places. CGAL is under the GPL and only here: nothing of ours links to it.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include <planish/io/read_mesh.h>
#include <planish/mesh/geodesic.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include "support/meshes.h"
#include "support/solids.h"
#include "support/test_patches.h"

namespace planish {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalMesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Search =
    CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, CgalMesh>>;

constexpr int k_starts = 10, k_goals_of_each = 10;  // on each mesh
constexpr double k_tolerance = 1e-9;                // relative

CgalMesh cgal_mesh(const TriMesh& mesh) {
  CgalMesh result;
  for (const Vec3 p : mesh.positions)
    result.add_vertex({p.x, p.y, p.z});
  for (const Triangle& t : mesh.triangles) {
    using Vertex = CgalMesh::Vertex_index;
    result.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2]));
  }
  return result;
}

struct Place {
  std::size_t triangle;
  SurfacePoint point;
};

/// In turn a vertex, a place on an edge, one inside a triangle.
Place random_place(const TriMesh& mesh, int kind, meshes::Random& random) {
  const auto share = [&] { return 0.5 * (random.number() + 1.0); };
  const auto t = static_cast<std::size_t>(share() * static_cast<double>(mesh.triangles.size()));
  const double a = kind % 3 == 0 ? 1.0 : share();
  const double b = kind % 3 == 2 ? (1.0 - a) * share() : 1.0 - a;
  return {t, {mesh.triangles[t], {a, b, 1.0 - a - b}}};
}

/// @param inside never on an edge: CGAL 5.5 puts starts there at the mirrored place
Search::Face_location location(const CgalMesh& mesh, const Place& place, bool inside) {
  const CgalMesh::Face_index face(static_cast<Index>(place.triangle));
  std::array<double, 3> shares = {};
  std::size_t k = 0;
  for (const auto h : halfedges_around_face(halfedge(face, mesh), mesh)) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (place.point.corners[j] == static_cast<Index>(source(h, mesh)))
        shares[k] = place.point.shares[j];
    }
    ++k;
  }
  const bool on_edge = std::count(shares.begin(), shares.end(), 0.0) == 1;
  if (inside && on_edge) *std::find(shares.begin(), shares.end(), 0.0) = 1e-14;
  return {face, {shares[0], shares[1], shares[2]}};
}

/// @return the number of pairs that differ
int compare(const std::string& name, const TriMesh& mesh) {
  const Patch patch(mesh);
  const CgalMesh other = cgal_mesh(mesh);
  meshes::Random random(7);
  double worst = 0.0;
  int wrong = 0;
  for (int i = 0; i < k_starts; ++i) {
    const Place from = random_place(mesh, i, random);
    Search search(other);
    search.add_source_point(location(other, from, true));
    for (int j = 0; j < k_goals_of_each; ++j) {
      const Place to = random_place(mesh, j, random);
      const auto [face, shares] = location(other, to, false);
      const double expected = search.shortest_distance_to_source_points(face, shares).first;
      const double length = geodesic(patch, from.point, to.point).length;
      const double apart = expected > 0.0 ? std::abs(length / expected - 1.0) : length;
      worst = std::max(worst, apart);
      if (apart <= k_tolerance) continue;
      ++wrong;
      std::printf("%s, start %d, goal %d: %.15g, of CGAL %.15g\n", name.c_str(), i, j, length,
                  expected);
    }
  }
  std::printf("%-24s %6zu vertices, differs by %.1e at most\n", name.c_str(), patch.vertex_count(),
              worst);
  std::fflush(stdout);
  return wrong;
}

TriMesh scaled(TriMesh mesh, Vec3 by) {
  for (Vec3& p : mesh.positions)
    p = {by.x * p.x, by.y * p.y, by.z * p.z};
  return mesh;
}

}  // namespace
}  // namespace planish

int main() {
  using namespace planish;
  std::vector<std::pair<std::string, TriMesh>> all = {
      {"plane", meshes::flat_grid(9, 7)},
      {"saddles", meshes::rough_grid(30, 30, 1, 0.25, 1.5)},
      {"saddles and needles", scaled(meshes::rough_grid(30, 30, 2), {1.0, 1e-4, 1.0})},
      {"handle", meshes::torus(24, 40)},
      {"handle, saddles", scaled(meshes::torus(9, 14), {1.0, 0.4, 2.5})},
      {"sphere", solids::sphere(1.0, 20)},
      {"star", solids::star_prism()},
      {"cube", solids::cube()},
      {"tube", meshes::tube(14, 20)},
      {"ruffles", meshes::ruffled_fan(14, 0.8)},
  };
  for (const PatchFacts& patch : patches()) {
    if (patch.vertices < 3000) all.emplace_back(patch.name, read_mesh(patch.path).mesh);
  }
  int wrong = 0;
  for (const auto& [name, mesh] : all)
    wrong += compare(name, mesh);
  std::printf("%zu pairs, %d wrong\n", 100 * all.size(), wrong);
  return wrong == 0 ? 0 : 1;
}
