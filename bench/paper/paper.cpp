// Table 1 of Lin, Zhang, Wang, Gao 2010 on patches of our own of the same sizes: ten controllable
// sweeps each. bench_paper [FOLDER OF PATCHES] [REPORT.json]; Markdown goes to standard output.

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include <planish/evolve/evolve.h>
#include <planish/io/read_mesh.h>
#include <planish/measure/flattenability.h>
#include <planish/mesh/shapes.h>

#include <nlohmann/json.hpp>

#include "support/sweeps.h"

namespace {

using namespace planish;

/// A row as printed, and the patch that stands for its model.
struct Row {
  const char* figure;
  std::size_t vertices;
  double e_max_before, e_avg_before, e_max_after, e_avg_after;
  int sweeps;
  double seconds;
  const char* patch;
};

constexpr Row k_rows[] = {
    {"Fig. 7(a,b)", 4234, 0.3212, 0.0055, 0.0999, 0.0020, 10, 28, "gc_front_4k.obj"},
    {"Fig. 7(c,d)", 5088, 0.6319, 0.0018, 0.0231, 0.0010, 10, 44, "boat_hull_5k.obj"},
    {"Fig. 8(a,b)", 12859, 0.0241, 0.00019, 0.0036, 0.00016, 4, 4, "mhf_seat_13k.obj"},
    {"Fig. 8(c,d)", 59513, 0.3490, 0.00020, 0.0756, 0.00017, 10, 97, "mhf_sleeve_60k.ply"},
    {"Fig. 9(a,b)", 195093, 0.6988, 0.00004, 0.0228, 0.00003, 10, 159, "mhf_back_195k.ply"},
};

TriMesh load(const Row& row, const std::filesystem::path& folder) {
  const auto path = folder / row.patch;
  if (!folder.empty() && std::filesystem::exists(path)) return read_mesh(path.string()).mesh;
  return make_shape("panel", row.vertices);
}

}  // namespace

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : "";
  nlohmann::json rows = nlohmann::json::array();
  std::puts(
      "| patch | vertices | e_max | e_avg | sweeps | s, 1 thread | us per vertex and sweep | plain "
      "/ 1 thread | 1 / 2 threads | the paper's row |\n|---|---|---|---|---|---|---|---|---|---|");
  for (const Row& row : k_rows) {
    const TriMesh mesh = load(row, folder);
    const EvolveResult result = evolve(mesh, ControllableLaplacian{});
    const Flattenability before = measure(mesh, Connectivity(mesh));
    const SweepRecord& after = result.history.back();
    const bench::SweepTimes times = bench::time_sweeps(mesh);
    const auto n = static_cast<double>(mesh.positions.size());
    const double each = 1e6 * times.one_thread / n / bench::k_sweeps;
    std::printf(
        "| %s | %zu | %.4f -> %.4f | %.6f -> %.6f | %d | %.4f | %.3f | %.1f | %.2f | %s: %zu "
        "vertices, e_max %.4f -> %.4f, e_avg %.5f -> %.5f, %d sweeps, %g s |\n",
        row.patch, mesh.positions.size(), before.e_max, after.e_max, before.e_avg, after.e_avg,
        after.sweep, times.one_thread, each, times.plain / times.one_thread,
        times.one_thread / times.two_threads, row.figure, row.vertices, row.e_max_before,
        row.e_max_after, row.e_avg_before, row.e_avg_after, row.sweeps, row.seconds);
    std::fflush(stdout);
    rows.push_back({{"patch", row.patch},
                    {"vertices", mesh.positions.size()},
                    {"e_max_before", before.e_max},
                    {"e_max_after", after.e_max},
                    {"e_avg_before", before.e_avg},
                    {"e_avg_after", after.e_avg},
                    {"sweeps", after.sweep},
                    {"seconds_plain", times.plain},
                    {"seconds_1_thread", times.one_thread},
                    {"seconds_2_threads", times.two_threads},
                    {"paper",
                     {{"figure", row.figure},
                      {"vertices", row.vertices},
                      {"e_max_before", row.e_max_before},
                      {"e_max_after", row.e_max_after},
                      {"e_avg_before", row.e_avg_before},
                      {"e_avg_after", row.e_avg_after},
                      {"sweeps", row.sweeps},
                      {"seconds", row.seconds}}}});
  }
  if (argc > 2) std::ofstream(argv[2]) << rows.dump(2) << "\n";
}
