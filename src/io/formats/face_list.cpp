#include "io/formats/face_list.h"

#include <algorithm>

namespace planish {

bool has_repeat(std::span<const Index> corners) {
  constexpr std::size_t k_few = 8;
  if (corners.size() > k_few) {
    std::vector<Index> sorted(corners.begin(), corners.end());
    std::sort(sorted.begin(), sorted.end());
    return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
  }
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const auto before = corners.first(i);
    if (std::find(before.begin(), before.end(), corners[i]) != before.end()) return true;
  }
  return false;
}

void FaceList::add_fan(std::span<const Index> corners) {
  for (std::size_t i = 2; i < corners.size(); ++i) {
    triangles_.push_back({corners[0], corners[i - 1], corners[i]});
  }
  ++polygons_;
  fan_triangles_ += corners.size() - 2;
}

std::string FaceList::note() const {
  if (polygons_ == 0) return {};
  return "split " + std::to_string(polygons_) + (polygons_ == 1 ? " polygon" : " polygons") +
         " into " + std::to_string(fan_triangles_) + " triangles";
}

}  // namespace planish
