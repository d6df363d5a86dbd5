#include <planish/core/error.h>

#include "evolve/state/sweep.h"

// Stubs for methods that the page never uses. It is linked with these instead of their sources, so
// that it stays small.

namespace planish {

namespace {

[[noreturn]] Sweep refuse() {
  throw Error(ErrorCode::option_out_of_range, "this method is in the program alone");
}

}  // namespace

Sweep make_sweep(const BilaplacianFairing&, PatchState&, ThreadPool&) {
  refuse();
}
Sweep make_sweep(const ClassicalLaplacian&, PatchState&, ThreadPool&) {
  refuse();
}
Sweep make_sweep(const FlattenableLaplacian&, PatchState&, ThreadPool&) {
  refuse();
}
Sweep make_sweep(const LeastNorm&, PatchState&, ThreadPool&) {
  refuse();
}
Sweep make_sweep(const LocalOffset&, PatchState&, ThreadPool&) {
  refuse();
}
Sweep make_sweep(const GlobalPenalty&, PatchState&, ThreadPool&) {
  refuse();
}
Sweep make_sweep(const LocalPerturbation&, PatchState&, ThreadPool&) {
  refuse();
}

}  // namespace planish
