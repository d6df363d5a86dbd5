#include "mesh/redundant/lying.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <planish/mesh/weld.h>

#include "geometry/box.h"
#include "mesh/mean_edge.h"
#include "mesh/search/closest_point.h"
#include "mesh/split.h"

namespace planish {

namespace {

constexpr std::size_t k_most_pieces = 1000;
constexpr std::size_t k_samples = 64;
// Facets of one surface that are a twentieth of their edges apart turn by 23 degrees.
constexpr double k_share_of_edges = 0.05;
// Normals differ by less than 30 degrees.
constexpr double k_parallel = 0.8660254037844386;

struct Sample {
  Vec3 place, normal;
};

BoxTree::Corners corners_of(const TriMesh& mesh, std::size_t t) {
  const Triangle& corners = mesh.triangles[t];
  return {mesh.positions[corners[0]], mesh.positions[corners[1]], mesh.positions[corners[2]]};
}

/// Of unit length; 0 where the triangle has no area.
Vec3 normal_of(const BoxTree::Corners& corners) {
  const Vec3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double length = norm(normal);
  return length > 0.0 ? 1.0 / length * normal : Vec3{};
}

/// At the middles of some of its triangles that have an area.
std::vector<Sample> samples_of(const TriMesh& mesh) {
  std::vector<Sample> samples;
  const std::size_t count = mesh.triangles.size();
  const std::size_t step = std::max<std::size_t>(1, count / k_samples);
  for (std::size_t t = 0; t < count; t += step) {
    const BoxTree::Corners corners = corners_of(mesh, t);
    const Vec3 normal = normal_of(corners);
    if (normal == Vec3{}) continue;
    samples.push_back({1.0 / 3.0 * (corners[0] + corners[1] + corners[2]), normal});
  }
  return samples;
}

bool is_within(const Box& inner, const Box& outer, double length) {
  const Vec3 low = inner.low - outer.low, high = outer.high - inner.high;
  return std::min({low.x, low.y, low.z, high.x, high.y, high.z}) >= -length;
}

bool lies_at(const Sample& sample, const TriMesh& mesh, const ClosestPoint& closest,
             double length) {
  return closest.squared_distance <= length * length &&
         std::abs(dot(sample.normal, normal_of(corners_of(mesh, closest.triangle)))) >= k_parallel;
}

/// Pieces, each with a tree once something may lie on it.
class Pieces {
 public:
  explicit Pieces(std::vector<NamedPatch> patches)
      : patches_(std::move(patches)), trees_(patches_.size()) {}

  bool lies_on(Index piece, Index other, double length) {
    const TriMesh& mesh = patches_[other].mesh;
    std::optional<ClosestPointTree>& tree = trees_[other];
    if (!tree) tree.emplace(mesh);
    const std::vector<Sample> samples = samples_of(patches_[piece].mesh);
    const auto lies_there = [&](const Sample& sample) {
      return lies_at(sample, mesh, tree->query(sample.place), length);
    };
    return !samples.empty() && std::all_of(samples.begin(), samples.end(), lies_there);
  }

 private:
  std::vector<NamedPatch> patches_;
  std::vector<std::optional<ClosestPointTree>> trees_;
};

/// Two pieces of which one may lie on the other.
struct Candidate {
  Index piece, on;
};

/// Those whose boxes are within each other's, the later piece on the earlier one first.
std::vector<Candidate> candidates(const TriMesh& mesh, std::span<const Index> piece_of,
                                  std::size_t pieces, double length) {
  std::vector<Box> boxes(pieces);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const Vec3& corner : corners_of(mesh, t))
      boxes[piece_of[t]].add(corner);
  }
  std::vector<Candidate> found;
  for (std::size_t p = 0; p < pieces; ++p) {
    for (std::size_t q = 0; q < p; ++q) {
      const auto later = static_cast<Index>(p), earlier = static_cast<Index>(q);
      if (is_within(boxes[p], boxes[q], length)) found.push_back({later, earlier});
      if (is_within(boxes[q], boxes[p], length)) found.push_back({earlier, later});
    }
  }
  return found;
}

}  // namespace

std::vector<LyingPiece> find_lying_pieces(const TriMesh& mesh, std::span<const Index> piece_of,
                                          std::size_t pieces, Lying way) {
  if (pieces < 2 || pieces > k_most_pieces) return {};
  const double scale = unit_scale(mesh);
  TriMesh unit = mesh;
  for (Vec3& p : unit.positions)
    p = scale * p;
  const double least = scale * default_weld_length(mesh);
  const double length =
      way == Lying::closely ? least : std::max(least, k_share_of_edges * mean_edge_length(unit));
  const std::vector<Candidate> pairs = candidates(unit, piece_of, pieces, length);
  if (pairs.empty()) return {};
  const std::vector<std::string> names(pieces);
  Pieces patches(split(unit, piece_of, names));
  std::vector<LyingPiece> lying;
  std::vector<unsigned char> is_lying(pieces, 0);
  for (const auto& [piece, on] : pairs) {
    if (is_lying[piece] != 0 || is_lying[on] != 0) continue;
    if (!patches.lies_on(piece, on, length)) continue;
    if (way == Lying::closely && !patches.lies_on(on, piece, length)) continue;
    is_lying[piece] = 1;
    lying.push_back({piece, on});
  }
  return lying;
}

}  // namespace planish
