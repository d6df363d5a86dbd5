#include "mesh/match/border_lines.h"

#include <algorithm>
#include <cmath>

namespace planish {

BorderLines::BorderLines(std::span<const TriMesh> patches) {
  patches_.reserve(patches.size());
  for (const TriMesh& patch : patches) {
    const std::size_t number = patches_.size();
    for (const std::vector<Index>& loop : patches_.emplace_back(patch).border_loops()) {
      const std::size_t first = edges_.size(), n = loop.size();
      for (std::size_t k = 0; k < n; ++k) {
        edges_.push_back(
            {number, loop[k], loop[(k + 1) % n], first + (k + 1) % n, first + (k + n - 1) % n});
      }
    }
  }
  lengths_.reserve(edges_.size());
  for (std::size_t e = 0; e < edges_.size(); ++e)
    lengths_.push_back(norm(end(e) - start(e)));
  for (std::size_t first = 0; first < edges_.size(); first += loops_.back().count) {
    BorderLoop loop{edges_[first].patch, first, edges_[first].previous - first + 1, 0.0};
    for (std::size_t e = first; e < first + loop.count; ++e) {
      loop_of_.push_back(loops_.size());
      before_.push_back(loop.length);
      loop.length += lengths_[e];
    }
    loops_.push_back(loop);
  }
}

double BorderLines::length_around(std::size_t edge) const {
  return std::max({lengths_[edge], lengths_[edges_[edge].next], lengths_[edges_[edge].previous]});
}

std::size_t BorderLines::edge_at(const BorderLoop& loop, double place) const {
  const auto count = static_cast<double>(loop.count);
  const double turn = std::floor(place / count);
  const auto edge = static_cast<std::size_t>(std::max(0.0, std::floor(place - turn * count)));
  return loop.first + std::min(edge, loop.count - 1);
}

Vec3 BorderLines::point_at(const BorderLoop& loop, double place) const {
  const auto count = static_cast<double>(loop.count);
  const std::size_t edge = edge_at(loop, place);
  const double share = place - count * std::floor(place / count) - place_of(edge);
  return start(edge) + share * (end(edge) - start(edge));
}

double BorderLines::way_to(const BorderLoop& loop, double place) const {
  const auto count = static_cast<double>(loop.count);
  const double turn = std::floor(place / count);
  const std::size_t edge = edge_at(loop, place);
  const double share = place - turn * count - place_of(edge);
  return turn * loop.length + before_[edge] + share * lengths_[edge];
}

double BorderLines::cosine_at(std::size_t edge) const {
  const std::size_t previous = edges_[edge].previous;
  const double lengths = lengths_[edge] * lengths_[previous];
  const Vec3 after = end(edge) - start(edge), before = end(previous) - start(previous);
  return lengths > 0.0 ? dot(after, before) / lengths : 1.0;
}

}  // namespace planish
