// The parts that a run is made of, each by itself: bench_kernels [Google Benchmark's options].

#define PLANISH_ISA bench_lanes
#define PLANISH_LANES 2
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include <planish/io/mesh_format.h>
#include <planish/io/read_mesh.h>
#include <planish/measure/flattenability.h>
#include <planish/mesh/imprint.h>
#include <planish/mesh/inspect.h>
#include <planish/mesh/shapes.h>
#include <planish/mesh/surface_line.h>

#include <benchmark/benchmark.h>

#include "core/simd/arctangent.h"
#include "evolve/state/spatial_order.h"
#include "evolve/state/vertex_coloring.h"
#include "geometry/box.h"
#include "support/inner_rings.h"
#include "support/sweeps.h"

namespace {

using namespace planish;

const Patch& panel_patch() {
  static const Patch patch(make_shape("panel", 200'000));
  return patch;
}

const TriMesh& panel() {
  return panel_patch().mesh();
}

void per_vertex(benchmark::State& run) {
  run.SetItemsProcessed(run.iterations() * static_cast<std::int64_t>(panel().positions.size()));
}

void controllable_sweep(benchmark::State& run) {
  ThreadPool pool(1);
  for (auto _ : run) {
    run.PauseTiming();
    PatchState state(panel_patch(), pool);
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
    plain::Sweeper sweeper(panel().positions, panel_patch().connectivity());
    run.ResumeTiming();
    sweeper.sweep(panel_patch().inner_vertices(), {0.0, 1.0}, 1e-17);
  }
  per_vertex(run);
}

void defects_anew(benchmark::State& run) {
  ThreadPool pool(1);
  PatchState state(panel_patch(), pool);
  for (auto _ : run)
    state.measure(pool);
  per_vertex(run);
}

/// The kernel alone: stars of valence 6 that do not see each other, in the first-level cache.
void ring_energy(benchmark::State& run) {
  ThreadPool pool(1);
  const TriMesh mesh = make_shape("panel", 1000);
  const Patch of_mesh(mesh);
  PatchState state(of_mesh, pool);
  const VisitPlan& plan = state.plan();
  const auto found = std::find_if(plan.runs.begin(), plan.runs.end(), [](const Run& r) {
    return r.valence == 6 && r.end - r.begin >= 32;
  });
  std::vector<Star> stars;
  for (std::size_t i = found->begin; i < found->begin + 32; ++i)
    stars.push_back(plan.star(*found, i));
  std::vector<unsigned char> moved(stars.size());
  const std::vector<Site> start(state.sites().begin(), state.sites().end());
  constexpr double inf = std::numeric_limits<double>::infinity();
  const MoveOptions options{0.0, 1.0, inf, inf, nullptr};
  const MoveStars move = move_stars_for(static_cast<Isa>(run.range(0)));
  for (auto _ : run) {
    std::copy(start.begin(), start.end(), state.sites().begin());  // else there is nothing to do
    move(options, state.sites().data(), state.changes(0), stars.data(), stars.size(), 6,
         moved.data());
  }
  run.SetItemsProcessed(run.iterations() * static_cast<std::int64_t>(stars.size()));
  run.SetLabel(std::string(to_string(static_cast<Isa>(run.range(0)))));
}

void library_arctangent(benchmark::State& run) {
  double angle = 0.1;
  for (auto _ : run)
    benchmark::DoNotOptimize(angle = std::atan2(angle, 1.0) + 0.1);
}

/// The least lanes, so that it can be compiled for any processor.
void arctangent_of_two(benchmark::State& run) {
  bench_lanes::Complex z{bench_lanes::broadcast(1.0), bench_lanes::broadcast(0.1)};
  for (auto _ : run)
    benchmark::DoNotOptimize(z.im = bench_lanes::argument(z) + 0.1);
  run.SetItemsProcessed(2 * run.iterations());
}

void coloring(benchmark::State& run) {
  ThreadPool pool(1);
  const meshes::InnerRingsOf rings(panel());
  Pieces all;
  const std::size_t count = rings.view().count();
  all.start = {0, count};
  all.vertices = Buffer<Index>(count);
  all.piece_of = Buffer<Index>(count);
  std::iota(all.vertices.begin(), all.vertices.end(), Index{0});
  std::fill(all.piece_of.begin(), all.piece_of.end(), Index{0});
  for (auto _ : run) {
    Colorer colorer(rings.view());
    benchmark::DoNotOptimize(colorer.color_insides(all, pool));
  }
  per_vertex(run);
}

void layout(benchmark::State& run) {  // order, rings, colours, sites
  ThreadPool pool(1);
  for (auto _ : run)
    PatchState(panel_patch(), pool);
  per_vertex(run);
}

void order_along_curve(benchmark::State& run) {
  ThreadPool pool(1);
  for (auto _ : run) {
    const auto inner = panel_patch().inner_vertices();
    const Box box = bounding_box(panel().positions, inner, pool);
    benchmark::DoNotOptimize(spatial_order(panel().positions, inner, 1.0, box, 0.0, pool));
  }
  per_vertex(run);
}

void connectivity(benchmark::State& run) {
  for (auto _ : run)
    benchmark::DoNotOptimize(Patch(panel()));
  per_vertex(run);
}

void inspection(benchmark::State& run) {
  for (auto _ : run)
    benchmark::DoNotOptimize(inspect(panel()));
  per_vertex(run);
}

void measuring(benchmark::State& run) {
  for (auto _ : run)
    benchmark::DoNotOptimize(measure(panel_patch()));
  per_vertex(run);
}

void reader(benchmark::State& run, MeshFormat format) {
  const std::string bytes = format_mesh(panel(), format);
  for (auto _ : run)
    benchmark::DoNotOptimize(parse_mesh(bytes, format));
  run.SetBytesProcessed(run.iterations() * static_cast<std::int64_t>(bytes.size()));
}

void writer(benchmark::State& run, MeshFormat format) {
  std::size_t bytes = 0;
  for (auto _ : run)
    bytes = format_mesh(panel(), format).size();
  run.SetBytesProcessed(run.iterations() * static_cast<std::int64_t>(bytes));
}

/// Ten planes through 200,000 triangles.
void imprinting(benchmark::State& run) {
  static const Patch patch(make_shape("panel", 100'000));
  constexpr int planes = 10;
  Box box;
  for (const Vec3 p : patch.positions())
    box.add(p);
  std::vector<SurfaceLine> lines;
  for (int k = 0; k < planes; ++k) {
    const Vec3 place = box.low + (0.25 + 0.05 * k) * (box.high - box.low);
    const Vec3 normal = k % 2 == 0 ? Vec3{0.07 * k, 1.0, 0.2} : Vec3{1.0, 0.1 * k, 0.0};
    for (SurfaceLine& line : plane_section(patch, {normal, dot(normal, place)}))
      lines.push_back(std::move(line));
  }
  for (auto _ : run)
    benchmark::DoNotOptimize(imprint(patch, lines));
  run.SetItemsProcessed(run.iterations() * static_cast<std::int64_t>(patch.triangles().size()));
}

BENCHMARK(plain_sweep)->Unit(benchmark::kMillisecond);
BENCHMARK(controllable_sweep)->Unit(benchmark::kMillisecond)->Apply([](auto* bench) {
  for (const Isa isa : available_isas())
    bench->Arg(static_cast<int>(isa));
});
BENCHMARK(defects_anew)->Unit(benchmark::kMillisecond);
BENCHMARK(ring_energy)->Apply([](auto* bench) {
  for (const Isa isa : available_isas())
    bench->Arg(static_cast<int>(isa));
});
BENCHMARK(library_arctangent);
BENCHMARK(arctangent_of_two);
BENCHMARK(coloring)->Unit(benchmark::kMillisecond);
BENCHMARK(layout)->Unit(benchmark::kMillisecond);
BENCHMARK(order_along_curve)->Unit(benchmark::kMillisecond);
BENCHMARK(connectivity)->Unit(benchmark::kMillisecond);
BENCHMARK(inspection)->Unit(benchmark::kMillisecond);
BENCHMARK(measuring)->Unit(benchmark::kMillisecond);
BENCHMARK(imprinting)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(reader, obj, MeshFormat::obj)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(reader, ply, MeshFormat::ply)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(writer, obj, MeshFormat::obj)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(writer, ply, MeshFormat::ply)->Unit(benchmark::kMillisecond);

}  // namespace
