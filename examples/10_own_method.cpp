// A method of one's own, compared with two of the library.
#include <iostream>

#include <planish/planish.h>

using namespace planish;

namespace {

/// One sweep: every vertex that may move goes halfway to the mean of its neighbours.
std::vector<Vec3> umbrella(const SweepInput& input) {
  std::vector<Vec3> after = input.positions;
  for (const Index v : input.movable) {
    Vec3 sum;
    for (const Index neighbour : input.design.ring(v))
      sum += input.positions[neighbour];
    const auto count = static_cast<double>(input.design.ring(v).size());
    after[v] = 0.5 * (after[v] + (1.0 / count) * sum);
  }
  return after;
}

}  // namespace

int main() {
  const Patch panel(make_shape("panel", 1000));  // or read_mesh("panel.obj").mesh
  const OwnMethod own{.name = "umbrella", .sweep = umbrella};
  const CompareReport report = compare(
      panel, "panel",
      {{own, usual_stopping(own)}, {ClassicalLaplacian{}, {.max_sweeps = 10}}, {Auto{}, {1000}}});
  for (const ComparedMethod& run : report.runs)
    std::cout << name_of(run.run.method) << ": " << verdict_text(report, run) << "\n";
}
