// The reader of cuts, and cutting where it says.

#include <algorithm>
#include <cmath>

#include <planish/io/read_features.h>
#include <planish/mesh/cut.h>
#include <planish/mesh/inspect.h>

#include "fuzz/check.h"
#include "support/meshes.h"

using namespace planish;

namespace {

void check_cut(const TriMesh& mesh, const std::vector<CutPath>& paths) {
  const Patch patch(mesh);
  const CutMesh cut = cut_open(patch, paths);
  fuzz::check(cut.mesh.triangles.size() == mesh.triangles.size(), "cutting keeps triangles");
  fuzz::check(cut.source.size() == cut.mesh.positions.size(), "every vertex has a source");
  fuzz::check(std::isfinite(cut.length) && cut.length >= 0.0, "lengths are finite");
  for (std::size_t v = 0; v < cut.source.size(); ++v) {
    fuzz::check(cut.mesh.positions[v] == mesh.positions[cut.source[v]], "positions stay");
    fuzz::check(v >= mesh.positions.size() || cut.source[v] == v, "vertices keep their numbers");
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k)
      fuzz::check(cut.source[cut.mesh.triangles[t][k]] == mesh.triangles[t][k], "corners stay");
  }
  fuzz::check(!blocking_problem(inspect(cut.mesh), Purpose::measure), "what is cut is sound");
  // What was cut and is written down cuts the same again.
  const CutLines again = parse_cuts(format_cuts(cut.paths), mesh, "cuts.txt");
  fuzz::check(cut_open(patch, again.paths).mesh.triangles == cut.mesh.triangles,
              "cuts that are written and read again are the same");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const TriMesh mesh = meshes::flat_grid(5, 4);
  for (const std::string name : {"cuts.txt", "cuts.obj"}) {
    fuzz::allow_refusal_of(name, [&] {
      const CutLines lines = parse_cuts(bytes, mesh, name);
      for (const CutPath& path : lines.paths) {
        for (const Index v : path.vertices)
          fuzz::check(v < mesh.positions.size(), "cuts go through vertices of the mesh");
      }
      check_cut(mesh, lines.paths);
    });
  }
  return 0;
}
