#include "io/formats/face_list.h"

#include <algorithm>
#include <array>

#include "mesh/polygon/divide_polygon.h"

namespace planish {

bool has_repeat(std::span<const Index> corners) {
  if (corners.size() <= 8) {
    for (std::size_t i = 1; i < corners.size(); ++i) {
      const auto before = corners.first(i);
      if (std::find(before.begin(), before.end(), corners[i]) != before.end()) return true;
    }
    return false;
  }
  std::vector<Index> sorted(corners.begin(), corners.end());
  std::sort(sorted.begin(), sorted.end());
  return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
}

std::vector<std::string> FaceList::notes() const {
  std::vector<std::string> notes;
  if (dropped_ > 0) {
    notes.push_back("dropped " + std::to_string(dropped_) +
                    (dropped_ == 1 ? " corner" : " corners") + " that a face names twice in a row");
  }
  std::size_t triangles = 0;
  for (const Polygon& polygon : polygons_)
    triangles += polygon.corner_count - 2;
  if (triangles > 0) {
    notes.push_back("split " + std::to_string(polygons_.size()) +
                    (polygons_.size() == 1 ? " polygon" : " polygons") + " into " +
                    std::to_string(triangles) + " triangles");
  }
  return notes;
}

bool FaceList::repeats_in_a_row(std::span<const Index> corners) {
  Index before = corners.back();
  for (const Index corner : corners) {
    if (corner == before) return true;
    before = corner;
  }
  return false;
}

std::span<const Index> FaceList::without_repeats(std::span<const Index> corners) {
  kept_.assign(corners.begin(), corners.end());
  kept_.erase(std::unique(kept_.begin(), kept_.end()), kept_.end());
  while (kept_.size() > 1 && kept_.front() == kept_.back())
    kept_.pop_back();
  dropped_ += corners.size() - kept_.size();
  while (kept_.size() < 3)
    kept_.push_back(kept_.back());
  return kept_;
}

void FaceList::add_fan(std::span<const Index> corners) {
  for (std::size_t i = 2; i < corners.size(); ++i) {
    triangles_.push_back({corners[0], corners[i - 1], corners[i]});
  }
}

std::vector<Index> FaceList::corners_of(const Polygon& polygon) const {
  std::vector<Index> corners = {triangles_[polygon.first][0], triangles_[polygon.first][1]};
  for (std::size_t k = 0; k + 2 < polygon.corner_count; ++k)
    corners.push_back(triangles_[polygon.first + k][2]);
  return corners;
}

bool FaceList::divide(const Polygon& polygon, std::span<const Vec3> positions) {
  const auto first = triangles_.begin() + static_cast<std::ptrdiff_t>(polygon.first);
  if (polygon.corner_count == 4) {
    const std::array quad = {first[0][0], first[0][1], first[0][2], first[1][2]};
    if (has_repeat(quad)) return false;
    const auto halves = divide_quad(quad, positions);
    if (halves) std::copy(halves->begin(), halves->end(), first);
    return halves.has_value();
  }
  const auto triangles = divide_polygon(corners_of(polygon), positions);
  if (triangles) std::copy(triangles->begin(), triangles->end(), first);
  return triangles.has_value();
}

std::string FaceList::refusal(const Polygon& polygon) const {
  const bool repeats = has_repeat(corners_of(polygon));
  return "a face of " + std::to_string(polygon.corner_count) + " corners crosses itself" +
         (repeats ? ", or names a vertex twice where no line leads to a hole and back" : "") +
         "; divide it into triangles in the program that made the file";
}

}  // namespace planish
