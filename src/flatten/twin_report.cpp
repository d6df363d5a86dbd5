#include "flatten/twin_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <variant>
#include <vector>

#include "flatten/limit_checks.h"
#include "unfold/strain/free_edges.h"

namespace planish {

namespace {

// With match_seams, of the length of the border: 0.01 mm in a metre.
constexpr double k_most_mismatch = 1e-5;
// Of a limit of strain: what short edges are off by in a file of 32-bit floats.
constexpr double k_file_rounding = 0.01;

/// The patch that is worked on, by the twin's.
struct TwinPatch {
  Patch patch;
  std::vector<Index> source;  // as FlattenReport has it
  std::vector<Index> vertex;  // of the twin's patch -> of this one
};

/// Where the twin was remeshed: over the vertices that correspond to what is left there.
TwinPatch remeshed_alike(const FlattenReport& twin, const Patch& patch, const MeshMatch& match) {
  TwinPatch alike;
  TriMesh mesh;
  for (const Index v : twin.source)
    alike.source.push_back(match.vertex[v]);
  const std::vector<Index> unsorted = alike.source;
  std::sort(alike.source.begin(), alike.source.end());
  for (const Index v : unsorted) {
    const auto found = std::lower_bound(alike.source.begin(), alike.source.end(), v);
    alike.vertex.push_back(static_cast<Index>(found - alike.source.begin()));
  }
  for (const Index v : alike.source)
    mesh.positions.push_back(patch.positions()[v]);
  for (Triangle t : twin.input.triangles()) {
    for (Index& v : t)
      v = alike.vertex[v];
    if (match.mirrored) std::swap(t[1], t[2]);
    mesh.triangles.push_back(t);
  }
  alike.patch = Patch(std::move(mesh));
  return alike;
}

TwinPatch worked_on(const FlattenReport& twin, const Patch& patch, const MeshMatch& match) {
  return twin.source.empty() ? TwinPatch{patch, {}, match.vertex}
                             : remeshed_alike(twin, patch, match);
}

/// Moves are turned, not places: what did not move stays to the bit, so that borders still lie at
/// the same places, and all others are as far from where they were as the twin's.
std::vector<Vec3> moved_alike(const FlattenReport& twin, const TwinPatch& own,
                              const RigidMotion& motion) {
  std::vector<Vec3> positions = own.patch.positions();
  for (std::size_t v = 0; v < own.vertex.size(); ++v) {
    const Vec3 before = twin.input.positions()[v], after = twin.processed.positions()[v];
    if (!(after == before)) positions[own.vertex[v]] += motion.of_direction(after - before);
  }
  return positions;
}

class TwinPattern {
 public:
  TwinPattern(const Patch& patch, const std::vector<Index>& vertex, bool mirrored,
              std::span<const std::array<Index, 2>> free_edges)
      : patch_(patch), vertex_(vertex), mirrored_(mirrored), free_edges_(free_edges) {}

  UnfoldReport of(UnfoldReport report) const {
    Pattern& pattern = report.pattern;
    for (std::vector<Vec2>* places : {&pattern.positions, &pattern.unmatched, &pattern.unlimited})
      *places = laid_alike(*places);
    report.strain = strain_of(pattern.positions);
    report.border_strain = largest_border_strain(patch_, pattern.positions, free_edges_);
    report.overlap = overlap_of(patch_, pattern);
    if (pattern.opened) pattern.opened->vertex = vertex_[pattern.opened->vertex];
    if (report.unmatched_strain) report.unmatched_strain = strain_of(pattern.unmatched);
    if (report.unlimited_strain) report.unlimited_strain = strain_of(pattern.unlimited);
    report.limits = limits_alike(report.limits, pattern.positions);
    return report;
  }

  double mismatch_share(std::span<const Vec2> pattern) const {
    double length = 0.0;
    for (const auto& loop : patch_.border_loops()) {
      for (std::size_t k = 0; k < loop.size(); ++k)
        length +=
            norm(patch_.positions()[loop[(k + 1) % loop.size()]] - patch_.positions()[loop[k]]);
    }
    return border_mismatch(patch_, pattern, free_edges_) / length;
  }

 private:
  std::vector<Vec2> laid_alike(const std::vector<Vec2>& places) const {
    std::vector<Vec2> alike(places.size());
    for (std::size_t v = 0; v < places.size(); ++v)
      alike[vertex_[v]] = mirrored_ ? Vec2{0.0 - places[v].x, places[v].y} : places[v];  // no -0
    return alike;
  }

  /// Those of this mesh, but where only the rounding of its file breaks one: then that of the twin.
  std::vector<StrainLimitCheck> limits_alike(std::span<const StrainLimitCheck> theirs,
                                             std::span<const Vec2> pattern) const {
    auto checks = check_limits(patch_, pattern, asked_for(theirs));
    for (std::size_t k = 0; k < checks.size(); ++k) {
      const double most = (1.0 + k_file_rounding) * checks[k].asked;
      if (checks[k].kept() || !theirs[k].kept() || checks[k].reached > most) continue;
      checks[k].reached = theirs[k].reached;
      checks[k].share_beyond = theirs[k].share_beyond;
    }
    return checks;
  }

  EdgeStrain strain_of(const std::vector<Vec2>& pattern) const {
    return edge_strain(patch_, pattern);
  }

  static StrainLimits asked_for(std::span<const StrainLimitCheck> checks) {
    StrainLimits limits;
    for (const StrainLimitCheck& check : checks)
      limits.of(check.kind) = check.asked;
    return limits;
  }

  Patch patch_;
  const std::vector<Index>& vertex_;
  bool mirrored_;
  std::span<const std::array<Index, 2>> free_edges_;
};

EvolveReport evolved_alike(const EvolveReport& twin, const Patch& original, const Patch& before,
                           const Patch& after) {
  EvolveReport report;
  report.method = twin.method;
  report.stopping = twin.stopping;
  report.result = {after.positions(), twin.result.history, twin.result.stop, twin.result.threads,
                   0.0};
  report.before = measure_patch(before);
  report.after = measure_patch(after);
  report.remeshed_from = twin.remeshed_from;
  if (twin.remeshed_from) {
    report.deviation = measure_surface_deviation(original, after.mesh());
    report.fairness = measure_fairness(original, after);
  } else {
    report.deviation = measure_deviation(before, after.positions());
    report.fairness = measure_fairness(before, after.positions());
  }
  if (twin.border) report.border = measure_border_change(before, after.positions());
  return report;
}

/// False where rounding took from it what the twin has.
bool has_all_of(const FlattenReport& twin, const FlattenReport& own) {
  const std::vector<LimitCheck> theirs = limit_checks(twin), ours = limit_checks(own);
  for (std::size_t k = 0; k < theirs.size(); ++k) {
    if (theirs[k].met && !ours[k].met) return false;
  }
  return own.evolve.after.flattenable || !twin.evolve.after.flattenable;
}

/// What the form hides is alike, but the numbers of each are its own.
std::vector<Caution> cautions_beside(const FlattenReport& twin, const Patch& patch) {
  std::vector<Caution> cautions = twin.cautions;
  std::erase_if(cautions, [](const Caution& caution) {
    return std::holds_alternative<CoarseCoordinates>(caution);
  });
  if (const auto coarse = find_coarse_coordinates(patch)) cautions.emplace_back(*coarse);
  return cautions;
}

bool holds_all(std::span<const Index> source, std::span<const Index> keep) {
  return source.empty() || std::all_of(keep.begin(), keep.end(), [&](Index v) {
           return std::binary_search(source.begin(), source.end(), v);
         });
}

}  // namespace

std::optional<FlattenReport> twin_report(const FlattenReport& twin, const Patch& patch,
                                         const MeshMatch& match, std::string name,
                                         const FlattenOptions& options) {
  TwinPatch own = worked_on(twin, patch, match);
  std::optional<SmoothedFirst> smoothed;
  if (options.smooth_first > 0.0) {
    SmoothedDesign design = smooth_design(patch, options.smooth_first);
    own.patch = design.patch;
    smoothed = design.done;
  }
  if (!holds_all(own.source, options.keep)) return std::nullopt;
  FlattenReport report;
  report.name = std::move(name);
  report.material = options.material;
  report.twin_of = TwinOf{twin.name, match.mirrored};
  report.processed = own.patch.with_positions(moved_alike(twin, own, match.motion));
  report.evolve = evolved_alike(twin.evolve, patch, own.patch, report.processed);
  if (smoothed) report.evolve = with_smoothing(std::move(report.evolve), patch, *smoothed);
  const auto free_edges =
      own.source.empty() ? options.free_edges : renumbered_edges(options.free_edges, own.source);
  const TwinPattern after(report.processed, own.vertex, match.mirrored, free_edges);
  report.unfold = after.of(twin.unfold);
  const TwinPattern before(own.patch, own.vertex, match.mirrored, free_edges);
  report.unfold_before = before.of(twin.unfold_before);
  report.as_designed = before.of(twin.as_designed);
  report.rejected = twin.rejected;
  report.ways = twin.ways;
  report.cautions = cautions_beside(twin, patch);
  if (!has_all_of(twin, report)) return std::nullopt;
  const auto& pattern = report.unfold.pattern.positions;
  const bool is_matched = options.match_seams && !twin.unfold.pattern.is_unmatchable;
  if (is_matched && !(after.mismatch_share(pattern) <= k_most_mismatch)) return std::nullopt;
  report.input = own.patch;
  report.source = std::move(own.source);
  return report;
}

double border_mismatch(const Patch& patch, std::span<const Vec2> pattern,
                       std::span<const std::array<Index, 2>> free_edges) {
  const FreeEdges free(free_edges);
  double most = 0.0;
  for (const std::vector<Index>& loop : patch.border_loops()) {
    const auto is_free = [&](std::size_t k) {
      return free.has(loop[k % loop.size()], loop[(k + 1) % loop.size()]);
    };
    // Begins behind a free edge, if there is one. Of sums from the beginning of a stretch, the
    // largest difference of two is that of a part of it.
    std::size_t first = 0;
    while (first < loop.size() && !is_free(first))
      ++first;
    const bool is_whole = first == loop.size();
    double sum = 0.0, low = 0.0, high = 0.0;
    for (std::size_t k = first; k < first + loop.size(); ++k) {
      if (is_free(k)) {
        sum = low = high = 0.0;
        continue;
      }
      const Index v = loop[k % loop.size()], w = loop[(k + 1) % loop.size()];
      sum += norm(pattern[w] - pattern[v]) - norm(patch.positions()[w] - patch.positions()[v]);
      low = std::min(low, sum);
      high = std::max(high, sum);
      most = std::max(most, high - low);
    }
    if (is_whole) most = std::max(most, std::abs(sum));
  }
  return most;
}

std::string twin_text(const TwinOf& twin) {
  return (twin.mirrored ? "mirror image of " : "equal to ") + twin.name;
}

}  // namespace planish
