#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include <planish/core/error.h>
#include <planish/sheet/nest_sheet.h>

namespace planish {

namespace {

/// How many of a patch are cut as they are drawn, and how many as mirror images.
struct Copies {
  int drawn = 0, mirrored = 0;
};

Copies copies_of(const PieceLabel& label) {
  const int all = std::max(1, label.quantity), mirrored = std::min(label.mirrored, all);
  return {all - mirrored, mirrored};
}

}  // namespace

DoubleCloth on_double_cloth(std::vector<NestPatch> patches) {
  std::vector<Copies> copies;
  copies.reserve(patches.size());
  for (const NestPatch& patch : patches)
    copies.push_back(copies_of(patch.annotations.label));
  DoubleCloth cloth;
  std::vector<bool> is_laid(patches.size(), true);
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const auto of = patches[p].mirror_image_of;
    if (!of || patches[p].pattern.empty() || patches[*of].pattern.empty() || !is_laid[*of])
      continue;
    copies[*of].mirrored += copies[p].drawn;
    copies[*of].drawn += copies[p].mirrored;
    is_laid[p] = false;
  }
  for (std::size_t p = 0; p < patches.size(); ++p) {
    if (!is_laid[p]) continue;
    NestPatch& patch = patches[p];
    PieceLabel& label = patch.annotations.label;
    label.mirrored = 0;
    if (!patch.annotations.is_half()) {
      const auto [drawn, mirrored] = copies[p];
      label.quantity = std::max(drawn, mirrored);
      if (drawn != mirrored) cloth.single.push_back({patch.name, std::abs(drawn - mirrored)});
    }
    cloth.patches.push_back(std::move(patch));
  }
  return cloth;
}

}  // namespace planish
