// auto beside least_norm at the bending of least_norm: bench_least_norm FILE... Prints a Markdown
// table and geometric means. For each patch least_norm (cotangent update, 150 sweeps) gives a
// bending and a deviation. Of the runs of auto whose surface is bent no more, the nearest counts:
// strict are those that end with e_max <= 1e-4, the others those with at most 0.1 % of rms strain
// in their pattern.

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <optional>
#include <vector>

#include <planish/evolve/evolve.h>
#include <planish/io/read_mesh.h>
#include <planish/measure/deviation.h>
#include <planish/measure/fairness.h>
#include <planish/measure/flattenability.h>
#include <planish/unfold/strain.h>
#include <planish/unfold/unfold.h>

namespace planish {
namespace {

constexpr double k_as_bent = 1.02;  // a surface with so many times the bending is bent no more
constexpr double k_strict = 1e-4;   // of e_max, radians
constexpr double k_nearly = 0.001;  // of the rms strain

/// Where a run ended.
struct End {
  double bending = 0.0;    ///< over that of the design
  double deviation = 0.0;  ///< rms of moves over the diagonal
  double there =
      0.0;            ///< rms distance of its vertices from the design's surface, over the diagonal
  double back = 0.0;  ///< of the design's vertices from its surface
  double e_max = 0.0;
  double strain = 0.0;  ///< rms, of the pattern

  bool is_strict() const { return e_max <= k_strict; }
  bool is_nearly_flat() const { return strain <= k_nearly || is_strict(); }
};

End run(const Patch& design, const Method& method, int sweeps) {
  const EvolveResult result = evolve(design, method, {.max_sweeps = sweeps});
  const Patch after = design.with_positions(result.positions);
  const Fairness fairness = measure_fairness(design, after);
  return {fairness.bending_ratio.value_or(std::numeric_limits<double>::infinity()),
          measure_deviation(design, result.positions).rms_over_diagonal,
          measure_surface_deviation(after, design.mesh()).rms_over_diagonal,
          measure_surface_deviation(design, after.mesh()).rms_over_diagonal,
          measure(after).e_max,
          edge_strain(after, unfold(after).positions).rms};
}

/// @param bending of least_norm, over the design's
std::vector<Auto> runs_of_auto(double bending) {
  std::vector<Auto> runs = {{.prefer = Prefer::flat},
                            {.prefer = Prefer::smooth},
                            {.max_bending = bending, .prefer = Prefer::flat},
                            {.max_bending = bending, .prefer = Prefer::smooth}};
  for (const double closeness : {0.0, 0.1, 0.25, 0.5, 1.0}) {
    runs.push_back({.closeness = closeness, .prefer = Prefer::near});
    runs.push_back({.limits = {.rms = k_nearly}, .closeness = closeness, .prefer = Prefer::near});
  }
  return runs;
}

template <class Counts>
std::optional<End> nearest(const std::vector<End>& ends, double bending, Counts counts) {
  std::optional<End> best;
  for (const End& end : ends) {
    if (end.bending > k_as_bent * bending || !counts(end)) continue;
    if (!best || end.deviation < best->deviation) best = end;
  }
  return best;
}

/// Of numbers above 0.
class GeometricMean {
 public:
  void add(double x) {
    logs_ += std::log(x);
    ++count_;
  }
  double value() const { return std::exp(logs_ / count_); }
  int count() const { return count_; }

 private:
  double logs_ = 0.0;
  int count_ = 0;
};

void print_end(const std::optional<End>& end, const End& beside, GeometricMean& mean) {
  if (!end) {
    std::printf(" | – | |");
    return;
  }
  mean.add(end->deviation / beside.deviation);
  std::printf(" | %.2f | %.2f | %.2f, %.2f", end->bending, end->deviation / beside.deviation,
              end->there / beside.there, end->back / beside.back);
}

}  // namespace
}  // namespace planish

int main(int argc, char** argv) {
  using namespace planish;
  std::printf(
      "| patch | least_norm: bending | deviation, %% | nearest points, there and back, %% "
      "| strict: bending | deviation | nearest points "
      "| 0.1 %%: bending | deviation | nearest points |\n"
      "|---|---|---|---|---|---|---|---|---|---|\n");
  GeometricMean strict, nearly;
  for (int i = 1; i < argc; ++i) {
    const Patch design(read_mesh(argv[i]).mesh);
    const End least_norm = run(design, LeastNorm{}, 150);
    std::vector<End> ends;
    for (const Auto& method : runs_of_auto(least_norm.bending))
      ends.push_back(run(design, method, Auto::usual_sweeps));
    std::printf("| %s | %.2f | %.2f | %.2f, %.2f", std::filesystem::path(argv[i]).stem().c_str(),
                least_norm.bending, 100.0 * least_norm.deviation, 100.0 * least_norm.there,
                100.0 * least_norm.back);
    print_end(nearest(ends, least_norm.bending, [](const End& end) { return end.is_strict(); }),
              least_norm, strict);
    print_end(
        nearest(ends, least_norm.bending, [](const End& end) { return end.is_nearly_flat(); }),
        least_norm, nearly);
    std::printf(" |\n");
    std::fflush(stdout);
  }
  std::printf(
      "\nGeometric means of the deviation over that of least_norm: strict %.3f (%d patches), "
      "0.1 %% %.3f (%d patches)\n",
      strict.value(), strict.count(), nearly.value(), nearly.count());
}
