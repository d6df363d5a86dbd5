#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

#include <planish/mesh/inspect.h>
#include <planish/panels/suggest_panels.h>

#include "core/job.h"
#include "panels/cells/thinned_product.h"
#include "panels/division.h"
#include "panels/finish.h"

namespace planish {

namespace {

constexpr std::size_t k_together = 2;  // moves, whatever the number of threads
constexpr double k_lap = 0.25;         // what a division that laps has to be better by

SeamPrices prices_of(PanelPreference preference) {
  switch (preference) {
    case PanelPreference::few:
      return {.piece = 0.25, .tip = 0.0};
    case PanelPreference::shortest:
      return {.piece = 0.05, .tip = 0.0};
    case PanelPreference::simple:
      return {.piece = 0.25, .tip = 100.0};
  }
  return {};
}

void require(const Patch& patch, const PanelOptions& options) {
  require(patch.inspection(), Purpose::measure);
  const Topology& topology = patch.inspection().topology;
  if (topology.components > 1)
    throw Error(ErrorCode::several_components,
                "the product has several parts; divide them one by one");
  if (topology.genus > 0)
    throw Error(ErrorCode::handles, "a product with handles cannot be divided into panels yet");
  if (!(options.max_rms > 0.0 && options.max_rms <= k_largest_strain_limit))
    throw Error(ErrorCode::option_out_of_range, "max_rms must be above 0 and at most 1");
  if (options.moves == 0) throw Error(ErrorCode::option_out_of_range, "moves must be 1 or more");
  if (options.trial_vertices < 100)
    throw Error(ErrorCode::option_out_of_range, "trial_vertices must be at least 100");
}

PanelSuggestion suggestion_of(const FinishedDivision& division) {
  PanelSuggestion result;
  const PanelMesh& mesh = division.net->mesh;
  result.mesh = mesh.patch().mesh();
  for (SeamChain& chain : seam_chains(mesh, division.open))
    result.seams.push_back(std::move(chain.vertices));
  for (const FlatPiece& piece : division.pieces)
    result.panels.push_back(
        {piece.triangles, piece.area, piece.has_pattern, piece.overlaps, piece.strain});
  std::sort(result.panels.begin(), result.panels.end(),
            [](const auto& a, const auto& b) { return a.triangles.front() < b.triangles.front(); });
  result.length = open_length(mesh, division.open) / mesh.scale();
  result.tips = division.tips;
  result.cost = division.cost;
  result.met = division.is_valid;
  return result;
}

/// Divisions one after the other, and the best of those that were finished.
class PanelSearch {
 public:
  PanelSearch(const Patch& product, const PanelOptions& options, const Context& context)
      : product_(product),
        options_(options),
        context_(context),
        pool_(context),
        prices_(prices_of(options.prefer)),
        thin_(thinned_product(product, options.trial_vertices, pool_)) {}

  PanelSuggestion run() {
    for (std::size_t move = 0; move < options_.moves; move += k_together) {
      report_progress(
          context_, {"dividing", static_cast<double>(move) / static_cast<double>(options_.moves)});
      std::array<std::optional<FinishedDivision>, k_together> found;
      pool_.for_ranges(std::min(k_together, options_.moves - move), 1,
                       [&](std::size_t begin, std::size_t end) {
                         for (std::size_t i = begin; i < end; ++i)
                           found[i] = try_out(move + i);
                       });
      for (std::optional<FinishedDivision>& division : found) {
        if (!division || (best_ && !is_better(*division, *best_))) continue;
        best_ = std::move(division);
        if (options_.on_better) options_.on_better(suggestion_of(*best_));
      }
    }
    return suggestion_of(*best_);
  }

 private:
  static bool is_better(const FinishedDivision& one, const FinishedDivision& other) {
    if (one.is_valid != other.is_valid) return one.is_valid;
    return one.cost < other.cost;
  }

  /// Nothing where the thinned product says that it is no better.
  std::optional<FinishedDivision> try_out(std::size_t move) const {
    ThreadPool alone(Context{.threads = 1, .is_cancelled = context_.is_cancelled});
    const Division division = divided(thin_, options_.max_rms, prices_, way_of_move(move), alone);
    const double cost = division.cost + (division.lies_flat ? 0.0 : k_lap);
    if (best_ && best_->is_valid && cost >= best_->cost) return std::nullopt;
    return finished(product_, division, options_.max_rms, prices_, alone);
  }

  const Patch& product_;
  const PanelOptions& options_;
  const Context& context_;
  ThreadPool pool_;
  SeamPrices prices_;
  PanelMesh thin_;
  std::optional<FinishedDivision> best_;
};

}  // namespace

std::string_view to_string(PanelPreference preference) {
  switch (preference) {
    case PanelPreference::few:
      return "few";
    case PanelPreference::shortest:
      return "shortest";
    case PanelPreference::simple:
      return "simple";
  }
  return "";
}

PanelSuggestion suggest_panels(const Patch& patch, const PanelOptions& options,
                               const Context& context) {
  require(patch, options);
  return PanelSearch(patch, options, context).run();
}

}  // namespace planish
