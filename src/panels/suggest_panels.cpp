#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <planish/mesh/inspect.h>
#include <planish/mesh/symmetry.h>
#include <planish/panels/suggest_panels.h>

#include "core/job.h"
#include "measure/area.h"
#include "mesh/split.h"
#include "panels/cells/halved_product.h"
#include "panels/cells/thinned_product.h"
#include "panels/division.h"
#include "panels/finish.h"
#include "panels/piece/laid_flat.h"

namespace planish {

namespace {

constexpr std::size_t k_together = 2;  // moves, whatever the number of threads
constexpr double k_thin = 1.5;         // times the vertices of trials: up to there all are kept
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
  if (!(area_of(patch.mesh(), patch.unit_scale()) > 0.0))
    throw Error(ErrorCode::zero_area, "no triangle of the surface has an area");
  require(options.limits);
  if (!options.limits.any())
    throw Error(ErrorCode::option_out_of_range, "panels need a limit of strain");
  if (options.moves == 0) throw Error(ErrorCode::option_out_of_range, "moves must be 1 or more");
  if (options.trial_vertices < 100)
    throw Error(ErrorCode::option_out_of_range, "trial_vertices must be at least 100");
}

/// The rms strain that a pattern within the limits has at most, about. The potential tells no
/// other.
double rms_within(const StrainLimits& limits) {
  constexpr double k_of_area = 0.45, k_of_every_edge = 0.25;
  double rms = k_largest_strain_limit;
  const auto lower = [&](double limit, double share) {
    if (limit > 0.0) rms = std::min(rms, share * limit);
  };
  lower(limits.rms, 1.0);
  for (const double limit : {limits.p99, 0.5 * (limits.p99_stretch + limits.p99_compression)})
    lower(limit, k_of_area);
  for (const double limit : {limits.max, 0.5 * (limits.max_stretch + limits.max_compression)})
    lower(limit, k_of_every_edge);
  return rms;
}

PanelSuggestion suggestion_of(const FinishedDivision& division) {
  PanelSuggestion result;
  const PanelMesh& mesh = division.net->mesh;
  result.mesh = mesh.patch().mesh();
  for (SeamChain& chain : seam_chains(mesh, division.open))
    result.seams.push_back(std::move(chain.vertices));
  for (const FlatPiece& piece : division.pieces)
    result.panels.push_back({piece.triangles, piece.area, piece.has_pattern, piece.overlaps,
                             piece.changes, piece.strain});
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
      : product_(options.symmetric_in ? with_plane_as_edges(product, *options.symmetric_in)
                                      : product),
        options_(options),
        context_(context),
        pool_(context),
        prices_(prices_of(options.prefer)),
        rms_(rms_within(options.limits)),
        finish_{{options.limits, options.open_crossings}, options.match_seams, prices_, rms_},
        half_(options.symmetric_in ? halved_product(product_, *options.symmetric_in)
                                   : std::nullopt),
        thin_(thinned()) {}

  PanelSuggestion run() {
    try {
      search();
    } catch (const Cancelled&) {
      if (!best_) throw;
      PanelSuggestion best = suggestion_of(*best_);
      best.was_cancelled = true;
      return best;
    }
    return suggestion_of(*best_);
  }

 private:
  Patch thinned(const Patch& patch, std::size_t vertices) const {
    const auto most = static_cast<std::size_t>(k_thin * static_cast<double>(vertices));
    return patch.vertex_count() <= most ? patch : thinned_product(patch, vertices, pool_);
  }

  Patch thinned() const {
    if (!half_) return thinned(product_, options_.trial_vertices);
    const Patch half = thinned(*half_, options_.trial_vertices / 2);
    return Patch(without_chords(half.mesh(), *options_.symmetric_in));
  }

  void search() {
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
  }

  static bool is_better(const FinishedDivision& one, const FinishedDivision& other) {
    if (one.is_valid != other.is_valid) return one.is_valid;
    return one.cost < other.cost;
  }

  /// First with pieces that change, where they can. Nothing where the thinned product says that it
  /// is no better.
  std::optional<FinishedDivision> try_out(std::size_t move) const {
    const DivisionWay way = way_of_move(move);
    if (options_.can_change && way.beyond > 1.0) {
      if (auto found = try_out(way, way.beyond)) return found;
    }
    return try_out(way, 1.0);
  }

  /// @param beyond times the limits, which pieces miss that change
  std::optional<FinishedDivision> try_out(const DivisionWay& way, double beyond) const {
    ThreadPool alone(Context{.threads = 1, .is_cancelled = context_.is_cancelled});
    const std::optional<Plane> plane = half_ ? options_.symmetric_in : std::nullopt;
    const double limit = rms_ * beyond * (options_.match_seams ? way.aim : 1.0);
    const Division division = divided(thin_, plane, limit, prices_, way, alone);
    const double cost = division.cost + (division.lies_flat ? 0.0 : k_lap);
    if (best_ && best_->is_valid && cost >= best_->cost) return std::nullopt;
    if (beyond > 1.0 && !can_change(division)) return std::nullopt;
    FinishOptions finish = finish_;
    finish.beyond = beyond;
    FinishedDivision found = half_ ? finished_mirrored(product_, *half_, division, finish, alone)
                                   : finished(product_, division, finish, alone);
    if (beyond > 1.0 && !(found.is_valid && can_change(found))) return std::nullopt;
    return found;
  }

  /// Whether all pieces can be changed that are over the limit.
  bool can_change(const Division& division) const {
    const std::vector<PanelPiece>& pieces = division.state.pieces();
    return std::all_of(pieces.begin(), pieces.end(), [&](const PanelPiece& piece) {
      return piece.triangles.empty() || piece.strain() <= rms_ ||
             can_change(division.net->mesh, division.state.open(), piece.triangles);
    });
  }

  bool can_change(const FinishedDivision& division) const {
    return std::all_of(division.pieces.begin(), division.pieces.end(), [&](const FlatPiece& piece) {
      return !piece.changes || can_change(division.net->mesh, division.open, piece.triangles);
    });
  }

  /// Of a large piece asks the one with fewer vertices.
  bool can_change(const PanelMesh& mesh, const OpenEdges& open,
                  const std::vector<Index>& triangles) const {
    if (mesh.is_image(triangles.front())) return true;  // as what it is the image of
    const Patch piece(cut_out(mesh, PieceCorners(mesh, open, triangles)));
    return options_.can_change(thinned(piece, options_.trial_vertices),
                               {.threads = 1, .is_cancelled = context_.is_cancelled});
  }

  Patch product_;  // that which is divided
  const PanelOptions& options_;
  const Context& context_;
  ThreadPool pool_;
  SeamPrices prices_;
  double rms_;
  FinishOptions finish_;
  std::optional<Patch> half_;  // of a product that is to be divided symmetrically
  PanelMesh thin_;
  std::optional<FinishedDivision> best_;
};

bool is_symmetric_in(const Patch& part, const Plane& plane) {
  return symmetry_in(part, plane).largest <= symmetry_tolerance(part.mesh());
}

/// Divides what hangs together, at the scale at which squares of lengths neither overflow nor
/// vanish. That is a power of two, so no bit changes.
PanelSuggestion with_one_divided(const Patch& product, const PanelOptions& options,
                                 const Context& context) {
  const double scale = product.unit_scale();
  const auto at_own_scale = [&](PanelSuggestion found) {
    const std::vector<Vec3>& given = product.positions();
    std::vector<Vec3>& positions = found.mesh.positions;
    std::copy(given.begin(), given.end(), positions.begin());
    for (std::size_t v = given.size(); v < positions.size(); ++v)
      positions[v] = (1.0 / scale) * positions[v];
    found.length /= scale;
    return found;
  };
  PanelOptions of_search = options;
  if (of_search.symmetric_in) of_search.symmetric_in->offset *= scale;
  of_search.open_crossings *= scale;
  if (options.can_change) {
    of_search.can_change = [&](const Patch& piece, const Context& of_piece) {
      return options.can_change(Patch(scaled(piece.mesh(), 1.0 / scale)), of_piece);
    };
  }
  if (options.on_better) {
    of_search.on_better = [&](const PanelSuggestion& better) {
      options.on_better(at_own_scale(better));
    };
  }
  const Patch at_unit_scale(scaled(product.mesh(), scale));
  return at_own_scale(PanelSearch(at_unit_scale, of_search, context).run());
}

/// Puts a divided part of a product behind those that are there.
void add_part(const NamedPatch& part, const PanelSuggestion& divided, double share,
              PanelSuggestion& whole) {
  const auto first_new = static_cast<Index>(whole.mesh.positions.size());
  const auto first_triangle = static_cast<Index>(whole.mesh.triangles.size());
  const auto kept = static_cast<Index>(part.vertices.size());
  const auto number = [&](Index v) { return v < kept ? part.vertices[v] : first_new + v - kept; };
  whole.mesh.positions.insert(whole.mesh.positions.end(), divided.mesh.positions.begin() + kept,
                              divided.mesh.positions.end());
  for (const Triangle& t : divided.mesh.triangles)
    whole.mesh.triangles.push_back({number(t[0]), number(t[1]), number(t[2])});
  for (std::vector<Index> seam : divided.seams) {
    std::transform(seam.begin(), seam.end(), seam.begin(), number);
    whole.seams.push_back(std::move(seam));
  }
  for (SuggestedPanel panel : divided.panels) {
    for (Index& t : panel.triangles)
      t += first_triangle;
    panel.area *= share;
    whole.panels.push_back(std::move(panel));
  }
  whole.length += divided.length;
  whole.tips += divided.tips;
  whole.met = whole.met && divided.met;
  whole.was_cancelled = whole.was_cancelled || divided.was_cancelled;
}

/// One part after the other.
PanelSuggestion with_parts_divided(const Patch& product, const PanelOptions& options,
                                   const Context& context) {
  const std::vector<NamedPatch> parts = split(product.mesh(), "part");
  const SeamPrices prices = prices_of(options.prefer);
  const double scale = product.unit_scale();
  std::vector<double> areas;
  double area = 0.0;
  for (const NamedPatch& part : parts) {
    areas.push_back(area_of(part.mesh, scale));
    area += areas.back();
  }
  PanelSuggestion whole;
  whole.mesh.positions = product.mesh().positions;
  whole.met = true;
  const auto with_part = [&](PanelSuggestion so_far, std::size_t k,
                             const PanelSuggestion& divided) {
    add_part(parts[k], divided, areas[k] / area, so_far);
    so_far.cost = scale * so_far.length / std::sqrt(area) +
                  prices.piece * static_cast<double>(so_far.panels.size()) +
                  prices.tip * static_cast<double>(so_far.tips);
    return so_far;
  };
  for (std::size_t k = 0; k < parts.size(); ++k) {
    PanelOptions of_part = options;
    of_part.on_better = {};
    if (options.on_better && k + 1 == parts.size()) {
      of_part.on_better = [&](const PanelSuggestion& better) {
        options.on_better(with_part(whole, k, better));
      };
    }
    const auto share_at = [&](std::size_t i) {
      return static_cast<double>(i) / static_cast<double>(parts.size());
    };
    const Context of_job = part_of(context, share_at(k), share_at(k + 1));
    const Patch part(parts[k].mesh);
    if (options.symmetric_in && !is_symmetric_in(part, *options.symmetric_in))
      of_part.symmetric_in.reset();
    const PanelSuggestion divided = with_one_divided(part, of_part, of_job);
    whole = with_part(std::move(whole), k, divided);
  }
  return whole;
}

}  // namespace

std::string_view to_string(PanelPreference preference) {
  switch (preference) {
    case PanelPreference::few:
      return "few";
    case PanelPreference::shortest:
      return "short";
    case PanelPreference::simple:
      return "simple";
  }
  return "";
}

PanelSuggestion suggest_panels(const Patch& patch, const PanelOptions& options,
                               const Context& context) {
  require(patch, options);
  if (patch.inspection().topology.components == 1) return with_one_divided(patch, options, context);
  return with_parts_divided(patch, options, context);
}

}  // namespace planish
