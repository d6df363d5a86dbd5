// A jacket: all of its pieces flattened in one run, its seams measured, and its pieces laid on a
// roll of cloth. Here they are samples: two fronts, mirror images that meet at x = 0, and a back.
#include <array>
#include <iostream>
#include <utility>

#include <planish/planish.h>

int main() {
  using namespace planish;
  TriMesh left = make_shape("saddle", 600);
  for (Vec3& p : left.positions)
    p.x += 150.0;  // from its middle to its border
  TriMesh right = left;
  for (Vec3& p : right.positions)
    p.x = 0.0 - p.x;
  for (Triangle& t : right.triangles)
    std::swap(t[1], t[2]);
  const std::array patches = {ProductPatch{"left", left}, ProductPatch{"right", right},
                              ProductPatch{"back", make_shape("panel", 600)}};
  const ProductReport jacket = flatten_product(patches);
  for (const PatchResult& patch : jacket.patches) {
    if (patch.failure) std::cout << patch.name << " failed: " << patch.failure->message << "\n";
    if (!patch.finished) continue;
    std::cout << patch.name << ": strain " << 100.0 * patch.finished->unfold.strain.rms << " %\n";
  }
  for (const MeasuredSeam& seam : jacket.seams)
    std::cout << "a seam of " << seam.on_model[0] << " mm, in the patterns " << *seam.in_pattern[0]
              << " and " << *seam.in_pattern[1] << " mm\n";

  const PatternOptions annotations{.allowance = Allowance{.width = 10.0}};
  const NestJob job{patches_to_cut(patches, jacket, {3, annotations}), jacket.unit, {}};
  const auto nesting = nest(nest_pieces(job), job.sheets);
  write_files(std::array{OutputFile{"jacket.dxf", format_dxf(nest_sheet(job, nesting, 0, ""))}});
  std::cout << nesting.used_length << " mm of the roll, written to jacket.dxf\n";
}
