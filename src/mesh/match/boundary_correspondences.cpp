#include "mesh/match/boundary_correspondences.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "mesh/match/across_patch.h"
#include "mesh/search/box_tree.h"

namespace planish {

namespace {

constexpr double k_near = 0.1;         // distance over the length of the edge
constexpr double k_most_edges = 25.0;  // within a tolerance, which would be of no use beyond
constexpr double k_along = 0.87;       // cosine between directions
constexpr double k_aside = 0.5;    // of the distance, how much may be along the edge past its end
constexpr double k_at_end = 0.01;  // of the edge's length, what is at its end
constexpr double k_winding = 3.0;  // way along the loop over the distance, of neighbours

/// The nearest place of an edge to a vertex.
struct Foot {
  std::size_t edge = 0;
  double share = 0.0, distance = 0.0;
  bool reversed = false;
};

class CorrespondenceSearch {
 public:
  CorrespondenceSearch(const BorderLines& borders, double tolerance)
      : borders_(borders),
        tolerance_(tolerance),
        equal_(vertex_tolerance(borders, tolerance)),
        tree_(boxes()) {}

  std::vector<BoundaryCorrespondence> search() const {
    std::vector<BoundaryCorrespondence> places;
    for (std::size_t e = 0; e < borders_.edges().size(); ++e) {
      for (const Foot& foot : nearest_of_each_stretch(feet_of(e))) {
        if (!is_beyond_end(e, foot) && !is_across(e, foot)) add(e, foot, places);
      }
    }
    return places;
  }

 private:
  /// A triangle for each edge whose box is that of all places within its reach.
  TriMesh boxes() const {
    TriMesh mesh;
    for (std::size_t e = 0; e < borders_.edges().size(); ++e) {
      const double reach = search_radius(borders_, e, tolerance_);
      const Vec3 a = borders_.start(e), b = borders_.end(e), margin = {reach, reach, reach};
      const Vec3 low = {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
      const Vec3 high = {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
      const auto first = static_cast<Index>(mesh.positions.size());
      mesh.positions.push_back(low - margin);
      mesh.positions.push_back(high + margin);
      mesh.triangles.push_back({first, first + 1, first + 1});
    }
    return mesh;
  }

  static bool is_within(const Box& box, Vec3 p) {
    return p.x >= box.low.x && p.x <= box.high.x && p.y >= box.low.y && p.y <= box.high.y &&
           p.z >= box.low.z && p.z <= box.high.z;
  }

  /// Of the vertex that an edge begins at.
  std::vector<Foot> feet_of(std::size_t e) const {
    const Vec3 p = borders_.start(e);
    std::vector<Foot> feet;
    std::vector<std::size_t> open = {0};
    while (!open.empty()) {
      const std::size_t number = open.back();
      open.pop_back();
      const BoxTree::Node& node = tree_.nodes()[number];
      if (!is_within(node.box, p)) continue;
      if (!node.is_leaf()) {
        open.insert(open.end(), {number + 1, node.second});
        continue;
      }
      for (std::size_t place = node.begin; place < node.end; ++place) {
        if (const auto foot = foot_on(tree_.triangle(place), e)) feet.push_back(*foot);
      }
    }
    return feet;
  }

  std::optional<Foot> foot_on(std::size_t edge, std::size_t e) const {
    const Vec3 p = borders_.start(e), a = borders_.start(edge), along = borders_.end(edge) - a;
    const double square = dot(along, along);
    const double share = square > 0.0 ? std::clamp(dot(p - a, along) / square, 0.0, 1.0) : 0.0;
    const double end = std::round(share), to_end = norm(p - (a + end * along));
    if (to_end <= equal_) return foot_at(edge, e, end, to_end);
    return foot_at(edge, e, share, norm(p - (a + share * along)));
  }

  std::optional<Foot> foot_at(std::size_t edge, std::size_t e, double share,
                              double distance) const {
    if (!(distance <= search_radius(borders_, edge, tolerance_))) return std::nullopt;
    if (are_neighbours(e, edge, share, distance)) return std::nullopt;
    const double cosine = cosine_between(e, edge);
    if (std::abs(cosine) < k_along) return std::nullopt;
    return Foot{edge, share, distance, cosine < 0.0};
  }

  bool are_neighbours(std::size_t e, std::size_t edge, double share, double distance) const {
    if (borders_.loop_number(e) != borders_.loop_number(edge)) return false;
    if (edge == e || edge == borders_.edges()[e].previous) return true;
    const BorderLoop& loop = borders_.loop_of(e);
    const double there = borders_.way_to(loop, borders_.place_of(edge) + share);
    const double way = std::abs(there - borders_.way_to(loop, borders_.place_of(e)));
    return std::min(way, loop.length - way) <= k_winding * distance;
  }

  /// That of the most parallel ones among the directions of the border on both sides of the vertex
  /// and past it, and those of the edge and past it: single short edges may point anywhere.
  double cosine_between(std::size_t e, std::size_t edge) const {
    const std::size_t before = borders_.edges()[e].previous;
    const std::array<Vec3, 3> at_vertex = {borders_.end(e) - borders_.start(e),
                                           borders_.start(e) - borders_.start(before),
                                           borders_.end(e) - borders_.start(before)};
    const std::array<Vec3, 2> at_edge = {borders_.end(edge) - borders_.start(edge),
                                         borders_.end(borders_.edges()[edge].next) -
                                             borders_.start(borders_.edges()[edge].previous)};
    double best = 0.0;
    for (const Vec3 a : at_vertex) {
      for (const Vec3 b : at_edge) {
        const double lengths = norm(a) * norm(b);
        const double cosine = lengths > 0.0 ? dot(a, b) / lengths : 0.0;
        if (std::abs(cosine) > std::abs(best)) best = cosine;
      }
    }
    return best;
  }

  /// One of those on edges that follow each other.
  static std::vector<Foot> nearest_of_each_stretch(std::vector<Foot> feet) {
    std::sort(feet.begin(), feet.end(), [](const Foot& a, const Foot& b) {
      return std::tie(a.reversed, a.edge) < std::tie(b.reversed, b.edge);
    });
    std::vector<Foot> nearest;
    for (std::size_t k = 0; k < feet.size(); ++k) {
      const bool goes_on =
          k > 0 && feet[k].reversed == feet[k - 1].reversed && feet[k].edge == feet[k - 1].edge + 1;
      if (!goes_on)
        nearest.push_back(feet[k]);
      else if (feet[k].distance < nearest.back().distance)
        nearest.back() = feet[k];
    }
    return nearest;
  }

  /// Whether the vertex lies off the end of the stretch that the edge is in.
  bool is_beyond_end(std::size_t e, const Foot& foot) const {
    if (foot.share > 0.0 && foot.share < 1.0) return false;
    if (foot.distance <= std::max(equal_, k_at_end * borders_.length(foot.edge))) return false;
    const Vec3 a = borders_.start(foot.edge), along = borders_.end(foot.edge) - a;
    const Vec3 aside = borders_.start(e) - (a + foot.share * along);
    return std::abs(dot(aside, along)) > k_aside * norm(along) * foot.distance;
  }

  bool is_across(std::size_t e, const Foot& foot) const {
    const std::size_t patch = borders_.edges()[e].patch;
    const BorderEdge& edge = borders_.edges()[foot.edge];
    return edge.patch == patch && foot.distance > 0.0 &&
           is_just_across(borders_.patch(patch), edge, foot.share, borders_.start(e),
                          foot.distance);
  }

  void add(std::size_t e, const Foot& foot, std::vector<BoundaryCorrespondence>& places) const {
    const BorderLoop& loop = borders_.loop_of(foot.edge);
    double there = borders_.place_of(foot.edge) + foot.share;
    if (there >= static_cast<double>(loop.count)) there = 0.0;
    const std::size_t own = borders_.loop_number(e), other = borders_.loop_number(foot.edge);
    const double here = borders_.place_of(e);
    if (own <= other) places.push_back({{own, other}, {here, there}, foot.reversed});
    if (own >= other) places.push_back({{other, own}, {there, here}, foot.reversed});
  }

  const BorderLines& borders_;
  double tolerance_, equal_;
  BoxTree tree_;
};

}  // namespace

double search_radius(const BorderLines& borders, std::size_t edge, double tolerance) {
  if (!(tolerance > 0.0)) return k_near * borders.length_around(edge);
  return std::min(tolerance, k_most_edges * borders.loop_of(edge).mean_edge());
}

double vertex_tolerance(const BorderLines& borders, double tolerance) {
  constexpr double k_edge_share = 0.1;
  double length = 0.0;
  for (const BorderLoop& loop : borders.loops())
    length += loop.length;
  return std::min(tolerance, k_edge_share * length / static_cast<double>(borders.edges().size()));
}

std::vector<BoundaryCorrespondence> find_boundary_correspondences(const BorderLines& borders,
                                                                  double tolerance) {
  if (borders.edges().empty()) return {};
  return CorrespondenceSearch(borders, tolerance).search();
}

}  // namespace planish
