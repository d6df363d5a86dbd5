// Ten controllable sweeps of a small patch with the instructions that valgrind knows, for
// bench/check_instructions to count.

#include <cstdio>

#include <planish/mesh/shapes.h>

#include "evolve/methods/controllable_laplacian.h"
#include "evolve/state/sweep.h"

int main() {
  using namespace planish;
  const TriMesh mesh = make_shape("panel", 5000);
  const Patch surface(mesh);
  ThreadPool pool(1);
  PatchState state(surface, pool);
  ControllableMover mover({}, state, Isa::x86_64_v3);
  std::size_t moved = 0;
  for (int sweep = 0; sweep < 10; ++sweep) {
    moved += visit_all(state.plan(), pool,
                       [&](std::size_t begin, std::size_t end) { return mover.move(begin, end); });
    state.measure(pool);
  }
  std::printf("%zu moves\n", moved);
}
