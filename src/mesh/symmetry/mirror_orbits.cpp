#include "mesh/symmetry/mirror_orbits.h"

#include <algorithm>
#include <utility>

namespace planish {

namespace {

/// The same triangle, its smallest number first.
Triangle rotated(Triangle t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

/// By vertex the sum over its triangles of the heights of their corners: the sides of a slit along
/// the plane lie on the plane, their triangles do not.
std::vector<double> heights_of_stars(const TriMesh& mesh, const Plane& plane) {
  std::vector<double> heights(mesh.positions.size(), 0.0);
  for (const Triangle& t : mesh.triangles) {
    double height = 0.0;
    for (const Index v : t)
      height += height_over(plane, mesh.positions[v]);
    for (const Index v : t)
      heights[v] += height;
  }
  return heights;
}

bool triangles_have_images(const TriMesh& mesh, const std::vector<Index>& image,
                           const std::vector<unsigned char>& below) {
  std::vector<Triangle> triangles, images;
  for (const Triangle& t : mesh.triangles) {
    std::size_t count_below = 0, count_above = 0;
    for (const Index v : t) {
      if (image[v] != v) ++(below[v] != 0 ? count_below : count_above);
    }
    if ((count_below == 0) == (count_above == 0)) return false;
    triangles.push_back(rotated(t));
    images.push_back(rotated({image[t[0]], image[t[2]], image[t[1]]}));
  }
  std::sort(triangles.begin(), triangles.end());
  std::sort(images.begin(), images.end());
  return triangles == images;
}

}  // namespace

MirrorOrbits::MirrorOrbits(std::vector<Index> image, std::vector<unsigned char> below, Vec3 normal)
    : image_(std::move(image)),
      orbit_of_(image_.size()),
      below_(std::move(below)),
      plane_{normal, 0.0} {
  for (Index v = 0; v < image_.size(); ++v) {
    if (below_[v] != 0) continue;
    orbit_of_[v] = orbit_of_[image_[v]] = static_cast<Index>(first_.size());
    first_.push_back(v);
  }
}

std::size_t MirrorOrbits::count(std::size_t vertices) const {
  if (image_.empty()) return vertices;
  return static_cast<std::size_t>(std::lower_bound(first_.begin(), first_.end(), vertices) -
                                  first_.begin());
}

std::vector<Vec3> MirrorOrbits::symmetric(const std::vector<Vec3>& moves) const {
  if (image_.empty()) return moves;
  std::vector<Vec3> means;
  means.reserve(moves.size());
  for (std::size_t v = 0; v < moves.size(); ++v)
    means.push_back(symmetric_move(moves[v], moves[image_[v]], plane_.normal));
  return means;
}

MirrorOrbits MirrorOrbits::of_part(std::span<const Index> source) const {
  if (image_.empty()) return {};
  std::vector<Index> number(image_.size(), 0), image;
  for (Index k = 0; k < source.size(); ++k)
    number[source[k]] = k;
  std::vector<unsigned char> below;
  for (const Index v : source) {
    image.push_back(number[image_[v]]);
    below.push_back(below_[v]);
  }
  return {std::move(image), std::move(below), plane_.normal};
}

MirrorOrbits mirror_orbits(const TriMesh& mesh, const Symmetry& symmetry) {
  if (symmetry.image.empty()) return {};
  const std::vector<double> heights = heights_of_stars(mesh, symmetry.plane);
  std::vector<unsigned char> below;
  for (Index v = 0; v < mesh.positions.size(); ++v) {
    const Index w = symmetry.image[v];
    if (w != v && heights[v] == heights[w]) return {};
    below.push_back(w != v && heights[v] < heights[w] ? 1 : 0);
  }
  if (!triangles_have_images(mesh, symmetry.image, below)) return {};
  return {symmetry.image, std::move(below), symmetry.plane.normal};
}

Vec3 symmetric_move(Vec3 own, Vec3 other, Vec3 normal) {
  return 0.5 * (own + mirrored(Plane{normal, 0.0}, other));
}

}  // namespace planish
