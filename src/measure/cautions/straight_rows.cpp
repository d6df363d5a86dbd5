#include "measure/cautions/straight_rows.h"

namespace planish {

namespace {

constexpr std::size_t k_most_neighbours = 32;

/// A vertex as the origin, its neighbours around it as seen along its normal.
class Around {
 public:
  Around(const Patch& patch, Index v) : patch_(patch), v_(v) {
    const auto ring = patch.ring(v);
    for (std::size_t j = 0; j + 1 < ring.size() + (patch.is_border(v) ? 0 : 1); ++j)
      normal_ += cross(edge_to(ring[j]), edge_to(ring[(j + 1) % ring.size()]));
    const double length = norm(normal_);
    if (length > 0.0) normal_ = (1.0 / length) * normal_;
  }

  Index straightest_from(Index before) const {
    const Vec3 from = -seen(before);
    Index best = Edge::none;
    double largest = 0.5 * norm(from);  // 60 degrees
    for (const Index after : patch_.ring(v_)) {
      const Vec3 to = seen(after);
      const double length = norm(to), along = length > 0.0 ? dot(from, to) / length : 0.0;
      if (along > largest) {
        largest = along;
        best = after;
      }
    }
    return best;
  }

 private:
  Vec3 edge_to(Index other) const {
    return patch_.unit_scale() * patch_.positions()[other] -
           patch_.unit_scale() * patch_.positions()[v_];
  }
  Vec3 seen(Index other) const {
    const Vec3 edge = edge_to(other);
    return edge - dot(edge, normal_) * normal_;
  }

  const Patch& patch_;
  Index v_;
  Vec3 normal_{};
};

}  // namespace

Index straight_on(const Patch& patch, Index before, Index v) {
  if (patch.ring(v).size() > k_most_neighbours) return Edge::none;
  const Around around(patch, v);
  const Index after = around.straightest_from(before);
  return after != Edge::none && around.straightest_from(after) == before ? after : Edge::none;
}

}  // namespace planish
