#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

#include <planish/mesh/carry.h>
#include <planish/mesh/symmetry.h>

#include "mesh/imprint/shared_triangle.h"
#include "mesh/mean_edge.h"
#include "mesh/search/closest_point.h"

namespace planish {

namespace {

/// A point of a line over the plane of symmetry.
struct LinePoint {
  SurfacePoint place;
  double height = 0.0;  ///< 0 on the plane
};

/// A part of a line that does not cross the plane.
struct LinePart {
  SurfaceLine line;
  std::size_t of = 0;
  int side = 0;  ///< 1 above, -1 below, 0 on the plane
};

/// Divides lines at a plane.
class LineDivider {
 public:
  LineDivider(const Patch& patch, const Plane& plane)
      : patch_(patch),
        plane_(plane),
        on_plane_(k_on_plane * bounding_box_diagonal(patch.mesh())),
        near_(0.5 * mean_edge_length(patch.mesh())) {}

  std::vector<LinePart> parts_of(const SurfaceLine& line, std::size_t of) {
    of_ = of;
    parts_.clear();
    open_.clear();
    side_ = 0;
    const std::vector<LinePoint> points = with_crossings(line);
    std::size_t i = 0;
    while (i < points.size()) {
      const std::size_t end = end_of_run(points, i);
      if (end > i) {
        add_run(std::span(points).subspan(i, end - i));
        i = end;
      } else {
        add_point(points[i++]);
      }
    }
    close();
    return std::move(parts_);
  }

 private:
  /// Of the diagonal: what is nearer to the plane is on it.
  static constexpr double k_on_plane = 1e-6;
  /// What runs along the plane for fewer times its largest height only crosses it.
  static constexpr double k_least_run = 4.0;

  std::vector<LinePoint> with_crossings(const SurfaceLine& line) const {
    std::vector<LinePoint> points;
    for (const SurfacePoint& place : line) {
      const double height = height_over(plane_, position_of(place, patch_.positions()));
      const LinePoint point{place, std::abs(height) <= on_plane_ ? 0.0 : height};
      if (!points.empty() && points.back().height * point.height < 0.0) {
        const double before = points.back().height;
        const auto crossing =
            point_between(patch_, points.back().place, place, before / (before - point.height));
        if (crossing) points.push_back({*crossing, 0.0});
      }
      points.push_back(point);
    }
    return points;
  }

  double length_between(const LinePoint& a, const LinePoint& b) const {
    return norm(position_of(a.place, patch_.positions()) -
                position_of(b.place, patch_.positions()));
  }

  /// Behind the points from one on that run along the plane; itself where none do.
  std::size_t end_of_run(const std::vector<LinePoint>& points, std::size_t begin) const {
    double length = 0.0;
    std::size_t end = begin;
    for (; end < points.size() && std::abs(points[end].height) <= near_; ++end) {
      if (end > begin) length += length_between(points[end - 1], points[end]);
    }
    return length >= k_least_run * near_ ? end : begin;
  }

  void add_point(const LinePoint& point) {
    open_.push_back(point.place);
    if (point.height == 0.0) {
      close();
      open_.push_back(point.place);
    } else {
      side_ = point.height > 0.0 ? 1 : -1;
    }
  }

  /// Puts what runs along the plane on it, and leads the line there and away.
  void add_run(std::span<const LinePoint> run) {
    SurfaceLine line;
    for (const LinePoint& point : run)
      line.push_back(point.place);
    const bool is_on = std::all_of(run.begin(), run.end(),
                                   [](const LinePoint& point) { return point.height == 0.0; });
    if (!is_on) line = along_section(std::move(line));
    lead_to(line.front());
    side_ = 0;
    open_ = line;
    close();
    open_ = {line.back()};
  }

  /// The stretch of the section of the mesh with the plane that a line runs along; the line itself
  /// where there is none as near.
  SurfaceLine along_section(SurfaceLine line) {
    if (!sections_) sections_ = plane_section(patch_, plane_, on_plane_);
    const double length = length_of(line, patch_.positions());
    double least = length;
    for (const SurfaceLine& section : *sections_) {
      const SectionPlace first = nearest_on(section, line.front());
      const SectionPlace last = nearest_on(section, line.back());
      if (std::max(first.distance, last.distance) > 2.0 * near_) continue;
      for (SurfaceLine& way : ways_between(section, first, last)) {
        const double longer = std::abs(length_of(way, patch_.positions()) - length);
        if (!(longer < least)) continue;
        least = longer;
        line = std::move(way);
      }
    }
    return line;
  }

  /// A place on a section.
  struct SectionPlace {
    std::size_t end = 0;  ///< of the segment, above 0
    double share = 0.0;   ///< of the segment
    double distance = std::numeric_limits<double>::infinity();
  };

  SectionPlace nearest_on(const SurfaceLine& section, const SurfacePoint& place) const {
    const Vec3 p = position_of(place, patch_.positions());
    SectionPlace nearest;
    for (std::size_t k = 1; k < section.size(); ++k) {
      const Vec3 a = position_of(section[k - 1], patch_.positions());
      const Vec3 along = position_of(section[k], patch_.positions()) - a;
      const double square = dot(along, along);
      const double share = square > 0.0 ? std::clamp(dot(p - a, along) / square, 0.0, 1.0) : 0.0;
      const double distance = norm(p - (a + share * along));
      if (distance < nearest.distance) nearest = {k, share, distance};
    }
    return nearest;
  }

  /// Both where the section is closed.
  std::vector<SurfaceLine> ways_between(const SurfaceLine& section, SectionPlace first,
                                        SectionPlace last) const {
    const auto at = [&](const SectionPlace& place) {
      if (place.share == 0.0) return section[place.end - 1];
      if (place.share == 1.0) return section[place.end];
      return point_between(patch_, section[place.end - 1], section[place.end], place.share)
          .value_or(section[place.end]);
    };
    const bool is_back = std::pair(last.end, last.share) < std::pair(first.end, first.share);
    if (is_back) std::swap(first, last);
    const auto begin = section.begin();
    SurfaceLine inside = {at(first)};
    inside.insert(inside.end(), begin + static_cast<std::ptrdiff_t>(first.end),
                  begin + static_cast<std::ptrdiff_t>(last.end));
    inside.push_back(at(last));
    std::vector<SurfaceLine> ways = {std::move(inside)};
    const bool is_closed = norm(position_of(section.front(), patch_.positions()) -
                                position_of(section.back(), patch_.positions())) == 0.0;
    if (is_closed) {
      SurfaceLine around = {at(first)};
      around.insert(around.end(),
                    std::make_reverse_iterator(begin + static_cast<std::ptrdiff_t>(first.end)),
                    section.rend());
      around.insert(around.end(), section.rbegin() + 1,
                    std::make_reverse_iterator(begin + static_cast<std::ptrdiff_t>(last.end)));
      around.push_back(at(last));
      ways.push_back(std::move(around));
    }
    if (is_back) {
      for (SurfaceLine& way : ways)
        std::reverse(way.begin(), way.end());
    }
    return ways;
  }

  void lead_to(const SurfacePoint& place) {
    if (!open_.empty()) {
      const SurfaceLine way = way_between(open_.back(), place);
      open_.insert(open_.end(), way.begin() + 1, way.end());
    }
    close();
  }

  SurfaceLine way_between(const SurfacePoint& from, const SurfacePoint& to) const {
    if (shared_triangle(patch_, from, to)) return {from, to};
    const DrawnLine drawn{
        {position_of(from, patch_.positions()), position_of(to, patch_.positions())}};
    TracedLines traced = trace_lines(patch_, {{drawn}, {}});
    if (traced.lines.size() != 1) return {from, to};
    traced.lines.front().front() = from;
    traced.lines.front().back() = to;
    return std::move(traced.lines.front());
  }

  void close() {
    if (open_.size() > 1 && length_of(open_, patch_.positions()) > 0.0)
      parts_.push_back({std::move(open_), of_, side_});
    open_.clear();
    side_ = 0;
  }

  const Patch& patch_;
  const Plane& plane_;
  double on_plane_, near_;
  std::optional<std::vector<SurfaceLine>> sections_ = {};
  std::size_t of_ = 0;
  std::vector<LinePart> parts_;
  SurfaceLine open_;  // the part that is being made
  int side_ = 0;
};

/// The mirror images of lines on a mesh.
class LineMirror {
 public:
  LineMirror(const Patch& patch, const Symmetry& symmetry) : patch_(patch), symmetry_(symmetry) {}

  std::vector<SurfaceLine> image_of(const SurfaceLine& line) const {
    if (auto exact = exact_image_of(line)) return {*std::move(exact)};
    DrawnLine drawn;
    for (const SurfacePoint& place : line)
      drawn.points.push_back(mirrored(symmetry_.plane, position_of(place, patch_.positions())));
    return trace_lines(patch_, {{std::move(drawn)}, {}}).lines;
  }

 private:
  std::optional<SurfacePoint> exact_image_of(const SurfacePoint& place) const {
    std::vector<Index> images = carriers_of(place);
    for (Index& v : images)
      v = symmetry_.image[v];
    const auto triangle = triangle_with(patch_, images);
    if (!triangle) return std::nullopt;
    SurfacePoint image{*triangle, {0.0, 0.0, 0.0}};
    for (std::size_t k = 0; k < 3; ++k) {
      if (!(place.shares[k] > 0.0)) continue;
      const auto at =
          std::find(triangle->begin(), triangle->end(), symmetry_.image[place.corners[k]]);
      image.shares[static_cast<std::size_t>(at - triangle->begin())] = place.shares[k];
    }
    return image;
  }

  /// Nothing where a triangle on the way has no image.
  std::optional<SurfaceLine> exact_image_of(const SurfaceLine& line) const {
    if (symmetry_.image.empty()) return std::nullopt;
    SurfaceLine image;
    for (const SurfacePoint& place : line) {
      const auto point = exact_image_of(place);
      if (!point) return std::nullopt;
      if (!image.empty() && !shared_triangle(patch_, image.back(), *point)) return std::nullopt;
      image.push_back(*point);
    }
    return image;
  }

  const Patch& patch_;
  const Symmetry& symmetry_;
};

/// Lines to be near to.
class NearLines {
 public:
  NearLines(const Patch& patch, std::span<const LinePart> parts) {
    TriMesh segments;
    for (const LinePart& part : parts) {
      for (std::size_t i = 0; i < part.line.size(); ++i) {
        const auto here = static_cast<Index>(segments.positions.size());
        segments.positions.push_back(position_of(part.line[i], patch.positions()));
        if (i > 0) segments.triangles.push_back({here - 1, here, here});
      }
    }
    if (!segments.triangles.empty()) tree_.emplace(std::move(segments));
  }

  bool has_near(Vec3 place, double tolerance) const {
    return tree_ && tree_->query(place).squared_distance <= tolerance * tolerance;
  }

 private:
  std::optional<ClosestPointTree> tree_;
};

/// The stretches of parts whose mirror images are not near any of the others.
std::vector<LinePart> without_counterpart(const Patch& patch, std::span<const LinePart> parts,
                                          const NearLines& others, const Plane& plane,
                                          double tolerance) {
  std::vector<LinePart> left;
  for (const LinePart& part : parts) {
    const auto is_near = [&](std::size_t i) {
      return others.has_near(mirrored(plane, position_of(part.line[i], patch.positions())),
                             tolerance);
    };
    std::size_t i = 0;
    while (i < part.line.size()) {
      if (is_near(i)) {
        ++i;
        continue;
      }
      const std::size_t begin = i > 0 ? i - 1 : 0;
      while (i < part.line.size() && !is_near(i))
        ++i;
      const std::size_t end = std::min(i + 1, part.line.size());
      SurfaceLine line(part.line.begin() + static_cast<std::ptrdiff_t>(begin),
                       part.line.begin() + static_cast<std::ptrdiff_t>(end));
      if (length_of(line, patch.positions()) > tolerance)
        left.push_back({std::move(line), part.of, part.side});
    }
  }
  return left;
}

double length_of(const Patch& patch, std::span<const LinePart> parts) {
  double length = 0.0;
  for (const LinePart& part : parts)
    length += length_of(part.line, patch.positions());
  return length;
}

/// Lines by where they lie.
struct DividedLines {
  std::vector<LinePart> above, below, on_plane;
};

DividedLines divided(const Patch& patch, std::span<const SurfaceLine> lines, const Plane& plane) {
  DividedLines divided;
  LineDivider divider(patch, plane);
  for (std::size_t l = 0; l < lines.size(); ++l) {
    for (LinePart& part : divider.parts_of(lines[l], l)) {
      auto& side = part.side > 0 ? divided.above : part.side < 0 ? divided.below : divided.on_plane;
      side.push_back(std::move(part));
    }
  }
  return divided;
}

void add(std::vector<MirroredLine>& lines, std::span<const LinePart> parts) {
  for (const LinePart& part : parts)
    lines.push_back({part.line, part.of, false});
}

}  // namespace

std::vector<MirroredLine> lines_on_side(const Patch& patch, std::span<const SurfaceLine> lines,
                                        const Plane& plane, MirrorSide side) {
  const DividedLines parts = divided(patch, lines, plane);
  std::vector<MirroredLine> result;
  add(result, parts.on_plane);
  add(result, side == MirrorSide::above ? parts.above : parts.below);
  return result;
}

SymmetricLines symmetric_lines(const Patch& patch, std::span<const SurfaceLine> lines,
                               const Symmetry& symmetry, double tolerance) {
  constexpr double k_more = 1.0 + 1e-6;
  const Plane& plane = symmetry.plane;
  DividedLines parts = divided(patch, lines, plane);
  SymmetricLines result;
  std::vector<LinePart>&drawn = parts.above, &others = parts.below;
  const double above = length_of(patch, drawn), below = length_of(patch, others);
  if (above > k_more * below) result.drawn_side = MirrorSide::above;
  if (below > k_more * above) {
    result.drawn_side = MirrorSide::below;
    std::swap(drawn, others);
  }
  const NearLines near_drawn(patch, drawn), near_others(patch, others);
  const std::vector<LinePart> alone =
      without_counterpart(patch, others, near_drawn, plane, tolerance);
  const LineMirror mirror(patch, symmetry);
  const auto add_images = [&](std::span<const LinePart> some) {
    for (const LinePart& part : some) {
      for (SurfaceLine& image : mirror.image_of(part.line))
        result.lines.push_back({std::move(image), part.of, true});
    }
  };
  add(result.lines, parts.on_plane);
  add(result.lines, drawn);
  if (symmetry.image.empty()) {
    add(result.lines, others);
    add_images(without_counterpart(patch, drawn, near_others, plane, tolerance));
  } else {
    add(result.lines, alone);
    add_images(drawn);
  }
  add_images(alone);
  return result;
}

}  // namespace planish
