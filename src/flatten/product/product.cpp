#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>
#include <utility>

#include <planish/core/range.h>
#include <planish/flatten/product.h>

#include "core/job.h"
#include "core/thread_pool.h"
#include "flatten/check_request.h"
#include "flatten/limit_checks.h"
#include "flatten/outcome.h"
#include "flatten/product/common_lengths.h"
#include "flatten/product/product_seams.h"
#include "flatten/product/workers.h"
#include "flatten/twin_report.h"
#include "flatten/verdict.h"

namespace planish {

namespace {

using MeshTwins = std::vector<std::optional<MeshTwin>>;

void check(const ProductOptions& options) {
  const Constraints& constraints = options.flatten.constraints;
  const bool names_vertices = options.flatten.fold || !constraints.fixed.empty() ||
                              !constraints.weights.empty() ||
                              !constraints.obstacle.triangles.empty() ||
                              !options.flatten.keep.empty() || !options.flatten.free_edges.empty();
  if (names_vertices) {
    throw Error(ErrorCode::unsupported_constraint,
                "constraints, vertices to keep and free edges are of one patch; a product has "
                "several");
  }
  check_request(options.flatten);
  check_range("seam_tolerance", options.seam_tolerance, Range{0.0});
  if (std::isinf(options.seam_tolerance))
    throw Error(ErrorCode::option_out_of_range, "seam_tolerance is inf but must be a length");
}

void check(std::span<const ProductPatch> patches) {
  for (const ProductPatch& patch : patches) {
    if (patch.limits) require(*patch.limits);
  }
}

/// @param vertex of the other one -> of this one
bool have_same_fold(const ProductPatch& own, const ProductPatch& other,
                    std::span<const Index> vertex) {
  if (!own.fold || !other.fold) return own.fold.has_value() == other.fold.has_value();
  const auto is_there = [&](Index v) { return v < vertex.size(); };
  if (!is_there((*other.fold)[0]) || !is_there((*other.fold)[1])) return false;
  const auto ends = std::minmax(vertex[(*other.fold)[0]], vertex[(*other.fold)[1]]);
  return ends == std::minmax((*own.fold)[0], (*own.fold)[1]);
}

/// What a thread makes of a patch. Without either it was cancelled. Of a failure nothing else is
/// known: there may be no memory for more.
struct PatchOutcome {
  std::optional<FinishedPatch> finished = {};
  std::optional<Failure> failure = {};
};

/// Flattens patches, from any thread.
class PatchWork {
 public:
  PatchWork(std::span<const ProductPatch> patches, const ProductOptions& options,
            const ProductCallbacks& callbacks, const MeshTwins& meshes_alike,
            const ProductReport& report, std::span<const SewnBorder> borders,
            std::function<bool()> stopped)
      : patches_(patches),
        options_(options),
        callbacks_(callbacks),
        meshes_alike_(meshes_alike),
        report_(report),
        borders_(borders),
        stopped_(std::move(stopped)) {}

  /// Flattens the first patch of a group and makes the others from it.
  /// @param put is handed each result with its number
  template <class Put>
  void do_group(const std::vector<std::size_t>& group, const Put& put) const {
    std::optional<FlattenReport> first;
    put(group.front(), guarded(group.front(), [&] {
          first = flattened(group.front());
          return finished(group.front(), *first, nullptr);
        }));
    for (std::size_t k = 1; k < group.size(); ++k) {
      const std::size_t p = group[k];
      put(p, guarded(p, [&] { return stopped_() ? PatchOutcome{} : as_twin(p, first); }));
    }
  }

 private:
  template <class Work>
  PatchOutcome guarded(std::size_t p, const Work& work) const try {
    if (patches_[p].failure) return {{}, patches_[p].failure};
    return work();
  } catch (const Cancelled&) {
    return {};
  } catch (...) {
    return {{}, current_failure()};
  }

  FlattenOptions options_of(std::size_t p) const {
    FlattenOptions options = options_.flatten;
    options.keep = patches_[p].keep;
    options.free_edges = borders_[p].free_edges;
    options.seam_lengths = borders_[p].lengths;
    if (!options.match_seams)
      options.match_seams = options.match_if_possible =
          options_.match_seams && borders_[p].has_seams;
    if (patches_[p].fold) options.fold = patches_[p].fold;
    if (patches_[p].limits) {
      options.limits = *patches_[p].limits;
      options.material = patches_[p].words.material;
    }
    return options;
  }

  FlattenReport flattened(std::size_t p) const {
    return with_turned(
        flatten(Patch(patches_[p].mesh), patches_[p].name, options_of(p), {1, {}, stopped_}),
        patches_[p].turned);
  }

  /// What was made of the other one, or else what flattening makes of it.
  PatchOutcome as_twin(std::size_t p, const std::optional<FlattenReport>& other) const {
    if (other) {
      auto report = twin_report(*other, Patch(patches_[p].mesh), meshes_alike_[p]->match,
                                patches_[p].name, options_of(p));
      if (report) {
        return finished(p, with_turned(*std::move(report), patches_[p].turned), &*report_.twins[p]);
      }
    }
    return finished(p, flattened(p), nullptr);
  }

  PatchOutcome finished(std::size_t p, const FlattenReport& report, const PatchTwin* twin) const {
    if (callbacks_.on_report) callbacks_.on_report(p, report, twin);
    return {finished_patch(report)};
  }

  std::span<const ProductPatch> patches_;
  const ProductOptions& options_;
  const ProductCallbacks& callbacks_;
  const MeshTwins& meshes_alike_;
  const ProductReport& report_;
  std::span<const SewnBorder> borders_;
  std::function<bool()> stopped_;
};

/// As PatchResult has it. What an earlier run kept may be of another mesh: none then.
std::vector<Vec3> design_of(const FinishedPatch& piece, const TriMesh& input) {
  const std::size_t count = piece.processed.positions.size(), all = input.positions.size();
  if (piece.deviation.max == 0.0) return {};
  if (piece.source.empty()) return count == all ? input.positions : std::vector<Vec3>();
  const bool are_there =
      std::all_of(piece.source.begin(), piece.source.end(), [all](Index v) { return v < all; });
  if (piece.source.size() != count || !are_there) return {};
  std::vector<Vec3> design;
  design.reserve(piece.source.size());
  for (const Index v : piece.source)
    design.push_back(input.positions[v]);
  return design;
}

/// One run over a product.
class ProductWork {
 public:
  ProductWork(std::span<const ProductPatch> patches, const ProductOptions& options,
              const ProductCallbacks& callbacks, const Context& context)
      : patches_(patches), options_(options), callbacks_(callbacks), context_(context) {
    report_.unit = options.flatten.unit;
    for (const ProductPatch& patch : patches) {
      const TriMesh& mesh = patch.mesh;
      report_.patches.push_back({patch.name, mesh.positions.size(), mesh.triangles.size()});
      report_.patches.back().words = patch.words;
      report_.patches.back().group = patch.group;
    }
    find_alike();
    borders_ = borders_of_patches();
  }

  ProductReport run() {
    flatten_all(to_be_flattened());
    stop_if_cancelled(context_);
    if (report_.finished() > 0) {
      const std::vector<TriMesh> meshes = meshes_now(patches_, report_);
      const std::vector<std::size_t> groups = groups_of_patches();
      report_.seams = measure_seams(find_seams_in_groups(meshes, groups, options_.seam_tolerance),
                                    meshes, report_.patches, report_.unit);
      // Borders that moved may no longer lie beside each other.
      report_.near_borders =
          find_near_borders_in_groups(input_meshes(), groups, options_.seam_tolerance);
      for (NearBorders& near : report_.near_borders)
        near.length *= millimetres_per(report_.unit);
    }
    return std::move(report_);
  }

 private:
  bool is_cancelled() const { return context_.is_cancelled && context_.is_cancelled(); }

  std::vector<TriMesh> input_meshes() const {
    std::vector<TriMesh> meshes;
    meshes.reserve(patches_.size());
    for (const ProductPatch& patch : patches_)
      meshes.push_back(patch.mesh);
    return meshes;
  }

  std::vector<std::size_t> groups_of_patches() const {
    std::vector<std::size_t> groups;
    groups.reserve(patches_.size());
    for (const ProductPatch& patch : patches_)
      groups.push_back(patch.group);
    return groups;
  }

  /// With matched seams, what is sewn to nothing need not keep its length.
  std::vector<SewnBorder> borders_of_patches() const {
    if (!options_.match_seams && !options_.flatten.match_seams)
      return std::vector<SewnBorder>(patches_.size());
    const std::vector<TriMesh> meshes = input_meshes();
    const std::vector<Seam> seams =
        find_seams_in_groups(meshes, groups_of_patches(), options_.seam_tolerance);
    std::vector<SewnBorder> borders = find_sewn_borders(seams, meshes, alike_);
    const FlattenOptions& flatten = options_.flatten;
    if (options_.common_lengths && !flatten.match_seams && keeps_lengths(flatten)) {
      std::vector<SewnPatch> sewn;
      for (const ProductPatch& patch : patches_)
        sewn.push_back({&patch.mesh, patch.limits.value_or(flatten.limits)});
      give_common_lengths(seams, sewn, alike_,
                          {.least_stretch = true, .symmetric_in = flatten.constraints.symmetric_in},
                          borders, context_);
    }
    return borders;
  }

  void find_alike() {
    std::vector<const TriMesh*> meshes;
    meshes.reserve(patches_.size());
    for (const ProductPatch& patch : patches_)
      meshes.push_back(&patch.mesh);
    alike_ = find_twins(meshes, k_twin_tolerance, context_);
    for (std::size_t p = 0; p < patches_.size(); ++p) {
      if (!alike_[p]) continue;
      const ProductPatch &own = patches_[p], &other = patches_[alike_[p]->of];
      if (own.limits != other.limits || !have_same_fold(own, other, alike_[p]->match.vertex))
        alike_[p].reset();
    }
    report_.twins.reserve(alike_.size());
    for (const auto& twin : alike_) {
      auto& known = report_.twins.emplace_back();
      if (twin) known = PatchTwin{twin->of, twin->match.mirrored, twin->match.vertex};
    }
  }

  std::vector<std::optional<FinishedPatch>> from_earlier_runs() const {
    std::vector<std::optional<FinishedPatch>> earlier(patches_.size());
    if (!callbacks_.earlier) return earlier;
    for (std::size_t p = 0; p < patches_.size(); ++p) {
      const auto& twin = report_.twins[p];
      if (!patches_[p].failure)
        earlier[p] = callbacks_.earlier(p, twin ? &*twin : nullptr, borders_[p]);
      if (earlier[p]) earlier[p]->unfold.turned = patches_[p].turned;
    }
    return earlier;
  }

  /// Keeps what is there already; the numbers of the other patches.
  std::vector<std::size_t> to_be_flattened() {
    std::vector<std::optional<FinishedPatch>> earlier = from_earlier_runs();
    for (std::size_t p = 0; p < patches_.size(); ++p) {
      // Its full report is needed once more.
      if (!earlier[p] && alike_[p]) earlier[alike_[p]->of].reset();
    }
    std::vector<std::size_t> numbers;
    numbers.reserve(patches_.size());
    for (std::size_t p = 0; p < patches_.size(); ++p) {
      if (!earlier[p]) {
        numbers.push_back(p);
        continue;
      }
      report_.patches[p].resumed = true;
      take(p, {std::move(earlier[p])});
    }
    return numbers;
  }

  void take(std::size_t p, PatchOutcome made) {
    PatchResult& result = report_.patches[p];
    result.finished = std::move(made.finished);
    result.failure = std::move(made.failure);
    if (!result.finished && !result.failure) throw Cancelled();
    if (callbacks_.on_done) callbacks_.on_done(p, result);
    if (result.finished) result.design = design_of(*result.finished, patches_[p].mesh);
    const auto all = static_cast<double>(patches_.size());
    report_progress(context_, {"flattening", static_cast<double>(++done_) / all, result.name});
  }

  /// Each patch with its twins, which come later in the row.
  std::vector<std::vector<std::size_t>> groups_of(const std::vector<std::size_t>& numbers) const {
    std::vector<std::vector<std::size_t>> groups;
    std::vector<std::size_t> place(patches_.size());  // of the group that a patch is the first of
    for (const std::size_t p : numbers) {
      if (alike_[p]) {
        groups[place[alike_[p]->of]].push_back(p);
      } else {
        place[p] = groups.size();
        groups.push_back({p});
      }
    }
    return groups;
  }

  void flatten_all(std::vector<std::size_t> numbers) {
    std::stable_sort(numbers.begin(), numbers.end(), [&](std::size_t a, std::size_t b) {
      return patches_[a].mesh.triangles.size() > patches_[b].mesh.triangles.size();
    });
    const std::vector<std::vector<std::size_t>> groups = groups_of(numbers);
    std::atomic<std::size_t> next = 0;
    Handover<std::pair<std::size_t, PatchOutcome>> results(numbers.size());
    const PatchWork work(patches_, options_, callbacks_, alike_, report_, borders_,
                         [this] { return abandoned_ || is_cancelled(); });
    const auto work_on_next = [&] {
      const std::size_t k = next++;
      if (k >= groups.size()) return false;
      work.do_group(groups[k], [&](std::size_t p, PatchOutcome done) {
        results.put({p, std::move(done)});
      });
      return true;
    };
    Workers workers(abandoned_);
    const std::size_t threads = std::min<std::size_t>(thread_count(context_), groups.size());
    if (threads > 1) {
      workers.start(threads, [&] {
        while (work_on_next()) {
        }
      });
    }
    for (std::size_t taken = 0; taken < numbers.size(); ++taken) {
      if (workers.empty()) work_on_next();
      auto [p, made] = results.take();
      take(p, std::move(made));
    }
  }

  std::span<const ProductPatch> patches_;
  const ProductOptions& options_;
  const ProductCallbacks& callbacks_;
  MeshTwins alike_;
  std::vector<SewnBorder> borders_;
  ProductReport report_;
  const Context& context_;
  std::size_t done_ = 0;
  std::atomic<bool> abandoned_ = false;  // no result is taken any more
};

}  // namespace

FinishedPatch finished_patch(const FlattenReport& report) {
  FinishedPatch patch{report.processed.mesh(),
                      report.unfold,
                      report.evolve.deviation,
                      report.evolve.result.stop,
                      report.twin_of,
                      report.rejected,
                      limit_checks(report),
                      find_form_faults(report.evolve),
                      cautions_text(report.cautions, report.unfold.unit),
                      not_judged_text(report),
                      report.source};
  patch.unfold.pattern.unmatched_least_stretch.clear();
  patch.unfold.pattern.least_stretch.clear();
  return patch;
}

std::size_t ProductReport::finished() const {
  return static_cast<std::size_t>(
      std::count_if(patches.begin(), patches.end(),
                    [](const PatchResult& patch) { return patch.finished.has_value(); }));
}

std::vector<TriMesh> meshes_now(std::span<const ProductPatch> patches,
                                const ProductReport& report) {
  std::vector<TriMesh> meshes;
  meshes.reserve(patches.size());
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const auto& finished = report.patches[p].finished;
    meshes.push_back(finished ? finished->processed : patches[p].mesh);
  }
  return meshes;
}

ProductReport flatten_product(std::span<const ProductPatch> patches, const ProductOptions& options,
                              const ProductCallbacks& callbacks, const Context& context) {
  check(options);
  check(patches);
  return ProductWork(patches, options, callbacks, context).run();
}

}  // namespace planish
