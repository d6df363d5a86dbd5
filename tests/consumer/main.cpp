#include <iostream>

#include <planish/core/version.h>
#include <planish/evolve/evolve.h>
#include <planish/mesh/shapes.h>

int main() {
  const planish::TriMesh mesh = planish::make_shape("panel", 400);
  const planish::EvolveResult result = planish::evolve(planish::Patch(mesh), {}, {.max_sweeps = 3});
  std::cout << "planish " << planish::k_version << ": " << result.history.size() << " sweeps, "
            << "energy " << result.history.back().energy << "\n";
}
