// The readers of fixed vertices and weights.

#include <algorithm>
#include <cmath>

#include <planish/io/read_features.h>

#include "fuzz/check.h"
#include "support/meshes.h"

using namespace planish;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const TriMesh mesh = meshes::flat_grid(4, 3);
  const std::size_t vertices = mesh.positions.size();
  for (const std::string name : {"fixed.txt", "fixed.obj"}) {
    fuzz::allow_refusal_of(name, [&] {
      const FixedVertices fixed = parse_fixed_vertices(bytes, Patch(mesh), name);
      const auto& all = fixed.vertices;
      fuzz::check(std::adjacent_find(all.begin(), all.end(), std::greater_equal<>()) == all.end(),
                  "fixed vertices come in increasing order, each once");
      fuzz::check(all.empty() || all.back() < vertices, "fixed vertices are of the mesh");
      fuzz::check(fixed.farthest >= 0.0 && std::isfinite(fixed.farthest), "distances are finite");
    });
  }
  fuzz::allow_refusal_of("weights", [&] {
    const std::vector<double> weights = weights_in(parse_rows(bytes, "weights"), vertices);
    fuzz::check(weights.size() == vertices, "every vertex has a weight");
    for (const double weight : weights)
      fuzz::check(weight > 0.0 && std::isfinite(weight), "weights are above 0");
  });
  return 0;
}
