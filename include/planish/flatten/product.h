#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <planish/flatten/flatten.h>
#include <planish/mesh/seams.h>

namespace planish {

/// What people say of a piece beside its form, as a product file does.
struct PieceMetadata {
  std::string material = {};  ///< what it is cut from; empty: not said
  int quantity = 0;           ///< how many to cut; 0: not said
  std::string source = {};    ///< file that it was read from; empty: none
};

/// A patch of a product, as it comes.
struct ProductPatch {
  std::string name;              ///< for people; names may be equal
  TriMesh mesh;                  ///< anything that was read: what is wrong with it is a failure
  std::vector<Index> keep = {};  ///< vertices that remeshing leaves
  /// Why there is nothing to be done, as where its file could not be read: it becomes the result.
  std::optional<Failure> failure = {};
  /// Seams are searched only between patches of the same number, like that of the file.
  std::size_t group = 0;
  PieceMetadata words = {};  ///< become those of the result
  /// Instead of those of ProductOptions.
  std::optional<StrainLimits> limits = {};
  /// Instead of that of ProductOptions: as UnfoldOptions has it.
  std::optional<std::array<Index, 2>> fold = {};
  bool turned = false;  ///< becomes that of the result's UnfoldReport
};

/// How flatten_product() works.
struct ProductOptions {
  /// How every patch is flattened. `constraints`, `keep` and `free_edges` name vertices of one mesh
  /// and must be empty. With match_seams, the border of every patch keeps its lengths, but for
  /// edges along no seam in patches that have seams; a patch that cannot fails.
  FlattenOptions flatten = {};
  double seam_tolerance = 0.0;  ///< as find_seams() has it, model units
  /// Border edges along seams keep their lengths, so that both sides of a seam are equally long. A
  /// patch that cannot is laid flat without: Pattern::is_unmatchable. Idle with
  /// flatten.match_seams.
  bool match_seams = true;
  /// With match_seams: of the pieces of one form that was cut. Edges of seams with equal vertices
  /// on both sides get a common length instead, the mean of what they have in the patterns of both
  /// sides, but within a tenth of their own: these strain less. Where a piece keeps its limits in
  /// no pattern, edges sewn to it keep their own. Idle with flatten.match_seams,
  /// and with a method, smoothing or remeshing, which change lengths.
  bool common_lengths = false;
};

/// Another patch of the product that a patch is the mirror image of, or equal to.
struct PatchTwin {
  std::size_t patch = 0;  ///< number of the other one, which comes earlier and is no twin itself
  bool mirrored = false;  ///< else it is a copy
  std::vector<Index> vertex;  ///< of the other one -> of this one
};

/// What of a patch's border keeps its length, as it is sewn.
struct SewnBorder {
  bool has_seams = false;                             ///< some of it does
  std::vector<std::array<Index, 2>> free_edges = {};  ///< along no seam; empty without seams
  std::vector<EdgeLength> lengths = {};               ///< that seams get instead of their own
};

/// Of a patch alone that is sewn to itself, as along slits and darts: with lengths as
/// ProductOptions::common_lengths has it. Without such seams, and where its lengths do not stay or
/// no pattern keeps the limits, nothing of it is sewn.
/// @throws Cancelled
SewnBorder find_own_seams(const Patch& patch, const FlattenOptions& options,
                          const Context& context);

/// What the product as a whole needs of a patch that was flattened; a full report is many times as
/// large.
struct FinishedPatch {
  TriMesh processed;    ///< the patch that the pattern is of
  UnfoldReport unfold;  ///< without the patterns that the pattern is only compared with
  Deviation deviation;  ///< of `processed` from the input patch
  StopReason stop = StopReason::sweep_limit;  ///< why evolving ended
  std::optional<TwinOf> twin_of = {};  ///< where it is made from the results of another patch
  /// Where evolving made the pattern worse, and the design was kept: the strain it came to.
  std::optional<EdgeStrain> rejected = {};
  std::vector<LimitCheck> limits = {};      ///< every limit and target that was asked for
  std::vector<FormFault> form_faults = {};  ///< what is wrong with the form
  std::string cautions = {};  ///< what the mesh cannot show, in sentences; empty for none
  /// Why it cannot be judged whether the piece lies flat: "no vertex inside"; empty where it can.
  std::string not_judged = {};
  /// For each vertex of `processed` its number in the input patch, increasing. Empty: the same.
  std::vector<Index> source = {};

  /// As of the report that it is made of.
  Outcome outcome() const;
};

/// That of a report.
FinishedPatch finished_patch(const FlattenReport& report);

/// What became of a patch: it is finished or failed.
struct PatchResult {
  std::string name;                            ///< of ProductPatch
  std::size_t vertices = 0, triangles = 0;     ///< of the input patch
  std::optional<FinishedPatch> finished = {};  ///< its result
  std::optional<Failure> failure = {};         ///< why it has none
  bool resumed = false;                        ///< finished in an earlier run
  PieceMetadata words = {};                    ///< of ProductPatch
  std::size_t group = 0;                       ///< of ProductPatch
  /// For each vertex of finished->processed its position in the input patch, model units. Empty if
  /// no vertex moved or the patch is not finished.
  std::vector<Vec3> design = {};

  /// That of the result; of a patch without one, it misses Criterion::failure.
  Outcome outcome() const;
};

/// A seam with its lengths in millimetres, the first side's first.
struct MeasuredSeam {
  Seam seam;                            ///< by the numbers of the processed patches
  std::array<double, 2> on_model = {};  ///< on the processed patches
  std::array<std::optional<double>, 2> in_pattern = {};  ///< none where a patch has no pattern
  std::string name = {};                                 ///< for people; empty: none

  /// Of the lengths in both patterns, at least 0.
  std::optional<double> difference() const;
  /// Of the lengths on the model, at least 0. Sides with equal vertices have none but rounding.
  double difference_on_model() const;
  /// The side that is longer in its pattern, 0 or 1; none where they differ by less than 0.01 mm.
  std::optional<std::size_t> longer() const;
  /// The same on the model.
  std::optional<std::size_t> longer_on_model() const;
};

/// What became of a product.
struct ProductReport {
  Unit unit = Unit::mm;                         ///< one unit of the model
  std::vector<PatchResult> patches;             ///< by the numbers of the patches that came
  std::vector<std::optional<PatchTwin>> twins;  ///< one for each patch, by the patches as they came
  std::vector<MeasuredSeam> seams;              ///< none where no patch is finished
  std::vector<NearBorders> near_borders;        ///< of the input patches; lengths in millimetres

  /// How many patches are finished.
  std::size_t finished() const;
};

/// Functions that flatten_product() calls. All may be empty.
struct ProductCallbacks {
  /// What an earlier run made of a patch; nothing where it is to be flattened. Called once for each
  /// patch before the work begins, from the calling thread, with its twin or nullptr: what is made
  /// of a twin depends on the mesh of the other one as well, and with seams that match on what is
  /// sewn. Patterns must have a place for every vertex of the processed patch.
  std::function<std::optional<FinishedPatch>(std::size_t patch, const PatchTwin* twin,
                                             const SewnBorder& border)>
      earlier = {};
  /// Receives the full report of a patch as soon as it is there, to make what is kept of it: it is
  /// gone afterwards. Called from the thread that flattened the patch, so that this work is divided
  /// among threads too, for several patches at the same time; with one thread from the calling
  /// thread. What it throws becomes the failure of the patch.
  /// @param twin that the report was made from, else nullptr
  std::function<void(std::size_t patch, const FlattenReport& report, const PatchTwin* twin)>
      on_report = {};
  /// Called from the calling thread once for each patch that is finished or failed, first for those
  /// of an earlier run. It may change the result: a patch whose files could not be written is one
  /// that failed.
  std::function<void(std::size_t patch, PatchResult& result)> on_done = {};
};

/// Flattens the patches of a product, the largest first, each on one thread; twins with the same
/// limits get what was made of the other one. A patch that fails does not stop the others. A result
/// of an earlier run whose twin is still to be made is made again, as only its full report will do
/// for that.
/// @param context its threads are the number of patches that are worked on at a time
/// @throws Error unsupported_constraint, and option_out_of_range for options and limits of patches
///   out of their range, before any work; Cancelled
ProductReport flatten_product(std::span<const ProductPatch> patches,
                              const ProductOptions& options = {},
                              const ProductCallbacks& callbacks = {}, const Context& context = {});

/// The meshes of a product as they are now: processed where a patch is finished, else the input.
std::vector<TriMesh> meshes_now(std::span<const ProductPatch> patches, const ProductReport& report);

/// find_seams() of the patches that can be measured; the others take part in no seam.
std::vector<Seam> find_sound_seams(std::span<const TriMesh> patches, double tolerance = 0.0);

/// find_sound_seams() of each group of patches by itself, the groups by their numbers.
/// @param groups number of the group that a patch is in, of each patch
std::vector<Seam> find_seams_in_groups(std::span<const TriMesh> patches,
                                       std::span<const std::size_t> groups, double tolerance = 0.0);

}  // namespace planish
