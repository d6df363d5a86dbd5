#include "flatten/product/twin_groups.h"

namespace planish {

std::vector<TwinGroup> groups_of(std::span<const std::size_t> numbers,
                                 std::span<const std::optional<MeshTwin>> twins) {
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

}  // namespace planish
