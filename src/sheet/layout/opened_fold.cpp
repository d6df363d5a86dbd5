#include <algorithm>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include <planish/core/error.h>
#include <planish/sheet/nest_sheet.h>
#include <planish/sheet/pattern_sheet.h>

#include "core/math.h"
#include "pattern/polygon/border_walk.h"
#include "sheet/annotations.h"
#include "sheet/piece/placed_pattern.h"

namespace planish {

namespace {

/// A half, and where its mirror image in the fold has its vertices.
class FoldedHalf {
 public:
  FoldedHalf(const NestPatch& patch, Unit unit)
      : patch_(patch), half_(placed_pattern(patch.mesh, patch.pattern, unit, patch.name, {})) {
    const EdgeAllowance stretch = fold_stretch(half_.outline, *patch.annotations.fold);
    from_ = stretch.from;
    to_ = stretch.to;
    image_.resize(patch.mesh.positions.size());
    for (const std::vector<Index>& loop : half_.outline.vertices)
      mark_fold(loop);
    Index next = static_cast<Index>(image_.size());
    for (std::size_t v = 0; v < image_.size(); ++v)
      image_[v] = is_on_fold(static_cast<Index>(v)) ? static_cast<Index>(v) : next++;
    count_ = next;
  }

  NestPatch opened() const {
    NestPatch whole = patch_;
    open_mesh(whole);
    whole.annotations = opened_annotations();
    return whole;
  }

 private:
  void mark_fold(const std::vector<Index>& loop) {
    const auto first = std::find(loop.begin(), loop.end(), from_);
    if (first == loop.end()) return;
    on_fold_.assign(image_.size(), false);
    for (auto at = first; *at != to_; at = at + 1 == loop.end() ? loop.begin() : at + 1)
      on_fold_[*at] = true;
    on_fold_[to_] = true;
  }

  bool is_on_fold(Index v) const { return on_fold_[v]; }
  bool is_end(Index v) const { return v == from_ || v == to_; }
  Index image(Index v) const { return image_[v]; }

  void open_mesh(NestPatch& whole) const {
    const Vec2 start = whole.pattern[from_], way = whole.pattern[to_] - start;
    const Vec2 along = 1.0 / norm(way) * way;
    const auto on_line = [&](Vec2 p) { return start + dot(p - start, along) * along; };
    whole.mesh.positions.resize(count_);
    whole.pattern.resize(count_);
    for (Index v = 0; v < image_.size(); ++v) {
      const Vec2 p = whole.pattern[v], foot = on_line(p);
      if (is_on_fold(v)) {
        if (!is_end(v)) whole.pattern[v] = foot;
        continue;
      }
      whole.pattern[image(v)] = foot + (foot - p);
      whole.mesh.positions[image(v)] = whole.mesh.positions[v];
    }
    for (const Triangle& t : patch_.mesh.triangles)
      whole.mesh.triangles.push_back({image(t[0]), image(t[2]), image(t[1])});
  }

  [[noreturn]] void refuse_notch(Index vertex) const {
    throw Error(ErrorCode::misplaced_notch,
                "piece \"" + patch_.name + "\": the notch at vertex " + std::to_string(vertex) +
                    " is on the fold, which lies inside of the piece where it is opened out on "
                    "the sheet; leave it out, or mark the place with --marks",
                {.path = {}, .first = vertex});
  }

  /// A share of the border becomes a vertex or a place on an edge, as those have mirror images.
  Notch with_vertices(Notch notch) const {
    if (notch.edge) return notch;
    const Polygon& loop = half_.outline.loops.front();
    const std::vector<Index>& vertices = half_.outline.vertices.front();
    const BorderWalk walk(loop);
    const double way = notch.fraction * walk.length();
    std::size_t k = 0;
    while (k + 1 < loop.size() && walk.way_to(k + 1) <= way)
      ++k;
    const double length = walk.way_to(k + 1) - walk.way_to(k);
    const double along = length > 0.0 ? std::clamp((way - walk.way_to(k)) / length, 0.0, 1.0) : 0.0;
    const Index next = vertices[(k + 1) % vertices.size()];
    const bool is_inside = along > 0.0 && along < 1.0;
    notch.edge = {along < 1.0 ? vertices[k] : next, along > 0.0 ? next : vertices[k]};
    notch.fraction = is_inside ? along : 0.0;
    return notch;
  }

  void add_notch(const Notch& asked, std::vector<Notch>& notches) const {
    const Notch notch = with_vertices(asked);
    notches.push_back(notch);
    Notch other = notch;
    const auto [from, to] = *notch.edge;
    if (is_on_fold(from) && is_on_fold(to)) {
      if (from != to || !is_end(from)) refuse_notch(from);
      return;
    }
    other.edge = {image(from), image(to)};
    notches.push_back(other);
  }

  /// Stretches of one width, but for the fold, on both sides.
  std::vector<EdgeAllowance> opened_allowances(const std::vector<EdgeAllowance>& edges) const {
    constexpr double k_usual = -1.0;
    std::vector<EdgeAllowance> opened;
    if (edges.empty()) return opened;
    const Allowance all = with_edge_allowances({.width = k_usual}, half_.outline, edges);
    for (std::size_t l = 0; l < all.edge_widths.size(); ++l) {
      const std::vector<Index>& loop = half_.outline.vertices[l];
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const Index a = loop[k], b = loop[(k + 1) % loop.size()];
        const double width = all.edge_widths[l][k];
        const bool is_hem = !all.hems.empty() && all.hems[l][k] != 0;
        if (width == k_usual || is_hem || (is_on_fold(a) && is_on_fold(b))) continue;
        opened.push_back({a, b, width});
        opened.push_back({image(b), image(a), width});
      }
    }
    for (const EdgeAllowance& edge : edges) {
      if (edge.is_hem) add_hem(edge, opened);
      if (!edge.takes_darts) continue;
      opened.push_back(edge);
      EdgeAllowance other = edge;
      other.from = image(edge.to);
      other.to = image(edge.from);
      opened.push_back(other);
    }
    return opened;
  }

  /// Adds a hem and its mirror image. A hem that ends at the fold and its image become one hem.
  void add_hem(const EdgeAllowance& hem, std::vector<EdgeAllowance>& opened) const {
    EdgeAllowance whole = hem, other = hem;
    other.from = image(hem.to);
    other.to = image(hem.from);
    if (is_on_fold(hem.to)) whole.to = image(hem.from);
    if (is_on_fold(hem.from)) whole.from = image(hem.to);
    opened.push_back(whole);
    if (!is_on_fold(hem.from) && !is_on_fold(hem.to)) opened.push_back(other);
  }

  SurfacePoint image(SurfacePoint place) const {
    for (Index& v : place.corners)
      v = image(v);
    return place;
  }

  bool is_on_fold(const SurfacePoint& place) const {
    bool is_on = true;
    for (std::size_t i = 0; i < 3; ++i)
      is_on = is_on && (place.shares[i] == 0.0 || is_on_fold(place.corners[i]));
    return is_on;
  }

  template <class Place>
  void add_images(std::vector<std::vector<Place>>& lines) const {
    const std::size_t count = lines.size();
    for (std::size_t i = 0; i < count; ++i) {
      std::vector<Place> other = lines[i];
      const bool is_its_own = std::all_of(other.begin(), other.end(),
                                          [&](const Place& place) { return is_on_fold(place); });
      if (is_its_own) continue;
      for (Place& place : other)
        place = image(place);
      lines.push_back(std::move(other));
    }
  }

  void add_images(std::vector<Mark>& marks) const {
    const std::size_t count = marks.size();
    for (std::size_t i = 0; i < count; ++i) {
      Mark other = marks[i];
      if (other.place ? is_on_fold(*other.place) : is_on_fold(other.vertex)) continue;
      other.vertex = image(other.vertex);
      if (other.place) other.place = image(*other.place);
      marks.push_back(other);
    }
  }

  PatternOptions opened_annotations() const {
    PatternOptions own = patch_.annotations;
    if (own.grain && std::holds_alternative<Vec3>(*own.grain)) {
      const Vec2 grain = grain_on_sheet(*own.grain, patch_.mesh, half_);
      own.grain = 180.0 / std::numbers::pi * math::atan2(grain.y, grain.x);
    }
    own.fold = FoldLine{from_, to_, true};
    own.like.reset();
    std::vector<Notch> notches;
    for (const Notch& notch : own.notches)
      add_notch(notch, notches);
    own.notches = std::move(notches);
    const double usual = own.allowance ? own.allowance->width : 0.0;
    for (const EdgeAllowance& edge : allowances_of_edges(half_.outline, own.edges, usual))
      own.edge_allowances.push_back(edge);
    own.edges.clear();
    own.edge_allowances = opened_allowances(own.edge_allowances);
    add_images(own.marks);
    add_images(own.inner_lines);
    add_images(own.drawn_lines);
    const std::vector<SeamNumber> numbers = own.seam_numbers;
    for (const SeamNumber& seam : numbers) {
      if (is_on_fold(seam.vertex)) continue;
      own.seam_numbers.push_back(seam);
      own.seam_numbers.back().vertex = image(seam.vertex);
    }
    return own;
  }

  const NestPatch& patch_;
  PatternGeometry half_;
  Index from_ = 0, to_ = 0;
  std::vector<bool> on_fold_;
  std::vector<Index> image_;  // of each vertex of the half
  Index count_ = 0;
};

}  // namespace

std::vector<NestPatch> with_folds_opened(std::vector<NestPatch> patches, Unit unit) {
  for (NestPatch& patch : patches) {
    if (patch.annotations.is_half() && !patch.pattern.empty())
      patch = FoldedHalf(patch, unit).opened();
  }
  return patches;
}

Drawing sheet_to_cut(const TriMesh& mesh, const UnfoldReport& unfold,
                     const PatternGeometry& pattern) {
  const PatternOptions& options = pattern.options;
  if (!options.is_half() || !options.open_fold) return pattern_sheet(mesh, unfold, pattern);
  const NestPatch half{pattern.name, mesh, unfold.pattern.positions, options};
  NestPatch whole = FoldedHalf(half, unfold.unit).opened();
  UnfoldReport of_whole = unfold;
  of_whole.pattern.positions = std::move(whole.pattern);
  return pattern_sheet(
      whole.mesh, of_whole,
      pattern_geometry(whole.mesh, of_whole, pattern.name, std::move(whole.annotations)));
}

}  // namespace planish
