#include "mesh/imprint/thin_parts.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/math.h"

namespace planish {

namespace {

constexpr double k_cap = -0.35;        // cosine from which an angle is taken for nearly straight
constexpr double k_encroaching = 0.3;  // of a side: a node nearer to it is put onto it
constexpr double k_least_share = 0.2;  // of a side, to its end, where the place is free

double doubled_area(Vec2 a, Vec2 b, Vec2 c) {
  return cross(b - a, c - a);
}

class ThinParts {
 public:
  ThinParts(const ConstrainedDelaunay& inside, double least, double finest)
      : inside_(inside), finest_(finest) {
    constexpr double degree = 0.017453292519943295;
    sine_ = std::min(math::sin(least * degree), smallest_sine({0, 1, 2}));
  }

  std::vector<WidenedBy> nodes() const {
    std::vector<WidenedBy> nodes;
    for (Index part = 0; part < inside_.parts().size(); ++part) {
      if (const auto node = node_for(part)) nodes.push_back(*node);
    }
    return nodes;
  }

 private:
  Vec2 at(Index node) const { return inside_.place(node); }

  std::array<double, 3> sides_of(const Triangle& t) const {
    std::array<double, 3> sides{};
    for (std::size_t k = 0; k < 3; ++k)
      sides[k] = norm(at(t[(k + 1) % 3]) - at(t[k]));
    return sides;
  }

  double smallest_sine(const Triangle& t) const {
    const auto [a, b, c] = sides_of(t);
    const double shortest = std::min({a, b, c});
    const double area = doubled_area(at(t[0]), at(t[1]), at(t[2]));
    return area * shortest / std::max(a * b * c, 1e-300);
  }

  /// Where a place is beside a side, as a share of its length.
  double share_along(Vec2 p, Index from, Index to) const {
    const Vec2 along = at(to) - at(from);
    return dot(p - at(from), along) / std::max(dot(along, along), 1e-300);
  }

  WidenedBy on_side(Index from, Index to, double share) const {
    const double length = norm(at(to) - at(from));
    return {std::array{from, to}, share, {}, 0.5 * std::min(share, 1.0 - share) * length};
  }

  std::optional<WidenedBy> node_for(Index part) const {
    const Triangle& t = inside_.parts()[part].corners;
    if (smallest_sine(t) >= sine_) return std::nullopt;
    const std::array<double, 3> sides = sides_of(t);
    const auto first =
        static_cast<std::size_t>(std::min_element(sides.begin(), sides.end()) - sides.begin());
    if (sides[first] < finest_) return std::nullopt;
    // The short side from a to b, and the sides from b to the tip and from there to a.
    const std::size_t second = (first + 1) % 3, third = (first + 2) % 3;
    const Index a = t[first], b = t[second], tip = t[third];
    const bool at_b = inside_.is_fixed(part, second), at_a = inside_.is_fixed(part, third);
    if (at_a && at_b) return std::nullopt;
    // Nearly straight at one end of the short side: a node below that end on the long side. Not
    // where both sides are fixed: around their corner one node would ask for the next, ever nearer.
    const bool is_corner = inside_.is_fixed(part, first);
    for (const auto& [bend, end, is_fixed] : {std::tuple{a, b, at_b}, std::tuple{b, a, at_a}}) {
      const Vec2 to_end = at(end) - at(bend), to_tip = at(tip) - at(bend);
      if (is_corner || !is_fixed || dot(to_end, to_tip) > k_cap * norm(to_end) * norm(to_tip))
        continue;
      const double height = std::abs(cross(to_end, to_tip)) / norm(at(tip) - at(end));
      if (height < finest_) return std::nullopt;
      return on_side(end, tip, share_along(at(bend), end, tip));
    }
    // Sizes change evenly from the short side to the long one.
    if (at_a) return on_side(a, tip, std::sqrt(sides[first] / sides[third]));
    if (at_b) return on_side(b, tip, std::sqrt(sides[first] / sides[second]));
    return beyond_short_side(part, first);
  }

  /// The place before the middle of the short side of a part, between the sides around it.
  std::optional<WidenedBy> beyond_short_side(Index part, std::size_t first) const {
    const Triangle& t = inside_.parts()[part].corners;
    const Vec2 a = at(t[first]), b = at(t[(first + 1) % 3]), tip = at(t[(first + 2) % 3]);
    const double length = norm(b - a), to_a = norm(tip - a), to_b = norm(tip - b);
    const double area = doubled_area(a, b, tip);
    if (!(length > 0.0) || !(area > 0.0)) return std::nullopt;
    const Vec2 middle = 0.5 * (a + b), up = {(a.y - b.y) / length, (b.x - a.x) / length};
    // Not beyond the middle of the circle through the corners, in which no other node is.
    const double radius = length * to_a * to_b / (2.0 * area);
    const double cosine = dot(tip - a, tip - b) / std::max(to_a * to_b, 1e-300);
    const double height = std::min(std::sqrt(length * std::max(to_a, to_b)), cosine * radius);
    if (!(height > 0.0)) return std::nullopt;
    return between_sides(part, middle, middle + height * up, length);
  }

  /// A node at a place, or on the fixed side before it, or on that which it would be near to.
  std::optional<WidenedBy> between_sides(Index part, Vec2 from, Vec2 to, double length) const {
    Index before = part;
    for (std::size_t count = 0; count <= inside_.parts().size(); ++count) {
      const auto& here = inside_.parts()[part];
      std::optional<std::size_t> out;
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec2 p = at(here.corners[k]), q = at(here.corners[(k + 1) % 3]);
        const bool is_back = count > 0 && here.across[k] == before;
        if (is_back || doubled_area(p, q, to) >= 0.0) continue;
        const bool is_way = doubled_area(from, to, p) <= 0.0 && doubled_area(from, to, q) >= 0.0;
        if (!out || is_way) out = k;
      }
      if (!out) return inside_part(part, to, length);
      if (inside_.is_fixed(part, *out)) return beside_side(part, *out, to);
      before = part;
      part = here.across[*out];
    }
    return std::nullopt;
  }

  WidenedBy beside_side(Index part, std::size_t slot, Vec2 p) const {
    const Triangle& t = inside_.parts()[part].corners;
    const Index from = t[slot], to = t[(slot + 1) % 3];
    return on_side(from, to,
                   std::clamp(share_along(p, from, to), k_least_share, 1.0 - k_least_share));
  }

  WidenedBy inside_part(Index part, Vec2 p, double length) const {
    const Triangle& t = inside_.parts()[part].corners;
    for (std::size_t k = 0; k < 3; ++k) {
      if (!inside_.is_fixed(part, k)) continue;
      const Vec2 a = at(t[k]), b = at(t[(k + 1) % 3]);
      const double side = norm(b - a);
      if (doubled_area(a, b, p) < k_encroaching * side * side) {
        const double share = share_along(p, t[k], t[(k + 1) % 3]);
        if (share > 0.0 && share < 1.0 && doubled_area(a, b, p) < side * length)
          return beside_side(part, k, p);
      }
    }
    return {std::nullopt, 0.0, p, 0.5 * length};
  }

  const ConstrainedDelaunay& inside_;
  double finest_, sine_;
};

}  // namespace

std::vector<WidenedBy> widening_nodes(const ConstrainedDelaunay& inside, double least,
                                      double finest) {
  return ThinParts(inside, least, finest).nodes();
}

}  // namespace planish
