// Looks at a patch after every sweep, as a view that is drawn anew would, and ends early.
#include <iostream>

#include <planish/planish.h>

int main() {
  using namespace planish;
  const TriMesh mesh = make_shape("saddle", 2000);
  const Patch surface(mesh);
  Evolver evolver(surface, ControllableLaplacian{});
  for (int frame = 0; frame < 20; ++frame) {
    const SweepRecord record = evolver.step();
    const TriMesh shown{evolver.positions(), mesh.triangles};  // for the view
    std::cout << "sweep " << record.sweep << ": energy " << record.energy << ", " << record.moved
              << " of " << shown.positions.size() << " vertices moved\n";
    const bool is_cancelled = record.sweep == 5;  // as a button would say
    if (is_cancelled || record.status != SweepStatus::running) break;
  }
  evolver.prolong_to_finest();  // what methods on coarse levels have found so far
}
