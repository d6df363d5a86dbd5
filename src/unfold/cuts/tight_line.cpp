#include "unfold/cuts/tight_line.h"

#include <algorithm>
#include <cstddef>

#include <planish/mesh/geodesic.h>

namespace planish {

namespace {

constexpr std::size_t k_shortest = 8;  // vertices of a part that is drawn tight by itself

double weight_at(const SurfacePoint& place, std::span<const double> weights) {
  double weight = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
    weight += place.shares[k] * weights[place.corners[k]];
  return weight;
}

double weighed_length(const Patch& patch, const SurfaceLine& line,
                      std::span<const double> weights) {
  double length = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double mean = 0.5 * (weight_at(line[i - 1], weights) + weight_at(line[i], weights));
    length += mean * length_of(std::span(line).subspan(i - 1, 2), patch.positions());
  }
  return length;
}

}  // namespace

SurfaceLine tight_line(const Patch& patch, std::span<const Index> path,
                       std::span<const double> weights, const Context& context) {
  SurfaceLine along = line_along_edges(patch, path);
  const bool is_loop = path.front() == path.back();
  SurfaceLine tight = is_loop ? shortened_loop(patch, along, context).points
                              : shortened(patch, along, context).points;
  if (weights.empty() ||
      weighed_length(patch, tight, weights) <= weighed_length(patch, along, weights))
    return tight;
  if (path.size() < k_shortest) return along;
  SurfaceLine line;
  const std::size_t middle = path.size() / 2;
  for (const auto part : {path.subspan(0, middle + 1), path.subspan(middle)}) {
    const SurfaceLine next = tight_line(patch, part, weights, context);
    line.insert(line.end(), next.begin() + (line.empty() ? 0 : 1), next.end());
  }
  return line;
}

}  // namespace planish
