#include "unfold/disk_images.h"

#include <utility>

#include <planish/mesh/symmetry.h>

#include "unfold/symmetric_mean.h"

namespace planish {

DiskImages images_in(const Patch& patch, const Disk& disk, const std::optional<Plane>& plane) {
  if (!plane) return {};
  const Symmetry symmetry = symmetry_in(patch, *plane);
  if (symmetry.image.empty()) return {};
  std::vector<std::size_t> number(patch.vertex_count(), 0);
  for (std::size_t v = 0; v < disk.vertex_count; ++v)
    number[disk.vertex_of[v]] = v;
  DiskImages images;
  for (const Index v : disk.vertex_of) {
    const Index w = symmetry.image[v];
    const double higher = height_over(symmetry.plane, patch.positions()[v]) -
                          height_over(symmetry.plane, patch.positions()[w]);
    images.of.push_back(number[w]);
    // Both sides of a cut along the plane are at one place.
    const bool is_above = higher > 0.0 || (higher == 0.0 && v < w);
    images.side.push_back(v == w ? 0 : is_above ? 1 : -1);
  }
  return images;
}

std::vector<Vec2> with_images(const Disk& disk, std::vector<Vec2> flat, const DiskImages& images) {
  if (images.of.empty()) return flat;
  std::vector<Vec2> partners;
  partners.reserve(flat.size());
  for (const std::size_t v : images.of)
    partners.push_back(flat[v]);
  const bool is_upright = all_upright(disk, flat);
  for (const int kept : {0, 1, -1}) {
    std::vector<double> shares(flat.size(), 0.5);
    for (std::size_t v = 0; v < shares.size(); ++v)
      shares[v] -= 0.5 * kept * images.side[v];
    std::vector<Vec2> mean = symmetric_mean(flat, partners, shares);
    if (!is_upright || all_upright(disk, mean)) return mean;
  }
  return flat;
}

}  // namespace planish
