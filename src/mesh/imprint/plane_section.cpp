#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include <planish/mesh/surface_line.h>

namespace planish {

namespace {

/// A vertex on the plane (both ends are it) or an edge that crosses it, its lower number first.
using Crossing = std::array<Index, 2>;

/// What of the plane one triangle has.
struct Piece {
  std::array<Crossing, 2> ends;
  Index triangle;
};

class PlaneSection {
 public:
  PlaneSection(const Patch& patch, const Plane& plane, double snap) : patch_(patch) {
    const double scale = patch.unit_scale();
    const double largest =
        std::max({std::abs(plane.normal.x), std::abs(plane.normal.y), std::abs(plane.normal.z)});
    if (!(largest > 0.0) || !std::isfinite(largest) || !std::isfinite(plane.offset) ||
        !(snap >= 0.0))
      throw Error(ErrorCode::option_out_of_range,
                  "a plane needs a normal that is not 0, and numbers");
    const double length = norm((1.0 / largest) * plane.normal);
    const Vec3 normal = (1.0 / length) * ((1.0 / largest) * plane.normal);
    const double offset = plane.offset / largest / length;
    heights_.reserve(patch.vertex_count());
    for (const Vec3 p : patch.positions()) {
      const double height = dot(normal, scale * p) - scale * offset;
      heights_.push_back(std::abs(height) <= scale * snap ? 0.0 : height);
    }
  }

  std::vector<SurfaceLine> lines() {
    for (Index t = 0; t < patch_.triangles().size(); ++t)
      add_piece(t);
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      for (const Crossing& end : pieces_[p].ends)
        at_[end].push_back(p);
    }
    std::vector<SurfaceLine> lines;
    used_.assign(pieces_.size(), 0);
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      if (used_[p] == 0) lines.push_back(line_through(p));
    }
    return lines;
  }

 private:
  int sign(Index v) const { return heights_[v] > 0.0 ? 1 : heights_[v] < 0.0 ? -1 : 0; }

  void add_piece(Index triangle) {
    const Triangle& t = patch_.triangles()[triangle];
    std::vector<Crossing> ends;
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = t[k], w = t[(k + 1) % 3];
      if (sign(v) == 0) ends.push_back({v, v});
      if (sign(v) * sign(w) < 0) ends.push_back({std::min(v, w), std::max(v, w)});
    }
    if (ends.size() != 2) return;
    // An edge on the plane is taken once: from the triangle above, unless both are.
    const bool is_edge = ends[0][0] == ends[0][1] && ends[1][0] == ends[1][1];
    if (is_edge && !is_taken(t, ends[0][0], ends[1][0])) return;
    pieces_.push_back({{ends[0], ends[1]}, triangle});
  }

  bool is_taken(const Triangle& t, Index v, Index w) const {
    const Index apex = *std::find_if(t.begin(), t.end(), [&](Index c) { return c != v && c != w; });
    if (sign(apex) <= 0) return false;
    const auto ring = patch_.ring(v);
    const auto at = std::find(ring.begin(), ring.end(), w) - ring.begin();
    const auto size = static_cast<std::ptrdiff_t>(ring.size());
    for (std::ptrdiff_t beside : {at + 1, at - 1}) {
      if (!patch_.is_border(v)) beside = (beside + size) % size;
      if (beside < 0 || beside >= size) continue;
      const Index other = ring[static_cast<std::size_t>(beside)];
      if (other != apex) return sign(other) <= 0;
    }
    return false;
  }

  SurfacePoint point(const Crossing& crossing, Index triangle) const {
    SurfacePoint point{patch_.triangles()[triangle], {0.0, 0.0, 0.0}};
    const auto share_of = [&](Index v) -> double& {
      const auto at = std::find(point.corners.begin(), point.corners.end(), v);
      return point.shares[static_cast<std::size_t>(at - point.corners.begin())];
    };
    const auto [low, high] = crossing;
    if (low == high) {
      share_of(low) = 1.0;
      return point;
    }
    const double share = heights_[low] / (heights_[low] - heights_[high]);
    share_of(high) = share;
    share_of(low) = 1.0 - share;
    return point;
  }

  /// Goes on from an end of a piece as long as there is one way only.
  std::vector<SurfacePoint> onward(std::size_t piece, std::size_t end) {
    std::vector<SurfacePoint> points;
    const std::size_t first = piece;
    for (;;) {
      const Crossing at = pieces_[piece].ends[end];
      points.push_back(point(at, pieces_[piece].triangle));
      const auto& here = at_.at(at);
      if (here.size() != 2) return points;
      const std::size_t next = here[0] == piece ? here[1] : here[0];
      if (next == first || used_[next] != 0) return points;
      used_[next] = 1;
      end = pieces_[next].ends[0] == at ? 1 : 0;
      piece = next;
    }
  }

  SurfaceLine line_through(std::size_t piece) {
    used_[piece] = 1;
    std::vector<SurfacePoint> forth = onward(piece, 1), back = onward(piece, 0);
    std::reverse(back.begin(), back.end());
    back.insert(back.end(), forth.begin(), forth.end());
    return back;
  }

  const Patch& patch_;
  std::vector<double> heights_;  // over the plane, scaled; 0 on it
  std::vector<Piece> pieces_;
  std::map<Crossing, std::vector<std::size_t>> at_;
  std::vector<unsigned char> used_;
};

}  // namespace

std::vector<SurfaceLine> plane_section(const Patch& patch, const Plane& plane, double snap) {
  return PlaneSection(patch, plane, snap).lines();
}

}  // namespace planish
