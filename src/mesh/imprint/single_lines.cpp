#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <planish/mesh/surface_line.h>

#include "geometry/box.h"
#include "mesh/imprint/shared_triangle.h"

namespace planish {

namespace {

constexpr double k_least_stretch = 6.0;  // tolerances: what merely crosses is shorter

/// Segments one after the other, with a box around them.
struct Rail {
  std::vector<Vec3> points;
  std::optional<std::size_t> line = {};
  Box box = {};

  Rail(std::vector<Vec3> along, std::optional<std::size_t> of)
      : points(std::move(along)), line(of) {
    for (const Vec3 p : points)
      box.add(p);
  }

  bool is_within(Vec3 p, double reach) const {
    if (are_apart(box, {p, p}, reach)) return false;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const Vec3 along = points[i] - points[i - 1], way = p - points[i - 1];
      const double length = dot(along, along);
      const double share = length > 0.0 ? std::clamp(dot(way, along) / length, 0.0, 1.0) : 0.0;
      if (norm(way - share * along) <= reach) return true;
    }
    return false;
  }
};

class Singler {
 public:
  Singler(const Patch& patch, double tolerance)
      : patch_(patch), scale_(patch.unit_scale()), tolerance_(scale_ * tolerance) {
    for (const auto& loop : patch.border_loops()) {
      std::vector<Vec3> points;
      points.reserve(loop.size() + 1);
      for (const Index v : loop)
        points.push_back(scale_ * patch.positions()[v]);
      points.push_back(points.front());
      rails_.emplace_back(std::move(points), std::nullopt);
    }
  }

  void add(const SurfaceLine& line, std::size_t number) {
    const SurfaceLine fine = with_points(line);
    const std::vector<Vec3> places = places_of(fine);
    std::vector<unsigned char> is_left_out(fine.size(), 0);
    for (const Rail& rail : rails_)
      leave_out(rail, places, number, is_left_out);
    std::vector<Rail> own;
    for (std::size_t begin = 0; begin < fine.size();) {
      std::size_t end = begin;
      while (end < fine.size() && is_left_out[end] == is_left_out[begin])
        ++end;
      const auto at = [&](std::size_t i) { return fine.begin() + static_cast<std::ptrdiff_t>(i); };
      const bool is_whole = begin == 0 && end == fine.size();
      const SurfaceLine part = is_whole ? line : SurfaceLine(at(begin), at(end));
      const bool is_long =
          is_whole || scale_ * length_of(part, patch_.positions()) > 2.0 * tolerance_;
      if (is_left_out[begin] == 0 && is_long) {
        result_.lines.push_back(part);
        result_.of.push_back(number);
        own.emplace_back(places_of(part), number);
      }
      begin = end;
    }
    for (Rail& rail : own)
      rails_.push_back(std::move(rail));
  }

  SingleLines lines() { return std::move(result_); }

 private:
  std::vector<Vec3> places_of(const SurfaceLine& line) const {
    std::vector<Vec3> places;
    places.reserve(line.size());
    for (const SurfacePoint& point : line)
      places.push_back(scale_ * position_of(point, patch_.positions()));
    return places;
  }

  /// The line with points no farther apart than the tolerance.
  SurfaceLine with_points(const SurfaceLine& line) const {
    constexpr double most_of_one = 1000.0;
    const std::vector<Vec3> places = places_of(line);
    SurfaceLine fine;
    for (std::size_t i = 0; i < line.size(); ++i) {
      const double steps =
          i == 0 ? 1.0 : std::ceil(norm(places[i] - places[i - 1]) / std::max(tolerance_, 1e-300));
      const auto count = static_cast<std::size_t>(std::clamp(steps, 1.0, most_of_one));
      for (std::size_t k = 1; k < count; ++k) {
        const double share = static_cast<double>(k) / static_cast<double>(count);
        if (const auto point = point_between(patch_, line[i - 1], line[i], share))
          fine.push_back(*point);
      }
      fine.push_back(line[i]);
    }
    return fine;
  }

  void leave_out(const Rail& rail, const std::vector<Vec3>& places, std::size_t number,
                 std::vector<unsigned char>& is_left_out) {
    for (std::size_t begin = 0; begin < places.size();) {
      double length = 0.0;
      std::size_t end = begin;
      while (end < places.size() && is_left_out[end] == 0 &&
             rail.is_within(places[end], tolerance_)) {
        if (end > begin) length += norm(places[end] - places[end - 1]);
        ++end;
      }
      // A line that is all along the border is left, to be refused where it is cut.
      const bool is_border = !rail.line && begin == 0 && end == places.size();
      if (length >= k_least_stretch * tolerance_ && length > 0.0 && !is_border) {
        std::fill(is_left_out.begin() + static_cast<std::ptrdiff_t>(begin),
                  is_left_out.begin() + static_cast<std::ptrdiff_t>(end), 1);
        result_.doubled.push_back({number, rail.line, length / scale_});
      }
      begin = std::max(end, begin + 1);
    }
  }

  const Patch& patch_;
  double scale_, tolerance_;
  std::vector<Rail> rails_;
  SingleLines result_;
};

}  // namespace

SingleLines single_lines(const Patch& patch, std::vector<SurfaceLine> lines, double tolerance) {
  Singler singler(patch, tolerance);
  for (std::size_t l = 0; l < lines.size(); ++l)
    singler.add(lines[l], l);
  return singler.lines();
}

}  // namespace planish
