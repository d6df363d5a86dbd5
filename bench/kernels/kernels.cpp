// The parts that a run is made of, each by itself: bench_kernels [Google Benchmark's options].

#include <cmath>
#include <vector>

#include <planish/io/mesh_format.h>
#include <planish/io/read_mesh.h>
#include <planish/io/write_mesh.h>
#include <planish/measure/flattenability.h>
#include <planish/mesh/inspect.h>
#include <planish/mesh/shapes.h>

#include <benchmark/benchmark.h>

#include "evolve/coloring.h"
#include "evolve/spatial_order.h"
#include "measure/lanes/star_defects.h"
#include "support/sweeps.h"

namespace {

using namespace planish;

const TriMesh& panel() {
  static const TriMesh mesh = make_shape("panel", 200'000);
  return mesh;
}

const Connectivity& panel_connectivity() {
  static const Connectivity connectivity(panel());
  return connectivity;
}

void per_vertex(benchmark::State& run) {
  run.SetItemsProcessed(run.iterations() * static_cast<std::int64_t>(panel().positions.size()));
}

void controllable_sweep(benchmark::State& run) {
  ThreadPool pool(1);
  for (auto _ : run) {
    run.PauseTiming();
    PatchState state(panel(), panel_connectivity(), pool);
    ControllableMover mover({}, state, static_cast<Isa>(run.range(0)));
    run.ResumeTiming();
    visit_all(state.plan(), pool,
              [&](std::size_t begin, std::size_t end) { return mover.move(begin, end); });
  }
  per_vertex(run);
  run.SetLabel(std::string(to_string(static_cast<Isa>(run.range(0)))));
}

void plain_sweep(benchmark::State& run) {
  for (auto _ : run) {
    run.PauseTiming();
    plain::Sweeper sweeper(panel().positions, panel_connectivity());
    run.ResumeTiming();
    sweeper.sweep(panel_connectivity().inner_vertices(), {0.0, 1.0}, 1e-17);
  }
  per_vertex(run);
}

void refresh_defects(benchmark::State& run) {
  ThreadPool pool(1);
  PatchState state(panel(), panel_connectivity(), pool);
  for (auto _ : run)
    state.measure(pool);
  per_vertex(run);
}

void library_arctangent(benchmark::State& run) {
  double angle = 0.1;
  for (auto _ : run)
    benchmark::DoNotOptimize(angle = std::atan2(angle, 1.0) + 0.1);
}

void layout(benchmark::State& run) {  // order, rings, colours, sites
  ThreadPool pool(1);
  for (auto _ : run)
    PatchState(panel(), panel_connectivity(), pool);
  per_vertex(run);
}

void order_along_curve(benchmark::State& run) {
  ThreadPool pool(1);
  for (auto _ : run) {
    benchmark::DoNotOptimize(spatial_order(panel().positions, unit_scale(panel()),
                                           panel_connectivity().inner_vertices(), pool));
  }
  per_vertex(run);
}

void connectivity(benchmark::State& run) {
  for (auto _ : run)
    Connectivity(panel()).vertex_count();
  per_vertex(run);
}

void inspection(benchmark::State& run) {
  for (auto _ : run)
    benchmark::DoNotOptimize(inspect(panel()));
  per_vertex(run);
}

void measuring(benchmark::State& run) {
  for (auto _ : run)
    benchmark::DoNotOptimize(measure(panel(), panel_connectivity()));
  per_vertex(run);
}

void reader(benchmark::State& run, MeshFormat format) {
  const std::string bytes = format_mesh(panel(), format);
  for (auto _ : run)
    benchmark::DoNotOptimize(parse_mesh(bytes, format));
  run.SetBytesProcessed(run.iterations() * static_cast<std::int64_t>(bytes.size()));
}

BENCHMARK(plain_sweep)->Unit(benchmark::kMillisecond);
BENCHMARK(controllable_sweep)->Unit(benchmark::kMillisecond)->Apply([](auto* bench) {
  for (const Isa isa : available_isas())
    bench->Arg(static_cast<int>(isa));
});
BENCHMARK(refresh_defects)->Unit(benchmark::kMillisecond);
BENCHMARK(library_arctangent);
BENCHMARK(layout)->Unit(benchmark::kMillisecond);
BENCHMARK(order_along_curve)->Unit(benchmark::kMillisecond);
BENCHMARK(connectivity)->Unit(benchmark::kMillisecond);
BENCHMARK(inspection)->Unit(benchmark::kMillisecond);
BENCHMARK(measuring)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(reader, obj, MeshFormat::obj)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(reader, ply, MeshFormat::ply)->Unit(benchmark::kMillisecond);

}  // namespace
