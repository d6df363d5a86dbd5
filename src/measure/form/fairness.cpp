#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include <planish/measure/cautions.h>
#include <planish/measure/fairness.h>

#include "core/neumaier_sum.h"
#include "geometry/angle_between.h"
#include "measure/area.h"
#include "measure/bends.h"
#include "measure/form/form_change.h"
#include "measure/normals.h"
#include "measure/off_border.h"
#include "measure/smoothed.h"
#include "mesh/symmetry/moments.h"

namespace planish {

namespace {

constexpr double k_degrees = 180.0 / std::numbers::pi;
constexpr double k_usual_share = 0.99;  // of the design's area, whose bends are nowhere sharp

// A design of one curvature all over must not become sharp by rounding.
constexpr double k_bend_rounding = 1e-6;

double square(double x) {
  return x * x;
}

std::vector<Bend> bends_of(std::span<const Vec3> positions, const Connectivity& connectivity,
                           double scale) {
  std::vector<Bend> bends;
  bends.reserve(3 * positions.size());
  for_each_bend(positions, connectivity, scale,
                [&](const Hinge&, const Bend& bend) { bends.push_back(bend); });
  return bends;
}

double bending_of(std::span<const Bend> bends) {
  NeumaierSum sum;
  for (const Bend& bend : bends)
    sum.add(bend.bending());
  return sum.value();
}

/// The |curvature| that 99 % of the area stays at or below.
double usual_curvature(std::span<const Bend> bends) {
  std::vector<std::pair<double, std::size_t>> order;
  order.reserve(bends.size());
  NeumaierSum area;
  for (std::size_t i = 0; i < bends.size(); ++i) {
    order.emplace_back(std::abs(bends[i].curvature()), i);
    area.add(bends[i].area);
  }
  std::sort(order.begin(), order.end());
  NeumaierSum so_far;
  for (const auto& [curvature, i] : order) {
    so_far.add(bends[i].area);
    if (so_far.value() >= k_usual_share * area.value()) return curvature;
  }
  return 0.0;
}

double sharp_share(std::span<const Bend> bends, double usual) {
  NeumaierSum sharp, all;
  for (const Bend& bend : bends) {
    all.add(bend.area);
    if (std::abs(bend.curvature()) > (1.0 + k_bend_rounding) * usual) sharp.add(bend.area);
  }
  return all.value() > 0.0 ? sharp.value() / all.value() : 0.0;
}

/// What came and what went, not yet over B0.
std::pair<double, double> added_and_lost(std::span<const Bend> before,
                                         std::span<const Bend> after) {
  NeumaierSum added, lost;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const double k0 = before[i].curvature(), k1 = after[i].curvature();
    const bool same = k0 * k1 > 0.0;
    const double more = same ? std::abs(k1) - std::abs(k0) : std::abs(k1);
    const double less = same ? std::abs(k0) - std::abs(k1) : std::abs(k0);
    added.add(square(std::max(more, 0.0)) * after[i].area);
    lost.add(square(std::max(less, 0.0)) * before[i].area);
  }
  return {added.value(), lost.value()};
}

std::optional<Fold> sharpest_fold(std::span<const Vec3> positions, const Connectivity& connectivity,
                                  std::span<const Bend> before, std::span<const Bend> after) {
  Fold fold;
  std::size_t i = 0;
  for_each_hinge(connectivity, [&](const Hinge& hinge) {
    const double t0 = before[i].angle, t1 = after[i].angle;
    ++i;
    const double more = k_degrees * (std::abs(t1) - (t0 * t1 > 0.0 ? std::abs(t0) : 0.0));
    if (!(more > fold.degrees)) return;
    const Vec3 a = positions[hinge.from], b = positions[hinge.to];
    fold = {hinge.from, hinge.to, more, 0.5 * a + 0.5 * b};
  });
  if (fold.degrees == 0.0) return std::nullopt;
  return fold;
}

/// Of some angles, in degrees.
class RootMeanSquare {
 public:
  void add(double angle) {
    squares_.add(angle * angle);
    count_ += 1.0;
  }
  double degrees() const {
    return count_ > 0.0 ? k_degrees * std::sqrt(squares_.value() / count_) : 0.0;
  }

 private:
  NeumaierSum squares_;
  double count_ = 0.0;
};

double normal_turn(const Patch& design, std::span<const Vec3> after, double scale) {
  const auto first = vertex_normals(design.triangles(), design.positions(), scale);
  const auto second = vertex_normals(design.triangles(), after, scale);
  RootMeanSquare turn;
  for (Index v = 0; v < after.size(); ++v) {
    if (!design.ring(v).empty()) turn.add(angle_between(first[v], second[v]));
  }
  return turn.degrees();
}

double border_turn(const Patch& design, std::span<const Vec3> after, double scale) {
  // The ring of a border vertex begins with the next one.
  const auto is_border_edge = [&](Index a, Index b) {
    return design.is_border(a) && design.ring(a).front() == b;
  };
  RootMeanSquare turn;
  for (const Triangle& t : design.triangles()) {
    if (is_border_edge(t[0], t[1]) || is_border_edge(t[1], t[2]) || is_border_edge(t[2], t[0]))
      turn.add(angle_between(triangle_normal(t, design.positions(), scale),
                             triangle_normal(t, after, scale)));
  }
  return turn.degrees();
}

/// Of the corners of the triangles along a direction.
double extent(std::span<const Triangle> triangles, std::span<const Vec3> positions, Vec3 direction,
              double scale) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double low = infinity, high = -infinity;
  for (const Triangle& t : triangles) {
    for (const Index v : t) {
      const double along = dot(direction, scale * positions[v]);
      low = std::min(low, along);
      high = std::max(high, along);
    }
  }
  return high - low;
}

double largest_move(const Patch& design, std::span<const Vec3> after) {
  const double scale = design.unit_scale();
  double largest = 0.0;
  for (const Triangle& t : design.triangles()) {
    for (const Index v : t)
      largest = std::max(largest, norm(scale * after[v] - scale * design.positions()[v]));
  }
  const double diagonal = scale * bounding_box_diagonal(design.mesh());
  return diagonal > 0.0 ? largest / diagonal : 0.0;
}

std::optional<double> height_ratio(const Patch& design, std::span<const Triangle> triangles,
                                   std::span<const Vec3> after) {
  const double scale = design.unit_scale();
  const auto moments = moments_of(design.triangles(), design.positions(), scale);
  const auto axes = principal_axes(moments.covariance);
  const auto axis = [&](int i) { return Vec3{axes(0, i), axes(1, i), axes(2, i)}; };
  const auto design_extent = [&](int i) {
    return extent(design.triangles(), design.positions(), axis(i), scale);
  };
  const double height = design_extent(0);
  const double longest = std::max(design_extent(1), design_extent(2));
  if (!(height >= k_least_height * longest) || height == 0.0) return std::nullopt;
  return extent(triangles, after, axis(0), scale) / height;
}

/// What is lost of the form of a design whose short waves are noise, over its bending: both
/// surfaces without waves of that length, away from the border, where noise stays.
double form_lost(const Patch& design, std::span<const Vec3> after, double wave) {
  constexpr double surely = 0.9;
  const Patch changed = design.with_positions({after.begin(), after.end()});
  const double scale = design.unit_scale();
  const double longest = surely * k_longest_wave * mean_side_of(changed.mesh(), scale) / scale;
  const Connectivity& connectivity = design.connectivity();
  const auto bends_inside = [&](const Patch& patch) {
    std::vector<Bend> bends;
    for_each_bend(
        smoothed_positions(patch, std::min(wave, longest)), connectivity, scale,
        [&](const Hinge& hinge, const Bend& bend) {
          if (is_off_border(connectivity, hinge.from) && is_off_border(connectivity, hinge.to))
            bends.push_back(bend);
        });
    return bends;
  };
  const std::vector<Bend> first = bends_inside(design);
  const double form = bending_of(first);
  return form > k_no_bending ? added_and_lost(first, bends_inside(changed)).second / form : 0.0;
}

}  // namespace

bool Fairness::is_smooth() const {
  if (unchanged || !form_change) return bends_little();
  return bending_ratio && !form_change->is_rippled() && !form_change->is_folded();
}

bool Fairness::bends_little() const {
  return unchanged ||
         (bends_at_most(k_smooth_ratio) && bending_added.value_or(0.0) <= k_smooth_added &&
          sharp_share <= k_smooth_sharp_share);
}

bool Fairness::bends_at_most(double ratio) const {
  return unchanged || (bending_ratio && *bending_ratio <= std::max(ratio, design_ratio));
}

bool Fairness::is_smooth_within(double max_bending) const {
  return max_bending > 0.0 ? bends_at_most(max_bending) : bends_little();
}

bool Fairness::keeps_form() const {
  const FormChange seen = form_change.value_or(FormChange{});
  return !seen.is_dented() && !seen.is_uneven() && !seen.has_lost_relief() &&
         !seen.has_lost_edge() && height_ratio.value_or(1.0) >= k_kept_height &&
         largest_move.value_or(0.0) <= k_kept_move;
}

Fairness fairness_of_design(const Fairness& of_result) {
  Fairness fairness;
  fairness.unchanged = true;
  fairness.design_ratio = of_result.design_ratio;
  fairness.sharp_share = fairness.design_sharp_share = of_result.design_sharp_share;
  fairness.normal_turn = fairness.border_turn = 0.0;
  if (of_result.height_ratio) fairness.height_ratio = 1.0;
  fairness.largest_move = 0.0;
  if (of_result.form_change) fairness.form_change = FormChange{};
  if (!of_result.bending_ratio) return fairness;
  fairness.bending_ratio = of_result.design_ratio;
  fairness.bending_added = fairness.bending_lost = 0.0;
  return fairness;
}

Fairness measure_fairness(const Patch& design, std::span<const Vec3> after) {
  return measure_fairness(design, design_bending(design), after);
}

Fairness measure_fairness(const Patch& design, double b0, std::span<const Vec3> after) {
  Fairness fairness = fairness_beside(design, b0, after);
  fairness.form_change = FormChange{};
  if (fairness.unchanged) return fairness;
  const auto noise = find_scan_noise(design);
  fairness.form_change = form_change_of(design, after, noise.has_value());
  if (noise && fairness.bending_lost) fairness.bending_lost = form_lost(design, after, noise->wave);
  return fairness;
}

Fairness fairness_beside(const Patch& design, double b0, std::span<const Vec3> after) {
  const double scale = design.unit_scale();
  const std::vector<Bend> first = bends_of(design.positions(), design.connectivity(), scale);
  const double usual = usual_curvature(first);
  Fairness fairness;
  if (std::equal(after.begin(), after.end(), design.positions().begin())) {
    fairness.design_sharp_share = sharp_share(first, usual);
    fairness.height_ratio = height_ratio(design, design.triangles(), after);
    if (b0 > k_no_bending) {
      fairness.design_ratio = bending_of(first) / b0;
      fairness.bending_ratio = fairness.design_ratio;
    }
    return fairness_of_design(fairness);
  }
  const std::vector<Bend> second = bends_of(after, design.connectivity(), scale);
  fairness.sharp_share = sharp_share(second, usual);
  fairness.design_sharp_share = sharp_share(first, usual);
  fairness.normal_turn = normal_turn(design, after, scale);
  fairness.border_turn = border_turn(design, after, scale);
  fairness.sharpest_fold = sharpest_fold(after, design.connectivity(), first, second);
  fairness.height_ratio = height_ratio(design, design.triangles(), after);
  fairness.largest_move = largest_move(design, after);
  if (b0 <= k_no_bending) return fairness;
  const auto [added, lost] = added_and_lost(first, second);
  fairness.design_ratio = bending_of(first) / b0;
  fairness.bending_ratio = bending_of(second) / b0;
  fairness.bending_added = added / b0;
  fairness.bending_lost = lost / b0;
  return fairness;
}

Fairness measure_fairness(const Patch& design, const Patch& after) {
  const double b0 = design_bending(design);  // first, as it takes the most memory
  const double scale = design.unit_scale();
  const auto first = bends_of(design.positions(), design.connectivity(), scale);
  const auto second = bends_of(after.positions(), after.connectivity(), scale);
  Fairness fairness;
  const double usual = usual_curvature(first);
  fairness.sharp_share = sharp_share(second, usual);
  fairness.design_sharp_share = sharp_share(first, usual);
  fairness.height_ratio = height_ratio(design, after.triangles(), after.positions());
  if (b0 == 0.0) return fairness;
  fairness.design_ratio = bending_of(first) / b0;
  fairness.bending_ratio = bending_of(second) / b0;
  return fairness;
}

}  // namespace planish
