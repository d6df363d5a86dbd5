// Time per vertex and sweep, and peak memory per vertex, of one size: bench_scaling VERTICES
// [SHAPE]. One process for each size, as the system keeps the peak of a process; bench/run goes
// through the sizes. Prints one row of a Markdown table.

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include <planish/evolve/evolve.h>
#include <planish/mesh/shapes.h>

#include "support/sweeps.h"

namespace {

/// Peak resident memory of this process in bytes, 0 where the system does not say.
double peak_memory() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.rfind("VmHWM:", 0) == 0) return 1024.0 * std::strtod(line.c_str() + 6, nullptr);
  }
  return 0.0;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace planish;
  const auto vertices = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 200'000ULL;
  const double at_rest = peak_memory();
  const TriMesh mesh = make_shape(argc > 2 ? argv[2] : "panel", vertices);
  const auto n = static_cast<double>(mesh.positions.size());
  evolve(Patch(mesh), ControllableLaplacian{}, {.max_sweeps = 1});
  const double bytes = (peak_memory() - at_rest) / n;
  const bench::SweepTimes times = bench::time_sweeps(mesh, vertices > 2'000'000 ? 1 : 5);
  const double each = 1e6 / n / bench::k_sweeps;
  std::printf("| %.0f | %.3f | %.3f | %.3f | %.1f | %.2f | %.0f |\n", n, each * times.plain,
              each * times.one_thread, each * times.two_threads, times.plain / times.one_thread,
              times.one_thread / times.two_threads, bytes);
}
