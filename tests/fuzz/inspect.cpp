// Inspecting, measuring and dividing any mesh.

#include <cmath>

#include <planish/measure/flattenability.h>
#include <planish/mesh/inspect.h>
#include <planish/mesh/seams.h>

#include "fuzz/bytes_to_patch.h"
#include "fuzz/check.h"
#include "mesh/split.h"

using namespace planish;

namespace {

/// Triangles over few vertices, so that most share edges.
TriMesh triangle_soup(fuzz::Bytes& bytes) {
  TriMesh mesh;
  const std::size_t vertices = bytes.whole(0, 12), triangles = bytes.whole(0, 24);
  for (std::size_t t = 0; t < triangles; ++t) {
    Triangle triangle{};
    for (Index& v : triangle)
      v = static_cast<Index>(bytes.whole(0, vertices + (bytes.byte() == 255 ? 1 : 0)));
    mesh.triangles.push_back(triangle);
  }
  for (std::size_t v = 0; v <= vertices; ++v) {
    mesh.positions.push_back({bytes.fraction(), bytes.fraction(), bytes.fraction()});
  }
  return mesh;
}

void check_figures(const TriMesh& mesh, const Inspection& inspection) {
  const Patch patch(mesh);
  const Flattenability f = measure(patch);
  for (const double figure :
       {f.e_max, f.e_avg, f.energy, f.sum_abs_defect, f.min_angle, f.roughness}) {
    fuzz::check(std::isfinite(figure) && figure >= 0.0, "figures are finite");
  }
  is_flattenable(f, inspection);
  fuzz::check(patch.inner_vertices().size() == inspection.topology.inner_vertices,
              "inner vertices are counted alike");
  fuzz::check(patch.border_loops().size() == inspection.topology.border_loops,
              "border loops are counted alike");
  find_seams({&mesh, 1});
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Bytes bytes(data, size);
  const TriMesh mesh = bytes.flag() ? fuzz::mesh_from(bytes) : triangle_soup(bytes);
  const Inspection inspection = inspect(mesh);
  for (const Problem& problem : inspection.problems)
    fuzz::check(problem.count > 0 && !problem.message.empty(), "problems say what they are");
  fuzz::allow_refusal([&] {
    std::size_t triangles = 0;
    for (const NamedPatch& patch : split(mesh, "mesh"))
      triangles += patch.mesh.triangles.size();
    fuzz::check(triangles == mesh.triangles.size(), "no triangle gets lost");
  });
  if (!blocking_problem(inspection, Purpose::measure)) check_figures(mesh, inspection);
  return 0;
}
