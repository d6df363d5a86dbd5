// Ten controllable sweeps of patches from files: bench_patches FILE... Prints rows of a Markdown
// table.

#include <cstdio>
#include <filesystem>

#include <planish/io/read_mesh.h>

#include "support/sweeps.h"

int main(int argc, char** argv) {
  using namespace planish;
  for (int i = 1; i < argc; ++i) {
    const TriMesh mesh = read_mesh(argv[i]).mesh;
    const bench::SweepTimes times = bench::time_sweeps(mesh);
    const auto n = static_cast<double>(mesh.positions.size());
    std::printf("| %s | %.0f | %.4f | %.3f | %.1f | %.2f |\n",
                std::filesystem::path(argv[i]).stem().c_str(), n, times.one_thread,
                1e6 * times.one_thread / n / bench::k_sweeps, times.plain / times.one_thread,
                times.one_thread / times.two_threads);
    std::fflush(stdout);
  }
}
