#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <planish/mesh/inspect.h>
#include <planish/unfold/unfold.h>

#include "core/job.h"
#include "core/neumaier_sum.h"
#include "mesh/match/symmetric_whole.h"
#include "unfold/disk/disk.h"
#include "unfold/disk_images.h"
#include "unfold/open_border.h"
#include "unfold/placement.h"
#include "unfold/start/start.h"
#include "unfold/strain/free_edges.h"
#include "unfold/stretch/least_stretch.h"
#include "unfold/stretch/matched_border.h"
#include "unfold/stretch/open_holes.h"
#include "unfold/stretch/seam_system.h"
#include "unfold/stretch/spread_stretch.h"
#include "unfold/unfold_within_limits.h"

namespace planish {

namespace {

/// Above, the sparse factor takes more than some 5 GB.
constexpr std::size_t k_most_vertices = 2'000'000;

/// Starts of a disk, perhaps with holes, from those of one without.
class Starts {
 public:
  /// @param disk must outlive it, as must the pool
  Starts(const Patch& patch, const Disk& disk, ThreadPool& pool)
      : disk_(disk), filled_(with_holes_filled(disk, patch)), pool_(pool) {}

  /// The conformal start where it is sound, else one that always is.
  std::vector<Vec2> find() const {
    std::vector<Vec2> flat = of_disk(conformal_start(without_holes(), pool_));
    if (is_sound(flat)) return flat;
    flat = of_disk(tutte_start(without_holes(), pool_));
    if (is_sound(flat)) return flat;
    throw Error(ErrorCode::unfold_failed,
                "the patch cannot be laid flat: its inner vertices come too close together when "
                "the border is spread out; cut it, or remesh it more evenly");
  }

  /// With open holes, where those of least stretch cross themselves: see with_open_holes().
  std::optional<LeastStretch> with_holes_open(int max_iterations,
                                              const std::function<void()>& after_step) const {
    if (!filled_) return std::nullopt;
    std::vector<Vec2> flat = conformal_start(*filled_, pool_);
    if (flat.empty() || !all_upright(*filled_, flat)) flat = tutte_start(*filled_, pool_);
    if (!all_upright(*filled_, flat)) return std::nullopt;
    return with_open_holes(disk_, *filled_, std::move(flat), max_iterations, pool_, after_step);
  }

  /// With the outer border on a circle; nothing where that is not sound.
  std::optional<std::vector<Vec2>> on_circle(const BorderLengths& lengths) const {
    const auto outer = std::span(lengths.of_edges).first(disk_.outer_border().size());
    std::vector<Vec2> flat = of_disk(circle_start(without_holes(), outer, pool_));
    if (!is_sound(flat)) return std::nullopt;
    return flat;
  }

 private:
  const Disk& without_holes() const { return filled_ ? *filled_ : disk_; }

  std::vector<Vec2> of_disk(std::vector<Vec2> flat) const {
    if (!flat.empty()) flat.resize(disk_.vertex_count);
    return flat;
  }

  bool is_sound(const std::vector<Vec2>& flat) const {
    return !flat.empty() && all_upright(disk_, flat) && holes_are_open(disk_, flat);
  }

  const Disk& disk_;
  std::optional<Disk> filled_;
  ThreadPool& pool_;
};

/// @throws Error option_out_of_range
void require_lengths(std::span<const EdgeLength> lengths) {
  for (const EdgeLength& edge : lengths) {
    if (!(edge.length > 0.0 && std::isfinite(edge.length)))
      throw Error(ErrorCode::option_out_of_range, "an edge of a seam must get a length above 0");
  }
}

/// Those that border edges have in the mesh, or get.
BorderLengths wanted_lengths(const TriMesh& mesh, const Disk& disk, const UnfoldOptions& options) {
  BorderLengths lengths{border_lengths(mesh, disk)};
  if (options.free_edges.empty() && options.seam_lengths.empty()) return lengths;
  std::map<std::array<Index, 2>, double> given;
  for (const auto& [edge, length] : options.seam_lengths)
    given[lower_first(edge[0], edge[1])] = disk.area_scale * (disk.box_scale * length);
  const FreeEdges free(options.free_edges);
  for (std::size_t k = 0; k < disk.border.size(); ++k) {
    const auto [from, to] = disk.border_edge(k);
    const Index v = disk.vertex_of[from], w = disk.vertex_of[to];
    lengths.is_free.push_back(free.has(v, w) ? 1 : 0);
    if (const auto found = given.find(lower_first(v, w)); found != given.end())
      lengths.of_edges[k] = found->second;
  }
  return lengths;
}

/// Goes on from the pattern of least stretch to the one that keeps the border's lengths; nothing
/// where none is found.
std::optional<LeastStretch> with_matched_border(const Disk& disk, const Starts& starts,
                                                const HeldBorder& border, const LeastStretch& least,
                                                int max_iterations, ThreadPool& pool,
                                                const std::function<void()>& after_step) {
  int steps = least.iterations;
  const auto count = [&] {
    ++steps;
    after_step();
  };
  MatchedBorder matched = match_border(disk, border, least.flat, max_iterations, pool, count);
  if (!matched.matched) {
    if (auto start = starts.on_circle(border.lengths))
      matched = match_border(disk, border, *std::move(start), max_iterations, pool, count);
  }
  if (!matched.matched) return std::nullopt;
  matched.result.iterations = steps;
  return std::move(matched.result);
}

/// @throws Error unless the seams need not match
void leave_unmatched(const UnfoldOptions& options) {
  if (options.match_if_possible) return;
  throw Error(ErrorCode::unfold_failed,
              "the border cannot keep its lengths in the plane to within rounding; remesh the "
              "patch more evenly, or do without matched seams");
}

// A limit of rms strain is aimed at a little below, so that rounding keeps it.
constexpr double k_within_limit = 0.9999;

/// Goes on from the pattern of least stretch to the one that spreads it. Limits that are kept stay
/// so.
LeastStretch with_stretch_spread(const TriMesh& mesh, const Disk& disk, StretchSystem& system,
                                 const LeastStretch& least, const StrainLimits& limits,
                                 const std::function<void()>& after_step) {
  const std::vector<FlatEdge> edges = flat_edges(mesh, disk);
  const std::vector<double> strains = strains_of(edges, least.flat);
  const double rms = rms_strain(edges, strains);
  double most = k_spread_budget * rms;
  if (limits.rms > 0.0) most = std::min(most, k_within_limit * limits.rms);
  if (!(most >= rms)) return least;
  LeastStretch spread = spread_stretch(disk, system, edges, least, most, after_step);
  if (!limits.bounds_edges()) return spread;
  StrainLimits of_edges = limits;
  of_edges.rms = 0.0;
  const auto keeps = [&](const LeastStretch& some) {
    return of_edges.kept_by(figures_of(with_areas(edges, strains_of(edges, some.flat))));
  };
  return keeps(least) && !keeps(spread) ? least : spread;
}

/// Goes on from a pattern of least stretch that misses a limit of the rms towards one that keeps
/// it.
LeastStretch within_rms(const TriMesh& mesh, const Disk& disk, StretchSystem& system,
                        const LeastStretch& least, double limit,
                        const std::function<void()>& after_step) {
  const std::vector<FlatEdge> edges = flat_edges(mesh, disk);
  const double most = k_within_limit * limit;
  if (rms_strain(edges, strains_of(edges, least.flat)) <= most) return least;
  return lower_rms(disk, system, edges, least, most, after_step);
}

/// What is called after each step. Laying flat takes some 15 steps, keeping limits or the border
/// some 60.
std::function<void()> unfolding_steps(const Context& context, double of_rest) {
  return [context, progress = StepProgress(of_rest)]() mutable {
    report_progress(context, {"unfolding", progress.after_step()});
  };
}

/// Of the square root of the patch's area: more is no hair, whatever the unit.
constexpr double k_most_opened = 1e-3;

constexpr double k_step_of_stretch = 0.1, k_step_of_limits = 0.03;

/// A length or place of the disk in model units.
Vec2 in_model_units(const Disk& disk, Vec2 p) {
  const Vec2 scaled = (1.0 / disk.box_scale) * ((1.0 / disk.area_scale) * p);
  if (!std::isfinite(scaled.x) || !std::isfinite(scaled.y)) {
    throw Error(ErrorCode::unfold_failed, "unfolding led to numbers that are not finite");
  }
  return scaled;
}

/// The disk in model units, by the numbers of the mesh.
std::vector<Vec2> in_mesh_order(const Patch& patch, const Disk& disk,
                                const std::vector<Vec2>& flat) {
  std::vector<Vec2> positions(patch.vertex_count());
  for (std::size_t v = 0; v < disk.vertex_count; ++v)
    positions[disk.vertex_of[v]] = in_model_units(disk, flat[v]);
  return positions;
}

std::optional<PatternHoles> holes_of(const Patch& patch, const Disk& disk) {
  if (disk.hole_count() == 0) return std::nullopt;
  PatternHoles holes{disk.hole_count(), 0.0};
  const std::vector<double> sides = border_lengths(patch.mesh(), disk);
  for (std::size_t hole = 1; hole < disk.loops.count(); ++hole) {
    double length = 0.0;
    for (std::size_t k = disk.loops.begin(hole); k < disk.loops.end(hole); ++k)
      length += sides[k];
    holes.longest = std::max(holes.longest, in_model_units(disk, {length, 0.0}).x);
  }
  return holes;
}

/// The pattern with its positions, which begin in the units of the disk.
Pattern placed(Pattern pattern, const Patch& patch, const Disk& disk, std::vector<Vec2> flat) {
  const std::vector<Vec2> outline = border_of(disk, flat);
  const std::vector<Vec2> places = place_in_smallest_box(std::move(flat), outline);
  NeumaierSum area;
  for (const Triangle& t : disk.triangles) {
    const double doubled = doubled_area(t, places);
    area.add(0.5 * doubled);
    if (!(doubled > 0.0)) ++pattern.flipped_triangles;
  }
  pattern.area_ratio = area.value();  // the disk has area 1
  pattern.holes = holes_of(patch, disk);
  pattern.positions.resize(patch.vertex_count());
  for (std::size_t v = 0; v < places.size(); ++v) {
    const Vec2 p = in_model_units(disk, places[v]);
    pattern.positions[disk.vertex_of[v]] = p;
    pattern.width = std::max(pattern.width, p.x);
    pattern.height = std::max(pattern.height, p.y);
  }
  return pattern;
}

/// By the numbers of the disk, in its units.
std::vector<Vec2> in_disk_units(const Disk& disk, std::span<const Vec2> positions) {
  std::vector<Vec2> flat;
  flat.reserve(disk.vertex_count);
  for (const Index v : disk.vertex_of)
    flat.push_back(disk.area_scale * (disk.box_scale * positions[v]));
  return flat;
}

/// The steps of unfolding a patch.
class Unfolding {
 public:
  /// All must outlive it.
  Unfolding(const Patch& patch, const Disk& disk, const UnfoldOptions& options,
            const DiskImages& images, const Starts& starts, ThreadPool& pool)
      : patch_(patch),
        disk_(disk),
        options_(options),
        images_(images),
        starts_(starts),
        pool_(pool) {}

  /// The layout of least stretch, whose holes do not cross themselves where that can be.
  LeastStretch with_least_stretch(PartsOfJob& parts) {
    const bool goes_on = options_.match_seams || options_.limits.any() || !options_.least_stretch;
    std::vector<Vec2> start = with_images(disk_, starts_.find(), images_);
    pool_.stop_if_cancelled();
    system_ = make_system(disk_, nullptr, pool_);
    pool_.stop_if_cancelled();
    LeastStretch flat =
        minimise_stretch(disk_, *system_, std::move(start), options_.max_iterations,
                         unfolding_steps(parts.next(goes_on ? 0.2 : 1.0), k_step_of_stretch));
    if (holes_cross(disk_, flat.flat)) {
      const auto step = unfolding_steps(parts.next(0.5), k_step_of_stretch);
      if (auto open = starts_.with_holes_open(options_.max_iterations, step))
        flat = *std::move(open);
    }
    flat.flat = with_images(disk_, std::move(flat.flat), images_);
    // What follows has its own; both at once would take twice the memory.
    if (options_.match_seams || options_.limits.bounds_edges()) system_.reset();
    return flat;
  }

  /// Makes the border as long as seams want it; none where that cannot be.
  std::optional<HeldBorder> match_seams(LeastStretch& flat, Pattern& pattern,
                                        const std::function<void()>& after_step) const {
    HeldBorder border(disk_, wanted_lengths(patch_.mesh(), disk_, options_), flat.flat);
    auto matched = with_matched_border(disk_, starts_, border, flat, options_.max_iterations, pool_,
                                       after_step);
    if (!matched) {
      leave_unmatched(options_);
      pattern.is_unmatchable = true;
      return std::nullopt;
    }
    pattern.unmatched_least_stretch = in_mesh_order(patch_, disk_, flat.flat);
    flat = *std::move(matched);
    return border;
  }

  /// From the layout of least stretch on within the limits, or with its stretch spread; the same
  /// where neither asks for a step.
  LeastStretch as_asked(const LeastStretch& flat, const HeldBorder* held,
                        const std::function<void()>& after_step) {
    const TriMesh& mesh = patch_.mesh();
    const StrainLimits& limits = options_.limits;
    LeastStretch other = flat;
    if (limits.bounds_edges()) {
      other = unfold_within_limits(mesh, disk_, held, flat, limits, options_.max_iterations, pool_,
                                   after_step);
    }
    const bool keeps_rms = !limits.bounds_edges() && limits.rms > 0.0;
    if (!keeps_rms && options_.least_stretch) return other;
    if (!keeps_rms && other.iterations != flat.iterations) return other;
    if (!system_) system_ = make_system(disk_, held, pool_);
    if (keeps_rms) other = within_rms(mesh, disk_, *system_, flat, limits.rms, after_step);
    if (!options_.least_stretch && other.iterations == flat.iterations)
      other = with_stretch_spread(mesh, disk_, *system_, flat, limits, after_step);
    return other;
  }

  /// Moves crossings of the border by a hair apart.
  void open_crossings(std::vector<Vec2>& flat, Pattern& pattern) const {
    const double wanted = disk_.area_scale * (disk_.box_scale * options_.open_crossings);
    std::optional<OpenBorder> open = open_border(disk_, flat, std::min(wanted, k_most_opened));
    if (!open) return;
    flat = with_images(disk_, std::move(open->flat), images_);
    pattern.overlaps = !images_.of.empty() && border_crosses_itself(disk_, flat);
    pattern.opened = {open->crossings, in_model_units(disk_, {open->largest_move, 0.0}).x,
                      disk_.vertex_of[open->vertex]};
  }

 private:
  const Patch& patch_;
  const Disk& disk_;
  const UnfoldOptions& options_;
  const DiskImages& images_;
  const Starts& starts_;
  ThreadPool& pool_;
  std::unique_ptr<StretchSystem> system_ = nullptr;
};

/// How the whole of a half is unfolded as the options say of the half.
UnfoldOptions of_whole(UnfoldOptions options, const SymmetricWhole& whole) {
  options.fold.reset();
  options.symmetric_in = whole.plane;
  const std::vector<std::array<Index, 2>> edges = options.free_edges;
  for (const std::array<Index, 2>& edge : edges)
    options.free_edges.push_back({whole.image[edge[0]], whole.image[edge[1]]});
  const std::vector<EdgeLength> lengths = options.seam_lengths;
  for (const auto& [edge, length] : lengths)
    options.seam_lengths.push_back({{whole.image[edge[0]], whole.image[edge[1]]}, length});
  return options;
}

/// The half of the pattern of its whole.
Pattern unfold_half(const Patch& half, const SymmetricWhole& whole, const UnfoldOptions& options,
                    const Context& context) {
  Pattern pattern = unfold(whole.patch, of_whole(options, whole), context);
  const auto of_half = [&](std::vector<Vec2>& positions) {
    if (!positions.empty()) positions.resize(half.vertex_count());
  };
  of_half(pattern.unmatched_least_stretch);
  of_half(pattern.least_stretch);
  if (pattern.opened && pattern.opened->vertex >= half.vertex_count()) {
    const auto found = std::find(whole.image.begin(), whole.image.end(), pattern.opened->vertex);
    pattern.opened->vertex = static_cast<Index>(found - whole.image.begin());
  }
  const Disk disk = make_disk(half);
  std::vector<Vec2> flat = in_disk_units(disk, pattern.positions);
  pattern.overlaps = pattern.overlaps || border_crosses_itself(disk, flat);
  pattern.width = pattern.height = 0.0;
  pattern.flipped_triangles = 0;
  return placed(std::move(pattern), half, disk, std::move(flat));
}

}  // namespace

void require_unfoldable(const Patch& patch) {
  require(patch.inspection(), Purpose::unfold);
  if (patch.vertex_count() > k_most_vertices) {
    throw Error(ErrorCode::too_large, "patterns are made of patches of up to " +
                                          std::to_string(k_most_vertices) +
                                          " vertices; simplify the mesh");
  }
}

Pattern unfold(const Patch& patch, const UnfoldOptions& options, const Context& context) {
  require_unfoldable(patch);
  require(options.limits);
  require_lengths(options.seam_lengths);
  if (options.fold) {
    if (const auto whole = symmetric_whole(patch, *options.fold))
      return unfold_half(patch, *whole, options, context);
  }
  ThreadPool pool(context);
  pool.stop_if_cancelled();
  const Disk disk = make_disk(patch);
  pool.stop_if_cancelled();
  const DiskImages images = images_in(patch, disk, options.symmetric_in);
  const Starts starts(patch, disk, pool);
  Unfolding work{patch, disk, options, images, starts, pool};
  PartsOfJob parts(context);
  LeastStretch flat = work.with_least_stretch(parts);
  const std::function<void()> after_step = unfolding_steps(parts.next(1.0), k_step_of_limits);
  Pattern pattern;
  const std::optional<HeldBorder> border =
      options.match_seams ? work.match_seams(flat, pattern, after_step) : std::nullopt;
  const HeldBorder* held = border ? &*border : nullptr;
  LeastStretch other = work.as_asked(flat, held, after_step);
  if (other.iterations > flat.iterations) {
    pattern.least_stretch = in_mesh_order(patch, disk, flat.flat);
    flat = std::move(other);
  }
  flat.flat = with_images(disk, std::move(flat.flat), images);
  pattern.iterations = flat.iterations;
  pattern.converged = flat.converged;
  pattern.overlaps = border_crosses_itself(disk, flat.flat);
  if (pattern.overlaps) work.open_crossings(flat.flat, pattern);
  return placed(std::move(pattern), patch, disk, std::move(flat.flat));
}

double smallest_limit(const Patch& patch, const Pattern& least, const Context& context) {
  ThreadPool pool(context);
  pool.stop_if_cancelled();
  const Disk disk = make_disk(patch);
  pool.stop_if_cancelled();
  return smallest_limit_of(patch.mesh(), disk, in_disk_units(disk, least.positions),
                           UnfoldOptions{}.max_iterations, pool,
                           unfolding_steps(context, k_step_of_limits));
}

TriMesh flat_mesh(const TriMesh& mesh, const Pattern& pattern) {
  TriMesh flat;
  flat.triangles = mesh.triangles;
  flat.positions.reserve(pattern.positions.size());
  for (const Vec2 p : pattern.positions)
    flat.positions.push_back({p.x, p.y, 0.0});
  return flat;
}

}  // namespace planish
