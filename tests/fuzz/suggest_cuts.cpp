// Looking for cuts in any mesh that can be measured, closed ones among them.

#include <cmath>

#include <planish/unfold/suggest_cuts.h>

#include "fuzz/bytes_to_patch.h"
#include "fuzz/check.h"

using namespace planish;

namespace {

/// A fan closed by a second one below it.
TriMesh spindle_from(fuzz::Bytes& bytes) {
  TriMesh mesh = fuzz::fan_from(bytes);
  const auto bottom = static_cast<Index>(mesh.positions.size());
  for (std::size_t t = mesh.triangles.size(); t-- > 0;) {
    const Triangle& top = mesh.triangles[t];
    mesh.triangles.push_back({bottom, top[2], top[1]});
  }
  mesh.positions[0].z = 1.0 + bytes.fraction();
  mesh.positions.push_back({0.0, 0.0, -1.0 + 0.5 * bytes.fraction()});
  return mesh;
}

void check_suggestion(const TriMesh& mesh, const CutSuggestion& suggestion) {
  for (const SuggestedCut& cut : suggestion.cuts) {
    fuzz::check(cut.path.size() >= 2 && std::isfinite(cut.length), "cuts have two ends");
    for (const Index v : cut.path)
      fuzz::check(v < mesh.positions.size(), "cuts go through vertices of the mesh");
  }
  const TriMesh& cut = suggestion.last.cut.mesh;
  fuzz::check(!blocking_problem(inspect(cut), Purpose::unfold), "what is cut is a disk");
  for (const Vec2 p : suggestion.last.pattern.positions)
    fuzz::check(fuzz::is_finite(p), "patterns are finite");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Bytes bytes(data, size);
  const SuggestOptions options{.limits = {.max = 0.001 + 0.1 * (1.0 + bytes.fraction())},
                               .max_darts = static_cast<int>(bytes.whole(0, 2)),
                               .trial_vertices = bytes.whole(10, 100)};
  const TriMesh mesh = bytes.whole(0, 3) == 0 ? spindle_from(bytes) : fuzz::mesh_from(bytes);
  if (blocking_problem(inspect(mesh), Purpose::measure)) return 0;
  fuzz::allow_refusal([&] {
    const auto suggestion = suggest_cuts(Patch(mesh), options);
    check_suggestion(mesh, suggestion);
  });
  return 0;
}
