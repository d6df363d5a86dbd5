// Makes a patch more flattenable and writes it.
#include <iostream>

#include <planish/evolve/evolve.h>
#include <planish/io/mesh_format.h>
#include <planish/mesh/shapes.h>

int main() {
  const planish::Patch patch(planish::make_shape("panel", 2000));

  const planish::EvolveResult result =
      planish::evolve(patch, planish::ControllableLaplacian{.lambda_max = 0.9}, {.max_sweeps = 20});

  for (const planish::SweepRecord& sweep : result.history) {
    std::cout << "sweep " << sweep.sweep << ": e_max " << sweep.e_max << ", energy " << sweep.energy
              << "\n";
  }
  planish::write_mesh("evolved_panel.ply", patch.with_positions(result.positions).mesh());
}
