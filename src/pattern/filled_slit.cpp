#include "pattern/filled_slit.h"

#include <cstddef>
#include <utility>
#include <vector>

#include "pattern/polygon/plane.h"

namespace planish {

namespace {

struct Segment {
  Vec2 from, to;
};

std::vector<Segment> segments_of(std::span<const Polygon> loops) {
  std::vector<Segment> segments;
  for (const Polygon& loop : loops) {
    for (std::size_t k = 0; k < loop.size(); ++k)
      segments.push_back({loop[k], loop[(k + 1) % loop.size()]});
  }
  return segments;
}

/// Whether places are farther from segments than a bound. A search begins at the segment that ended
/// the last one: of places that follow each other, nearly all need one or two.
class FartherThan {
 public:
  FartherThan(std::vector<Segment> segments, double bound)
      : segments_(std::move(segments)), bound_(bound) {}

  bool operator()(Vec2 place) {
    for (std::size_t k = 0; k < segments_.size(); ++k) {
      const std::size_t at = (begin_ + k) % segments_.size();
      if (distance_to_segment(place, segments_[at].from, segments_[at].to) > bound_) continue;
      begin_ = at;
      return false;
    }
    return true;
  }

 private:
  std::vector<Segment> segments_;
  double bound_;
  std::size_t begin_ = 0;
};

}  // namespace

double filled_slit_length(std::span<const Polygon> outline, std::span<const Polygon> cut,
                          double width) {
  FartherThan is_far(segments_of(cut), 2.0 * width);
  double length = 0.0;
  for (const Polygon& loop : outline) {
    if (loop.empty()) continue;
    bool was_far = is_far(loop.back());
    Vec2 before = loop.back();
    for (const Vec2 vertex : loop) {
      const bool now_far = is_far(vertex);
      if (was_far && now_far) length += norm(vertex - before);
      was_far = now_far;
      before = vertex;
    }
  }
  return length;
}

}  // namespace planish
