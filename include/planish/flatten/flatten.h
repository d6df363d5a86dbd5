#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <planish/core/unit.h>
#include <planish/evolve/evolve.h>
#include <planish/evolve/remesh.h>
#include <planish/flatten/ways.h>
#include <planish/measure/cautions.h>
#include <planish/measure/deviation.h>
#include <planish/measure/fairness.h>
#include <planish/measure/flattenability.h>
#include <planish/measure/limit_check.h>
#include <planish/measure/obstruction.h>
#include <planish/mesh/inspect.h>
#include <planish/unfold/strain.h>
#include <planish/unfold/unfold.h>

namespace planish {

/// Why one of several jobs has no result, where the others go on.
struct Failure {
  std::string code;     ///< as of Error, or out_of_memory or internal_error
  std::string message;  ///< one line that names the cause
};

/// The failure of the exception that is being handled, its message with the place and the way on
/// that an Error has.
/// @pre called in a handler
Failure current_failure();

/// A patch and all that measuring says of it.
struct MeasuredPatch {
  Inspection inspection;                        ///< topology and problems
  PatchSize size = {};                          ///< as measure_size()
  Flattenability figures;                       ///< angle defects
  bool flattenable = false;                     ///< as is_flattenable() of the two above
  std::optional<Obstruction> obstruction = {};  ///< of a disk only
  Bending bending = {};                         ///< as measure_bending()
  double ruling_defect = 0.0;                   ///< as docs/fairness.md defines it
  SelfIntersections self_intersections = {};    ///< as find_self_intersections()
};

/// Measures a patch, with all figures.
/// @throws Error what stands in the way of Purpose::measure
MeasuredPatch measure_patch(const Patch& patch, const Context& context = {});

/// The size of a patch that was worked on with fewer vertices.
struct OriginalSize {
  std::size_t vertices = 0, triangles = 0;  ///< how many the patch had
};

/// What was done to a design before all else.
struct SmoothingSummary {
  double length = 0.0;  ///< of the waves that were taken out, model units
  Deviation moved;      ///< of the smoothed design from the raw one
};

/// A design without its short waves.
struct SmoothedDesign {
  Patch patch;            ///< with the triangles of the raw design
  SmoothingSummary done;  ///< how much smoothing changed
};

/// What is wrong with a form.
struct FormFault {
  Criterion what = Criterion::form;  ///< from `crumpled` to `self_intersections`
  std::string text;                  ///< after "the form": "is lost"
};

/// Whether a result is what was asked for, and can be used. It says more than the reason to stop: a
/// run may end for good reasons and miss its target, or keep every limit at the end of its sweeps.
struct Outcome {
  /// All that is missed or wrong, in the order of Criterion.
  std::vector<Criterion> missed = {};
  /// Why evolving ended; where something is missed, why no more was done about it.
  StopReason reason = StopReason::sweep_limit;
  /// What is missed by the largest share, or where all is met, what is nearest to its limit.
  /// Nothing where nothing was asked for.
  std::optional<LimitCheck> worst = {};

  /// Whether nothing that was asked for is missed: up to Criterion::rejected.
  bool limits_met() const;
  /// Whether that is among what is missed.
  bool misses(Criterion what) const;
  /// Whether the pattern can be cut as it is: nothing is missed.
  bool usable() const { return missed.empty(); }
  /// Whether e_max is at the target; without one, whether it is 0 but for rounding.
  bool target_met() const { return reason == StopReason::reached_target; }
};

/// An evolution with the figures around it.
struct EvolveReport {
  std::optional<Method> method = {};  ///< with its options; none: nothing was to be evolved
  Stopping stopping;                  ///< what was asked for
  EvolveResult result;                ///< positions and history
  MeasuredPatch before, after;  ///< figures of the patch before the first sweep and after the last
  Deviation deviation;          ///< of the result from the input patch
  std::optional<BoundaryChange> border = {};  ///< where the border moved
  /// Of the input patch, if remeshing removed vertices: then `before` is measured after remeshing,
  /// and the deviation is that between the surfaces.
  std::optional<OriginalSize> remeshed_from = {};
  Fairness fairness = {};  ///< compared with the input patch
  /// Where the design was smoothed first: then `before` and `fairness` are of the smoothed one, the
  /// deviation is that from the raw one.
  std::optional<SmoothingSummary> smoothed_first = {};

  /// By the target of e_max, the limits of deviation and angles, and the form. Limits of strain
  /// count as met where the method's own estimate of the strain keeps them: there is no pattern to
  /// measure.
  Outcome outcome() const;
  /// The method's name, or "none".
  std::string_view method_name() const;
  /// The options where the method is Auto; else null.
  const Auto* auto_options() const;
};

/// An unfolding with the figures of its pattern.
struct UnfoldReport {
  Pattern pattern;             ///< model units
  EdgeStrain strain;           ///< of the pattern beside the patch
  Unit unit = Unit::mm;        ///< one unit of the model
  double border_strain = 0.0;  ///< largest |strain| of the border's edges
  /// Where border edges keep their lengths: the strain of least stretch without that.
  std::optional<EdgeStrain> unmatched_strain = {};
  /// One for each limit of strain that was asked for.
  std::vector<LimitCheck> limits = {};
  /// Where a limit changed the pattern, or spreading: the strain of the one of least stretch.
  std::optional<EdgeStrain> unlimited_strain = {};
  std::optional<Overlap> overlap = {};  ///< where pattern.overlaps
  /// The patch was turned over when it was read: it was inside out against a neighbour.
  bool turned = false;

  /// By the limits of strain and the pattern: the surface is the design.
  Outcome outcome() const;
};

/// What the main job is asked for.
struct FlattenOptions {
  /// How to evolve, with its options. None: only limits that the pattern of the design misses
  /// change its form, by `as_needed`. Without limits the surface then stays as it is, to the bit,
  /// and the pattern spreads its stretch.
  std::optional<Method> method = {};
  /// How limits change the form where no method is given. With max_deviation, a tolerance, the
  /// result has the least strain within it that stays smooth, or with limits as little change as
  /// they need; 0: nothing moves (docs/methods/least_change.md).
  Auto as_needed = {};
  std::optional<Stopping> stopping = {};  ///< usual_stopping() of the method where none is given
  Unit unit = Unit::mm;                   ///< one unit of the model
  Constraints constraints = {};           ///< of evolving
  /// Above 0: waves of the design that are shorter, in model units, are taken out first
  /// (smooth_design()); with remesh or fixed vertices an Error unsupported_constraint.
  double smooth_first = 0.0;
  bool remesh = false;             ///< work on fewer vertices: see remesh()
  std::vector<Index> keep = {};    ///< vertices that remeshing leaves, besides fixed ones
  bool match_seams = false;        ///< of the result's pattern, as UnfoldOptions has it
  bool match_if_possible = false;  ///< likewise
  /// As UnfoldOptions has them, by the vertices of the patch before it is remeshed.
  std::vector<std::array<Index, 2>> free_edges = {};
  /// As UnfoldOptions has them; not together with remesh.
  std::vector<EdgeLength> seam_lengths = {};
  /// As UnfoldOptions has it, by the vertices of the patch before it is remeshed: the whole is
  /// evolved too, and the result is its half.
  std::optional<std::array<Index, 2>> fold = {};
  bool keep_design = false;  ///< lay the design flat and change nothing
  /// Of a design that is kept without limits: as UnfoldOptions has it.
  bool least_stretch = false;
  /// What the pattern is to keep. Auto leaves a patch as it is where its pattern keeps them and
  /// does not overlap itself, and else changes it as far as that needs, if it can.
  StrainLimits limits = {};
  std::string material = {};  ///< name of that whose limits these are, used in texts; may be empty
  /// Where no method is given: also find FlattenReport::ways, in some 0.2 s.
  bool ways = false;

  /// Whether anything asks for another form: a method, or limits that the design may miss.
  bool may_change() const;
};

/// A patch whose results are those of another one (find_twins()).
struct TwinOf {
  std::string name;       ///< of the other one
  bool mirrored = false;  ///< mirrored, else taken as they are
};

/// The strain of patterns of the unchanged patch: what its material has to take if the surface is
/// not evolved. Shares of length.
struct StrainAsDesigned {
  EdgeStrain least_stretch;  ///< of the pattern of least stretch
  /// Of all edges, smallest_limit(); nothing above k_most_searched vertices.
  std::optional<double> smallest_limit = {};
  /// One for each limit that was asked for: of the pattern that keeps them best.
  std::vector<LimitCheck> limits = {};
  Pattern pattern = {};  ///< of least stretch

  /// Patches with more vertices have no search for the smallest limit, which takes some 15 times as
  /// long as laying flat.
  static constexpr std::size_t k_most_searched = 100'000;
};

/// A surface to choose from, and what it costs.
struct Candidate {
  Method method;  ///< of the run, with its limits among the options; of the design it is idle
  /// The place in the fixed order of candidates, from 1, as preset_options() takes it; none where
  /// other limits were asked for.
  std::optional<int> preset = {};
  StopReason stop = StopReason::sweep_limit;  ///< why the run ended; of the design design_kept
  std::size_t sweeps = 0;                     ///< that the run made
  double seconds = 0.0;                       ///< of evolving
  EdgeStrain strain = {};                     ///< of the pattern
  bool limits_kept = true;                    ///< by the pattern, of those that were asked for
  Deviation deviation = {};                   ///< from the design
  bool flattenable = false;                   ///< as is_flattenable()
  Fairness fairness = {};                     ///< beside the design
  /// Another candidate has less of one of rms strain, rms deviation and bending_ratio, and no more
  /// of the others: mark_dominated().
  bool dominated = false;

  /// The design itself.
  bool is_design() const { return stop == StopReason::design_kept; }
};

/// The limits of rms strain of the candidates between the design and a flattenable surface, shares
/// of length. The last is the default end of Auto.
inline constexpr std::array k_candidate_strains = {0.02, 0.01, 0.005, k_unmeasurable_strain};
/// How many candidates the fixed order has: the design, those of k_candidate_strains, flat.
inline constexpr int k_candidates = static_cast<int>(k_candidate_strains.size()) + 2;

/// What makes flatten() give a candidate of the fixed order.
/// @param number from 1 to k_candidates
/// @param options all that has nothing to do with the choice, and limits that the design's pattern
///   is to keep; the other candidates have none but their own
/// @throws Error option_out_of_range
FlattenOptions preset_options(int number, FlattenOptions options = {});

/// The number of what a run with this method was asked for, as of preset_options(); none where it
/// is not of the fixed order. The design, for which no method runs, has 1.
std::optional<int> preset_of(const Method& method);

/// What the candidate of that number is called where its run keeps what it was asked for, as
/// candidate_name(): "as designed", "0.5 % rms", "flat".
/// @throws Error option_out_of_range
std::string preset_name(int number);

/// What a candidate is called: "as designed", "0.5 % rms", "limit 1 %" by the largest strain,
/// "flat", of another method its name; with ", missed" where the limit is not kept.
std::string candidate_name(const Candidate& candidate);

/// The main job's result: everything that the files of a `flatten` folder are made from.
struct FlattenReport {
  std::string name;      ///< of the patch, for titles
  std::string material;  ///< of FlattenOptions
  Patch input;           ///< remeshed or smoothed, if that was asked for
  /// Vertex of `input` -> vertex of the original patch, increasing; empty: they are the same.
  std::vector<Index> source;
  Patch processed;                    ///< the input with the evolved positions
  EvolveReport evolve;                ///< from `input` to `processed`
  UnfoldReport unfold;                ///< of `processed`
  UnfoldReport design_least_stretch;  ///< of `input`: the difference is what evolving gained
  /// Of `input`: the pattern that keeps the limits asked for where the result is the design, and
  /// where there is such a one; else that of least stretch, `design_least_stretch`.
  UnfoldReport design_pattern;
  /// What keeping limits that the design misses does to the form: those of up to three materials,
  /// and 2, 1 and 0.5 % rms. Estimates of a coarser mesh, but for what this run did. Empty where
  /// constraints name vertices, and for designs of more than 500,000.
  std::vector<Way> ways = {};
  /// What the mesh of the original patch cannot show; where it was smoothed first, noise that is
  /// left.
  std::vector<Caution> cautions = {};
  std::optional<TwinOf> twin_of = {};  ///< where it is made from the report of another patch
  /// Where evolving made the pattern worse, and the design is the result: the strain it came to.
  std::optional<EdgeStrain> rejected = {};

  /// By all that was asked for (the target of e_max, limits of deviation and angles, and limits of
  /// strain, by the pattern), the form and the pattern.
  Outcome outcome() const;
  /// The surfaces to choose from that this run computed: the design first, the result last. Only
  /// one where they are the same.
  std::vector<Candidate> candidates() const;
};

/// The report of a patch of which is known whether it was turned over when it was read.
FlattenReport with_turned(FlattenReport report, bool turned);

/// Evolves with all figures around it.
/// @throws as evolve()
EvolveReport evolve_patch(const Patch& patch, const Method& method, const Stopping& stopping,
                          const Constraints& constraints = {}, const Context& context = {});

/// The same on a patch that was remeshed.
/// @param original what `remeshed` was made from
EvolveReport evolve_remeshed(const Patch& original, const RemeshedPatch& remeshed,
                             const Method& method, const Stopping& stopping,
                             const Context& context = {});

/// Takes waves shorter than a length out of a design: the noise of a scan. The border stays.
/// @param length in model units
/// @throws Error option_out_of_range, as smoothed_positions()
SmoothedDesign smooth_design(const Patch& raw, double length);

/// The report of an evolution of a smoothed design, with what smoothing did.
EvolveReport with_smoothing(EvolveReport report, const Patch& raw, const SmoothingSummary& done);

/// Unfolds with all figures around it. Crossings of the border are opened by 0.1 mm at most.
/// @throws as unfold()
UnfoldReport unfold_patch(const Patch& patch, Unit unit, const UnfoldOptions& options = {},
                          const Context& context = {});

/// Lays a patch flat, with and without limits, and keeps the figures.
/// @throws as unfold()
StrainAsDesigned strain_as_designed(const Patch& patch, const StrainLimits& limits,
                                    const Context& context = {});

/// The main job: measure, evolve, measure, unfold.
/// @throws as evolve() and unfold(), limits also as require(); what is not a disk, and options out
///   of their range, are refused before any work
FlattenReport flatten(const Patch& patch, std::string name, const FlattenOptions& options = {},
                      const Context& context = {});

}  // namespace planish
