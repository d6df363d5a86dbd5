#include "mesh/match/curve_seams.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "mesh/match/boundary_correspondences.h"
#include "mesh/match/curve_chains.h"

namespace planish {

namespace {

using Place = std::array<double, 2>;

constexpr std::size_t k_fewest_edges = 5;  // edges of the finer side
constexpr double k_shortest_seam = 0.002;  // of the shorter loop
constexpr double k_distances = 25.0;       // a seam is longer than this multiple of its distance
constexpr double k_matched = 0.6;          // of the vertices of each side
constexpr double k_at_vertex = 0.01;       // of an edge, within which a seam ends at its vertex
constexpr double k_tip_edges = 4.0;  // a dart's tip is so near to the last places of its sides

/// A chain with ends where the curves end.
class CurveEnds {
 public:
  CurveEnds(const BorderLines& borders, CurveChain chain, double tolerance)
      : borders_(borders), chain_(std::move(chain)), tolerance_(tolerance) {}

  CurveChain refined() {
    if (chain_.closed) return std::move(chain_);
    for (const bool at_end : {false, true}) {
      if (add_tip(at_end)) continue;
      cut_at_corner(at_end);
      for (std::size_t side = 0; side < 2; ++side)
        move_to_vertex(at_end, side);
    }
    return std::move(chain_);
  }

 private:
  const BorderLoop& loop(std::size_t side) const { return borders_.loops()[chain_.loops[side]]; }
  double sign(std::size_t side) const { return side == 1 && chain_.reversed ? -1.0 : 1.0; }
  Place& end(bool at_end) { return at_end ? chain_.at.back() : chain_.at.front(); }

  double cosine_at(std::size_t side, double vertex) const {
    return borders_.cosine_at(borders_.edge_at(loop(side), vertex));
  }

  /// Both sides of a dart end at its tip, the vertex between them where the border turns most.
  bool add_tip(bool at_end) {
    if (chain_.loops[0] != chain_.loops[1] || !chain_.reversed) return false;
    const Place here = end(at_end);
    const auto n = static_cast<double>(loop(0).count);
    // The places between the two, from the first on, in the direction in which the chain goes on.
    const double ahead = at_end ? 1.0 : -1.0;
    const double gap = ahead * (here[1] - here[0]), apart = gap - n * std::floor(gap / n);
    const double way = std::abs(borders_.way_to(loop(0), here[0] + ahead * apart) -
                                borders_.way_to(loop(0), here[0]));
    if (apart > k_tip_edges || way > k_tip_edges * loop(0).mean_edge()) return false;
    std::optional<double> tip;
    const auto turn_at = [&](double vertex) { return cosine_at(0, vertex); };
    const double low = std::min(here[0], here[0] + ahead * apart);
    for (double vertex = std::floor(low) + 1.0; vertex < low + apart; vertex += 1.0) {
      if (!tip || turn_at(vertex) < turn_at(*tip)) tip = vertex;
    }
    if (!tip) return false;
    const double turns = std::round((here[1] - here[0] - ahead * apart) / n);
    add(at_end, {*tip, *tip + n * turns});
    return true;
  }

  /// What goes on past a corner of both borders for a few edges only is left out.
  void cut_at_corner(bool at_end) {
    std::vector<Place>& at = chain_.at;
    const Place last = end(at_end);
    for (std::size_t k = 0; k + 2 < at.size(); ++k) {
      const Place& place = at_end ? at[at.size() - 1 - k] : at[k];
      const double edges = std::max(std::abs(place[0] - last[0]), std::abs(place[1] - last[1]));
      if (edges >= static_cast<double>(k_fewest_edges)) return;
      if (!is_near_corner(0, place[0]) || !is_near_corner(1, place[1])) continue;
      const auto count = static_cast<std::ptrdiff_t>(k);
      if (at_end)
        at.erase(at.end() - count, at.end());
      else
        at.erase(at.begin(), at.begin() + count);
      return;
    }
  }

  bool is_near_corner(std::size_t side, double place) const {
    const double vertex = std::round(place);
    if (!borders_.is_corner(borders_.edge_at(loop(side), vertex))) return false;
    const std::size_t edge = borders_.edge_at(loop(side), place);
    const double way = std::abs(place - vertex) * borders_.length(edge);
    return way <= search_radius(borders_, edge, tolerance_);
  }

  void add(bool at_end, Place place) {
    chain_.at.insert(at_end ? chain_.at.end() : chain_.at.begin(), place);
  }

  /// Where a vertex is as good as the end, or a corner within reach of it, it becomes the end.
  void move_to_vertex(bool at_end, std::size_t side) {
    const double here = end(at_end)[side];
    const double outward = at_end ? sign(side) : -sign(side);
    const double outer = outward > 0.0 ? std::ceil(here) : std::floor(here);
    for (const double vertex : {outer, outer - outward}) {
      if (outer == here) return;
      const std::size_t edge = borders_.edge_at(loop(side), 0.5 * (outer + outer - outward));
      const double length = borders_.length(edge), way = std::abs(vertex - here) * length;
      const bool is_corner = borders_.is_corner(borders_.edge_at(loop(side), vertex));
      const bool is_it = way <= k_at_vertex * length ||
                         (is_corner && way <= search_radius(borders_, edge, tolerance_));
      if (is_it && may_end_at(at_end, side, vertex)) return end_at(at_end, side, vertex);
    }
  }

  bool may_end_at(bool at_end, std::size_t side, double vertex) {
    return sign(side) *
               (at_end ? vertex - chain_.at.front()[side] : chain_.at.back()[side] - vertex) >
           0.0;
  }

  void end_at(bool at_end, std::size_t side, double vertex) {
    Place place = end(at_end);
    place[side] = vertex;
    const auto is_beyond = [&](const Place& other) {
      const double on = sign(side) * (vertex - other[side]);
      return at_end ? on <= 0.0 : on >= 0.0;
    };
    end(at_end) = place;
    std::vector<Place>& at = chain_.at;
    at.erase(std::remove_if(at.begin() + 1, at.end() - 1, is_beyond), at.end() - 1);
  }

  const BorderLines& borders_;
  CurveChain chain_;
  double tolerance_;
};

/// A side of a seam by the places of its ends.
struct Stretch {
  SeamSide side;
  std::vector<std::size_t> edges;
};

Stretch stretch_of(const BorderLines& borders, const CurveChain& chain, std::size_t number) {
  const BorderLoop& loop = borders.loops()[chain.loops[number]];
  const double from = chain.at.front()[number], to = chain.at.back()[number];
  const bool ahead = to > from;
  Stretch stretch;
  stretch.side.patch = loop.patch;
  const double low = std::floor(std::min(from, to)), high = std::ceil(std::max(from, to));
  const auto count = static_cast<std::size_t>(high - low);
  for (std::size_t k = 0; k < count; ++k) {
    const double at = ahead ? low + static_cast<double>(k) : high - static_cast<double>(k) - 1.0;
    const std::size_t edge = borders.edge_at(loop, at);
    const BorderEdge& ends = borders.edges()[edge];
    if (k == 0) stretch.side.vertices.push_back(ahead ? ends.from : ends.to);
    stretch.side.vertices.push_back(ahead ? ends.to : ends.from);
    stretch.edges.push_back(edge);
  }
  stretch.side.first_share = ahead ? from - low : high - from;
  stretch.side.last_share = ahead ? to - (high - 1.0) : (low + 1.0) - to;
  return stretch;
}

CurveSeam seam_of(const BorderLines& borders, const CurveChain& chain) {
  CurveSeam found;
  std::array<double, 2> start{}, length{};
  for (std::size_t side = 0; side < 2; ++side) {
    Stretch stretch = stretch_of(borders, chain, side);
    found.seam.sides[side] = std::move(stretch.side);
    found.edges[side] = std::move(stretch.edges);
    start[side] = borders.way_to(borders.loops()[chain.loops[side]], chain.at.front()[side]);
    length[side] = chain.length(borders, side);
  }
  for (const Place& place : chain.at) {
    std::array<double, 2> shares{};
    for (std::size_t side = 0; side < 2; ++side) {
      const double way = borders.way_to(borders.loops()[chain.loops[side]], place[side]);
      shares[side] = std::clamp(std::abs(way - start[side]) / length[side], 0.0, 1.0);
    }
    found.seam.matches.push_back(shares);
  }
  found.seam.matches.front() = {0.0, 0.0};
  found.seam.matches.back() = {1.0, 1.0};
  return found;
}

/// Whether most vertices of each side have a place beside them.
bool is_matched(const CurveChain& chain) {
  for (std::size_t side = 0; side < 2; ++side) {
    const double from = chain.at.front()[side], to = chain.at.back()[side];
    const double vertices = std::floor(std::max(from, to)) - std::ceil(std::min(from, to)) + 1.0;
    const auto matched = std::count_if(chain.at.begin(), chain.at.end(), [&](const Place& place) {
      return place[side] == std::floor(place[side]);
    });
    if (static_cast<double>(matched) < k_matched * vertices) return false;
  }
  return true;
}

/// Whether the borders lie beside each other for long, as they do not where they cross.
bool is_long(const BorderLines& borders, const CurveChain& chain) {
  std::vector<double> distances;
  distances.reserve(chain.at.size());
  for (const Place& place : chain.at) {
    const Vec3 first = borders.point_at(borders.loops()[chain.loops[0]], place[0]);
    const Vec3 second = borders.point_at(borders.loops()[chain.loops[1]], place[1]);
    distances.push_back(norm(first - second));
  }
  // The others may be of jags.
  const auto most = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() * 9 / 10);
  std::nth_element(distances.begin(), most, distances.end());
  return std::min(chain.length(borders, 0), chain.length(borders, 1)) > k_distances * *most;
}

bool is_seam(const BorderLines& borders, const CurveChain& chain) {
  std::array<const BorderLoop*, 2> loops{};
  std::array<double, 2> lengths{};
  std::array<std::size_t, 2> edges{};
  for (std::size_t side = 0; side < 2; ++side) {
    const double from = chain.at.front()[side], to = chain.at.back()[side];
    loops[side] = &borders.loops()[chain.loops[side]];
    lengths[side] = chain.length(borders, side);
    edges[side] =
        static_cast<std::size_t>(std::ceil(std::max(from, to)) - std::floor(std::min(from, to)));
  }
  return !is_fragment(loops, lengths, edges) && is_matched(chain) && is_long(borders, chain);
}

}  // namespace

bool is_fragment(const std::array<const BorderLoop*, 2>& loops,
                 const std::array<double, 2>& lengths, const std::array<std::size_t, 2>& edges) {
  const double shortest = k_shortest_seam * std::min(loops[0]->length, loops[1]->length);
  return !(std::min(lengths[0], lengths[1]) > shortest) ||
         std::max(edges[0], edges[1]) < k_fewest_edges;
}

std::vector<CurveSeam> find_curve_seams(const BorderLines& borders,
                                        std::vector<BoundaryCorrespondence> correspondences,
                                        double tolerance) {
  std::vector<CurveSeam> seams;
  for (CurveChain& chain : find_curve_chains(borders, std::move(correspondences))) {
    if (chain.at.size() < 2) continue;
    const CurveChain refined = CurveEnds(borders, std::move(chain), tolerance).refined();
    if (is_seam(borders, refined)) seams.push_back(seam_of(borders, refined));
  }
  return seams;
}

}  // namespace planish
