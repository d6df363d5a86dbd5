#include "unfold/cuts/crease_cuts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include <planish/measure/flattenability.h>
#include <planish/mesh/cut.h>

#include "geometry/angle_between.h"
#include "geometry/dihedral_angle.h"
#include "mesh/edges.h"

namespace planish {

namespace {

constexpr double k_sharp = 40.0 * std::numbers::pi / 180.0;     // between normals
constexpr double k_straight = 10.0 * std::numbers::pi / 180.0;  // a part of a crease turns less
constexpr double k_small = 0.01;                                // of the area: no face
constexpr std::size_t k_most_faces = 200;
constexpr double k_least_share = 0.5;  // of the angle defects, that lies on creases

Chains sharp_edges(const Patch& patch) {
  const auto at = [&](Index v) { return patch.unit_scale() * patch.positions()[v]; };
  Chains edges;
  for_each_edge(patch.connectivity(), [&](const Edge& edge) {
    if (edge.is_border()) return;
    const double angle = dihedral_angle(at(edge.from), at(edge.to), at(edge.left), at(edge.right));
    if (angle >= k_sharp) edges.push_back({edge.from, edge.to});
  });
  return edges;
}

/// Leaves out the creases around faces that are too small.
Chains around_large_faces(const Patch& patch, Chains chains, Regions& regions) {
  double all = 0.0;
  std::vector<Index> seen;
  for (const auto& chain : chains) {
    const Regions::Sides sides = regions.sides(chain);
    seen.insert(seen.end(), {sides.left, sides.right});
  }
  std::sort(seen.begin(), seen.end());
  seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
  for (const Index region : seen)
    all += regions.area(region);
  for (bool is_joined = true; is_joined;) {
    is_joined = false;
    for (const auto& chain : chains) {
      const Regions::Sides sides = regions.sides(chain);
      const double least = std::min(regions.area(sides.left), regions.area(sides.right));
      if (sides.left == sides.right || least >= k_small * all) continue;
      regions.join(sides);
      is_joined = true;
    }
  }
  std::erase_if(chains, [&](const auto& chain) {
    const Regions::Sides sides = regions.sides(chain);
    return sides.left == sides.right;
  });
  return without_loose(patch, std::move(chains));
}

/// Of the sizes of all angle defects, what lies on the chains.
double share_of_defects(const Patch& patch, const Chains& chains) {
  std::vector<unsigned char> is_on(patch.vertex_count(), 0);
  for (const auto& chain : chains) {
    for (const Index v : chain)
      is_on[v] = 1;
  }
  const std::vector<double> defects = angle_defects(patch);
  double here = 0.0, all = 0.0;
  for (std::size_t v = 0; v < defects.size(); ++v) {
    all += std::abs(defects[v]);
    if (is_on[v] != 0) here += std::abs(defects[v]);
  }
  return all > 0.0 ? here / all : 0.0;
}

/// The parts of chains between places where they turn, the longest first.
Chains straight_parts(const Patch& patch, const Chains& chains) {
  Chains parts;
  for (const std::vector<Index>& chain : chains) {
    const auto step = [&](std::size_t i) {
      return patch.unit_scale() * patch.positions()[chain[i + 1]] -
             patch.unit_scale() * patch.positions()[chain[i]];
    };
    std::size_t begin = 0;
    parts.push_back({chain.front()});
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      if (angle_between(step(begin), step(i)) > k_straight) {
        parts.push_back({chain[i]});
        begin = i;
      }
      parts.back().push_back(chain[i + 1]);
    }
  }
  std::stable_sort(parts.begin(), parts.end(), [&](const auto& a, const auto& b) {
    return path_length(a, patch.positions()) > path_length(b, patch.positions());
  });
  return parts;
}

}  // namespace

Chains crease_cuts(const Patch& patch, double least_hinge) {
  Chains chains = without_loose(patch, inner_chains(patch, sharp_edges(patch)));
  if (share_of_defects(patch, chains) < k_least_share) return {};
  Regions regions(patch, chains);
  chains = around_large_faces(patch, std::move(chains), regions);
  if (chains.empty() || regions.count() > k_most_faces) return {};
  Chains parts = straight_parts(patch, chains);
  std::erase_if(parts, [&](const auto& part) {
    const Regions::Sides sides = regions.sides(part);
    if (sides.left == sides.right) return false;
    const double area = std::min(regions.area(sides.left), regions.area(sides.right));
    const double length = patch.unit_scale() * path_length(part, patch.positions());
    if (length < least_hinge * std::sqrt(area)) return false;
    regions.join(sides);
    return true;
  });
  return parts;
}

}  // namespace planish
