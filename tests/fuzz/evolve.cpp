// Controllable Laplacian evolution: energy never rises.

#include "fuzz/bytes_to_patch.h"
#include "fuzz/check_evolution.h"
#include "fuzz/fill_options.h"

using namespace planish;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Bytes bytes(data, size);
  ControllableLaplacian options;
  describe(options, fuzz::OptionFiller{bytes});
  const Stopping stopping{.max_sweeps = static_cast<int>(bytes.whole(0, 12))};
  const auto threads = static_cast<unsigned>(bytes.byte() == 0 ? 2 : 1);
  const auto mesh = fuzz::patch_from(bytes, Purpose::evolve);
  if (!mesh) return 0;
  const Constraints constraints = fuzz::fixed_vertices_from(bytes, *mesh);

  const double before = measure(Patch(*mesh)).energy;
  // Below that share of the patch's size, squares of areas are less than doubles hold.
  const bool is_exact = !fuzz::has_edges_below(1e-70, *mesh);
  const EvolveResult result =
      evolve(Patch(*mesh), options, stopping, constraints, {.threads = threads});
  double energy = before;
  for (const SweepRecord& record : result.history) {
    fuzz::check(!is_exact || record.energy <= energy, "energy never rises");
    energy = record.energy;
  }
  fuzz::check_evolution(*mesh, result, constraints, true);
  fuzz::check_deviation(*mesh, result, options.max_deviation);
  const TriMesh evolved{result.positions, mesh->triangles};
  fuzz::check(!blocking_problem(inspect(evolved), Purpose::evolve),
              "a patch can be evolved further");
  return 0;
}
