#include "product/twins.h"

#include <utility>

#include <planish/mesh/patch.h>

namespace planish::cli {

ProductTwins twins_among(const std::vector<ProductPatch>& patches,
                         const std::function<bool()>& stopped) {
  std::vector<const TriMesh*> meshes;
  meshes.reserve(patches.size());
  for (const ProductPatch& patch : patches)
    meshes.push_back(&patch.mesh);
  return find_twins(meshes, k_twin_tolerance, stopped);
}

PatternOptions annotations_of_twin(PatternOptions own, const TriMesh& of, const MeshMatch& match) {
  if (match.mirrored) own = for_mirror_image(std::move(own));
  // Where piece_outline() begins.
  const Index first = Patch(of).border_loops().front().front();
  own.like = DrawnLike{match.mirrored, match.vertex[first]};
  return own;
}

std::vector<TwinGroup> groups_of(const std::vector<std::size_t>& numbers,
                                 const ProductTwins& twins) {
  std::vector<unsigned char> there(twins.size(), 0);
  for (const std::size_t p : numbers)
    there[p] = 1;
  const auto has_other = [&](std::size_t p) { return twins[p] && there[twins[p]->of] != 0; };
  std::vector<std::size_t> place(twins.size(), 0);  // of the group that a patch is the first of
  std::vector<TwinGroup> groups;
  for (const std::size_t p : numbers) {
    if (has_other(p)) continue;
    place[p] = groups.size();
    groups.push_back({p});
  }
  for (const std::size_t p : numbers) {
    if (has_other(p)) groups[place[twins[p]->of]].push_back(p);
  }
  return groups;
}

}  // namespace planish::cli
