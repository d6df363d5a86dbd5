// Taking vertices out of any patch.

#include "mesh/coarsen/coarsen.h"

#include <algorithm>

#include "fuzz/bytes_to_patch.h"
#include "fuzz/check.h"

using namespace planish;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Bytes bytes(data, size);
  const std::size_t wanted = bytes.whole(0, 80);
  const CoarseBorder border = bytes.flag() ? CoarseBorder::thinned : CoarseBorder::kept;
  const auto mesh = fuzz::patch_from(bytes, Purpose::evolve);
  if (!mesh) return 0;
  const Patch surface(*mesh);
  if (!can_be_coarsened(surface)) return 0;
  std::vector<unsigned char> keep;
  if (bytes.flag()) {
    for (std::size_t v = 0; v < mesh->positions.size(); ++v)
      keep.push_back(bytes.byte() > 200 ? 1 : 0);
  }
  const CoarsePatch coarse = coarsen(surface, wanted, border, keep);
  const Inspection before = inspect(*mesh), after = inspect(coarse.mesh);
  fuzz::check(!blocking_problem(after, Purpose::measure), "a coarse patch is sound");
  fuzz::check(after.topology.euler_characteristic == before.topology.euler_characteristic &&
                  after.topology.border_loops == before.topology.border_loops &&
                  after.topology.components == before.topology.components,
              "topology stays");
  fuzz::check(coarse.source.size() == coarse.mesh.positions.size(), "vertices have sources");
  for (std::size_t v = 0; v < coarse.source.size(); ++v) {
    fuzz::check(coarse.mesh.positions[v] == mesh->positions[coarse.source[v]], "positions stay");
    fuzz::check(v == 0 || coarse.source[v - 1] < coarse.source[v], "vertices keep their order");
  }
  for (Index v = 0; v < mesh->positions.size(); ++v) {
    const bool on_kept_border = border == CoarseBorder::kept && surface.is_border(v);
    const bool asked_for = !keep.empty() && keep[v] != 0 && !surface.ring(v).empty();
    if (on_kept_border || asked_for) {
      fuzz::check(std::binary_search(coarse.source.begin(), coarse.source.end(), v),
                  "vertices that are to be kept are");
    }
  }
  return 0;
}
