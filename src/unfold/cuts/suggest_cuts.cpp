#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include <planish/core/range.h>
#include <planish/unfold/suggest_cuts.h>

#include "core/job.h"
#include "mesh/coarsen/coarsen.h"
#include "mesh/cut/inside_paths.h"
#include "unfold/cuts/dart_tips.h"
#include "unfold/cuts/disk_cuts.h"

namespace planish {

namespace {

constexpr std::size_t k_most_tips = 4;  // each with two ways to the border at most
constexpr double k_least_gain = 0.05;   // of the rms strain, that a dart must take off
constexpr double k_as_good = 0.05;      // of the least rms strain: then the shorter dart wins
constexpr double k_branching = 1.2;     // what a dart that branches counts for
constexpr double k_sliver = 0.05;       // between cuts, over the bounding box's diagonal
constexpr int k_halvings = 4;           // when the last dart is made shorter
constexpr double k_cannot_lie_flat = std::numeric_limits<double>::infinity();

/// A pattern with its strain; what cannot be laid flat has no positions and infinite strain.
struct Flat {
  Pattern pattern;
  EdgeStrain strain;
};

/// A patch that darts are tried on.
struct TrialPatch {
  Patch patch;
  std::vector<Index> source;  ///< vertex -> vertex of the patch that is cut
};

struct Dart {
  std::vector<Index> path;  ///< from the border to the tip
  double length = 0.0;
  bool branches = false;  ///< begins at another cut, not at the border of the input mesh
  Flat flat = {};         ///< of the trial patch with it

  double weight() const { return branches ? k_branching : 1.0; }
  double weighed_length() const { return weight() * length; }
  double weighed_strain() const { return weight() * flat.strain.rms; }
};

TrialPatch trial_patch(const Patch& patch, std::size_t vertices) {
  if (patch.vertex_count() > vertices && can_be_coarsened(patch)) {
    CoarsePatch coarse = coarsen(patch, vertices, CoarseBorder::thinned);
    return {Patch(std::move(coarse.mesh)), std::move(coarse.source)};
  }
  TrialPatch same{patch, std::vector<Index>(patch.vertex_count())};
  std::iota(same.source.begin(), same.source.end(), Index{0});
  return same;
}

/// From each tip the shortest way to the border, and the shortest to the border of the mesh as it
/// came, where that is another. Tips close to another cut are passed over: what is left between the
/// two would be a sliver.
std::vector<Dart> darts_from(const Patch& patch, const std::function<bool(Index)>& on_old_border) {
  InsidePaths inside(patch);
  const auto dart_to = [&](Index tip, const std::function<bool(Index)>& is_end) {
    std::vector<Index> path =
        inside.from(std::span(&tip, 1), is_end).value_or(std::vector<Index>{});
    std::reverse(path.begin(), path.end());
    const double length = path_length(path, patch.positions());
    const bool branches = !path.empty() && !on_old_border(path.front());
    return Dart{std::move(path), length, branches};
  };
  const auto on_border = [&](Index v) { return patch.is_border(v); };
  const auto on_both = [&](Index v) { return on_border(v) && on_old_border(v); };
  const double sliver = k_sliver * bounding_box_diagonal(patch.mesh());
  std::vector<Dart> darts;
  for (const DartTip& peak : dart_tips(patch, k_most_tips)) {
    const Index tip = peak.vertex;
    Dart nearest = dart_to(tip, on_border);
    if (nearest.path.empty() || (nearest.branches && nearest.length < sliver)) continue;
    const bool branches = nearest.branches;
    darts.push_back(std::move(nearest));
    if (!branches) continue;
    Dart other = dart_to(tip, on_both);
    if (!other.path.empty()) darts.push_back(std::move(other));
  }
  return darts;
}

EdgeStrain cannot_lie_flat() {
  constexpr double all = k_cannot_lie_flat;
  return {.max = all,
          .rms = all,
          .p99 = all,
          .max_stretch = all,
          .p99_stretch = all,
          .max_compression = all,
          .p99_compression = all};
}

bool gains(const EdgeStrain& strain, const EdgeStrain& before) {
  return strain.rms < (1.0 - k_least_gain) * before.rms;
}

/// Of the darts that keep the limit the shortest; where none does, of those with about the least
/// strain the shortest. Nothing where there are none.
const Dart* best_of(const std::vector<Dart>& darts, const SuggestOptions& options) {
  const bool any_meets = std::any_of(darts.begin(), darts.end(), [&](const Dart& dart) {
    return options.limits.kept_by(dart.flat.strain);
  });
  const auto least = std::min_element(darts.begin(), darts.end(), [](const Dart& a, const Dart& b) {
    return a.weighed_strain() < b.weighed_strain();
  });
  const Dart* best = nullptr;
  for (const Dart& dart : darts) {
    const bool good = any_meets
                          ? options.limits.kept_by(dart.flat.strain)
                          : dart.weighed_strain() <= (1.0 + k_as_good) * least->weighed_strain();
    if (good && (best == nullptr || dart.weighed_length() < best->weighed_length())) best = &dart;
  }
  return best;
}

class CutSearch {
 public:
  CutSearch(const Patch& patch, const SuggestOptions& options, const Context& context)
      : patch_(patch), options_(options), context_(context), unfolding_{1, {}, [this] {
                                                                          return is_cancelled();
                                                                        }} {}

  CutSuggestion run() {
    open_to_disk();
    found_.stop = is_met(found_.last.strain) ? SuggestStop::strain_met : SuggestStop::dart_limit;
    for (int dart = 0; dart < options_.max_darts && !is_met(found_.last.strain); ++dart) {
      share_ = static_cast<double>(dart) / options_.max_darts;
      if (const auto why_none = add_dart()) {
        found_.stop = *why_none;
        break;
      }
    }
    if (is_met(found_.last.strain)) found_.stop = SuggestStop::strain_met;
    return std::move(found_);
  }

 private:
  bool is_met(const EdgeStrain& strain) const { return options_.limits.kept_by(strain); }

  bool is_cancelled() const { return context_.is_cancelled && context_.is_cancelled(); }

  Flat flatten(const Patch& patch, const StrainLimits& limits = {}) {
    Flat flat{{}, cannot_lie_flat()};
    try {
      flat.pattern = unfold(patch, {.least_stretch = true, .limits = limits}, unfolding_);
      flat.strain = edge_strain(patch, flat.pattern.positions);
    } catch (const Error& error) {
      if (error.code() != ErrorCode::unfold_failed) throw;
    }
    return flat;
  }

  /// The mesh cut along all paths, laid flat: with least stretch, or evened out where only that
  /// keeps the limit.
  CutPattern with_paths() {
    CutMesh cut = cut_along(patch_, paths_);
    const Patch patch(cut.mesh);
    Flat flat = flatten(patch);
    if (!flat.pattern.positions.empty() && !is_met(flat.strain)) {
      Flat even = flatten(patch, options_.limits);
      if (is_met(even.strain)) flat = std::move(even);
    }
    return {std::move(cut), std::move(flat.pattern), flat.strain};
  }

  void open_to_disk() {
    const std::size_t parts = patch_.inspection().topology.components;
    if (parts != 1) {
      throw Error(ErrorCode::several_components,
                  "the mesh has " + std::to_string(parts) + " separate parts");
    }
    paths_ = cut_graph(patch_, {.along_edges = true}, unfolding_).paths;
    for (const auto& path : paths_)
      found_.cuts.push_back({path, path_length(path, patch_.positions())});
    found_.first = with_paths();
    if (found_.first.pattern.positions.empty()) {
      // Nothing to begin with: the same words as without a search.
      unfold(Patch(found_.first.cut.mesh), {.least_stretch = true}, unfolding_);
    }
    if (!found_.cuts.empty()) found_.cuts.back().after = found_.first.strain;
    found_.last = found_.first;
  }

  /// The darts that gain or keep the limit, tried on the patch as it is cut so far; paths by its
  /// vertices.
  std::vector<Dart> find_darts() {
    const CutMesh& now = found_.last.cut;
    const Patch cut(now.mesh);
    const TrialPatch trial = trial_patch(cut, options_.trial_vertices);
    const auto on_old_border = [&](Index v) {
      return patch_.is_border(now.source[trial.source[v]]);
    };
    const bool is_same = trial.patch.vertex_count() == cut.vertex_count();
    const EdgeStrain without = is_same ? found_.last.strain : flatten(trial.patch).strain;
    std::vector<Dart> darts = darts_from(trial.patch, on_old_border);
    for (Dart& dart : darts) {
      const std::vector<CutPath> one = {{dart.path}};
      dart.flat = flatten(Patch(cut_open(trial.patch, one).mesh));
      share_ += 1.0 / options_.max_darts / static_cast<double>(darts.size() + 1);
      report_progress(context_, {"cutting", share_});
    }
    std::erase_if(darts, [&](const Dart& dart) {
      return !(gains(dart.flat.strain, without) || is_met(dart.flat.strain));
    });
    InsidePaths inside(cut);
    for (Dart& dart : darts) {
      const Index end = trial.source[dart.path.front()], tip = trial.source[dart.path.back()];
      dart.path = inside.from(std::span(&tip, 1), [end](Index v) { return v == end; })
                      .value_or(std::vector<Index>{});
      std::reverse(dart.path.begin(), dart.path.end());
    }
    std::erase_if(darts, [](const Dart& dart) { return dart.path.empty(); });
    return darts;
  }

  /// Adds the best dart with which the pattern does not overlap itself, or does as without it. Why
  /// there is none, if there is none.
  std::optional<SuggestStop> add_dart() {
    std::vector<Dart> darts = find_darts();
    const auto free_end = std::stable_partition(
        darts.begin(), darts.end(), [](const Dart& dart) { return !dart.flat.pattern.overlaps; });
    std::vector<Dart> overlapping(std::make_move_iterator(free_end),
                                  std::make_move_iterator(darts.end()));
    darts.erase(free_end, darts.end());
    const Dart* best = best_of(overlapping, options_);
    std::optional<Index> overlapping_tip;
    if (best != nullptr) overlapping_tip = tip_of(*best);
    const auto is_added = [&](const Dart& dart) {
      const std::optional<SuggestStop> why_not = try_dart(dart.path);
      if (why_not == SuggestStop::overlap && !overlapping_tip) overlapping_tip = tip_of(dart);
      return !why_not;
    };
    while (const Dart* next = best_of(darts, options_)) {
      if (is_added(*next)) return std::nullopt;
      darts.erase(darts.begin() + (next - darts.data()));
    }
    // Once it is shorter, a dart may be free of overlap.
    if (best != nullptr && is_added(*best)) return std::nullopt;
    found_.divide_at = overlapping_tip;
    return overlapping_tip ? SuggestStop::overlap : SuggestStop::no_gain;
  }

  /// By its number in the input mesh.
  Index tip_of(const Dart& dart) const { return found_.last.cut.source[dart.path.back()]; }

  /// Adds a dart, by vertices of the patch as it is cut so far, if it gains or keeps the limit and
  /// brings no overlap. Else says which of these it does not.
  std::optional<SuggestStop> try_dart(const std::vector<Index>& dart) {
    paths_.push_back(on_source(dart, found_.last.cut));
    CutPattern next = with_paths();
    if (is_met(next.strain)) next = with_shorter_dart(std::move(next));
    std::optional<SuggestStop> why_not;
    if (!gains(next.strain, found_.last.strain) && !is_met(next.strain)) {
      why_not = SuggestStop::no_gain;
    } else if (next.pattern.overlaps && !found_.last.pattern.overlaps) {
      why_not = SuggestStop::overlap;
    }
    if (why_not) {
      paths_.pop_back();
      return why_not;
    }
    const std::vector<Index>& path = paths_.back();
    found_.cuts.push_back(
        {path, path_length(path, patch_.positions()), true, found_.last.strain, next.strain});
    found_.last = std::move(next);
    return std::nullopt;
  }

  /// Draws the tip of the last path back as far as the limit stays met.
  CutPattern with_shorter_dart(CutPattern best) {
    const std::vector<Index> whole = paths_.back();
    std::size_t enough = whole.size(), too_few = 1;
    for (int k = 0; k < k_halvings && enough - too_few > 1; ++k) {
      const std::size_t middle = too_few + (enough - too_few) / 2;
      paths_.back().assign(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(middle));
      CutPattern some = with_paths();
      const bool is_fit = is_met(some.strain) && (best.pattern.overlaps || !some.pattern.overlaps);
      (is_fit ? enough : too_few) = middle;
      if (is_fit) best = std::move(some);
    }
    paths_.back().assign(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(enough));
    return best;
  }

  const Patch& patch_;
  const SuggestOptions& options_;
  const Context& context_;
  Context unfolding_;
  std::vector<std::vector<Index>> paths_;
  CutSuggestion found_;
  double share_ = 0.0;
};

}  // namespace

std::string_view to_string(SuggestStop stop) {
  switch (stop) {
    case SuggestStop::strain_met:
      return "strain_met";
    case SuggestStop::dart_limit:
      return "dart_limit";
    case SuggestStop::no_gain:
      return "no_gain";
    case SuggestStop::overlap:
      return "overlap";
  }
  return "unknown";
}

CutSuggestion suggest_cuts(const Patch& patch, const SuggestOptions& options,
                           const Context& context) {
  require(options.limits);
  if (!options.limits.bounds_edges()) {
    throw Error(ErrorCode::option_out_of_range,
                "cuts are looked for with a limit of strain of edges");
  }
  if (options.max_darts < 0) {
    throw Error(ErrorCode::option_out_of_range, "max_darts must be at least 0");
  }
  CutSuggestion found = CutSearch(patch, options, context).run();
  found.cautions = find_cautions(patch);
  return found;
}

}  // namespace planish
