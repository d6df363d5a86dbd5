// Judges a surface of one's own beside that of a method: how flat, how far, how smooth. Here the
// own surface is the design itself, halfway to what `auto` makes of it.
#include <iostream>

#include <planish/planish.h>

using namespace planish;

namespace {

void judge(const char* name, const TriMesh& design, const std::vector<Vec3>& positions) {
  const Patch patch(design);
  const TriMesh surface{positions, design.triangles};
  const Pattern pattern = unfold(Patch(surface), {.least_stretch = true});
  const EdgeStrain strain = edge_strain(Patch(surface), pattern.positions);
  const Deviation deviation = measure_deviation(patch, positions);
  const Fairness fairness = measure_fairness(patch, positions);
  std::cout << name << ": rms strain " << 100.0 * strain.rms << " %, deviation "
            << 100.0 * deviation.rms_over_diagonal << " % of the diagonal, "
            << (fairness.is_smooth() ? "smooth" : "not smooth") << ", "
            << (fairness.keeps_form() ? "form kept" : "form not kept") << "\n";
}

}  // namespace

int main() {
  const TriMesh design = make_shape("panel", 1000);
  const EvolveResult flat = evolve(Patch(design), Auto{}, {.max_sweeps = Auto::usual_sweeps});
  std::vector<Vec3> own = design.positions;
  for (std::size_t v = 0; v < own.size(); ++v)
    own[v] = 0.5 * (own[v] + flat.positions[v]);
  judge("design", design, design.positions);
  judge("own   ", design, own);
  judge("auto  ", design, flat.positions);
}
