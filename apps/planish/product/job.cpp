#include "product/job.h"

#include <algorithm>
#include <thread>
#include <utility>

#include <planish/draw/format_drawing.h>
#include <planish/sheet/product_sheet.h>

#include "platform/path.h"
#include "product/nest.h"
#include "product/run.h"
#include "product/seams.h"
#include "product/state.h"
#include "product/text.h"
#include "product/twins.h"
#include "shell/failures.h"
#include "shell/file_name.h"
#include "shell/text.h"
#include "text/json_text.h"
#include "text/summary.h"

namespace planish::cli {

namespace {

void refuse_single_patch_flags(const Arguments& arguments) {
  for (const char* flag : {"--fix", "--weights", "--obstacle", "--history", "--notches", "--marks",
                           "--edge-allowances", "--inner-lines", "--piece-name"}) {
    if (!arguments.has(flag)) continue;
    throw UsageError("flag " + std::string(flag) +
                     " goes with one patch only; the input has several");
  }
}

/// One run over all patches.
class ProductRun {
 public:
  ProductRun(const ProductJob& job, const Arguments& arguments, Session& session)
      : job_(job), arguments_(arguments), session_(session), outcomes_(job.patches.size()) {
    twins_ = twins_among(job.patches, [&] { return session.interrupted(); });
    jobs_.reserve(job.patches.size());
    for (std::size_t p = 0; p < job.patches.size(); ++p) {
      const ProductPatch* twin_of = twins_[p] ? &job.patches[twins_[p]->of] : nullptr;
      jobs_.push_back(job_of(job.patches[p], job.annotations[p], arguments, twin_of));
      outcomes_[p].mesh = job.patches[p].mesh;
    }
  }

  void flatten() {
    const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
    const unsigned threads = session_.threads() == 0 ? cores : session_.threads();
    flatten_patches(
        job_, twins_, not_finished(), threads, [this] { return session_.interrupted(); },
        [this](std::size_t p, FlattenedPatch done) { return take(p, std::move(done)); });
  }

  CommandResult finish() {
    if (interrupted_ || session_.interrupted()) return cancelled();
    if (std::all_of(outcomes_.begin(), outcomes_.end(),
                    [](const PatchOutcome& outcome) { return outcome.failure.has_value(); })) {
      return nothing_done();
    }
    const std::vector<TriMesh> meshes = processed_meshes();
    const auto seams = measure_seams(outcomes_, seams_from(arguments_, meshes), job_.options.unit);
    const auto nesting = laid_on_sheets(meshes);
    if (session_.interrupted()) return cancelled();
    const std::string json = json_with_nesting(product_json(job_, outcomes_, seams), nesting);
    std::vector<OutputFile> files = {{job_.folder / "garment.json", json},
                                     {job_.folder / "garment.svg", picture(seams)}};
    if (nesting) files.insert(files.end(), nesting->files.begin(), nesting->files.end());
    std::string text = patch_lines();
    text += twins_text(outcomes_) + seams_text(job_, seams) + (nesting ? nesting->text : "") +
            written_text(files) + "and a folder for each patch beside it\n";
    CommandResult outcome = with_nesting_checked(with_exit_code({text, json}), nesting);
    session_.write(files, job_.folder);
    return outcome;
  }

 private:
  std::string patch_lines() const {
    std::string text = job_.path + "  (" + std::to_string(outcomes_.size()) + " patches)\n\n";
    for (std::size_t p = 0; p < outcomes_.size(); ++p)
      text += "  " + patch_line(job_.patches[p], outcomes_[p]) + "\n";
    return text;
  }

  /// Where every patch failed: nothing is written.
  CommandResult nothing_done() const {
    return with_exit_code(
        {patch_lines(), json_with_nesting(product_json(job_, outcomes_, {}), std::nullopt)});
  }

  std::string picture(const std::vector<SeamLengths>& measured) const {
    std::vector<ProductPiece> pieces;
    std::vector<Seam> seams;
    pieces.reserve(outcomes_.size());
    seams.reserve(measured.size());
    for (std::size_t p = 0; p < outcomes_.size(); ++p) {
      pieces.push_back(
          {job_.patches[p].name, outcomes_[p].mesh, outcomes_[p].pattern, drawn_twin(p)});
    }
    for (const SeamLengths& seam : measured)
      seams.push_back(seam.seam);
    const std::string title = stem_of(job_.path);
    return format_svg(product_sheet(pieces, seams, job_.options.unit, title));
  }

  /// Whose places a pattern has; nothing for others, nor where vertices have got other numbers.
  std::optional<PieceTwin> drawn_twin(std::size_t p) const {
    if (!outcomes_[p].is_twin || !twins_[p]) return std::nullopt;
    const auto& [other, match] = *twins_[p];
    const std::size_t vertices = match.vertex.size();
    if (outcomes_[p].pattern.size() != vertices || outcomes_[other].pattern.size() != vertices)
      return std::nullopt;
    return PieceTwin{other, match.mirrored, match.vertex};
  }

  std::vector<TriMesh> processed_meshes() const {
    std::vector<TriMesh> meshes;
    meshes.reserve(outcomes_.size());
    for (const PatchOutcome& outcome : outcomes_)
      meshes.push_back(outcome.mesh);
    return meshes;
  }

  /// All patches on sheets, if that was asked for. Notches are put on seams anew: processed patches
  /// may have other numbers of vertices.
  std::optional<NestOutcome> laid_on_sheets(const std::vector<TriMesh>& meshes) const {
    if (!job_.nest) return std::nullopt;
    std::vector<std::string> names;
    names.reserve(job_.patches.size());
    for (const ProductPatch& patch : job_.patches)
      names.push_back(patch.name);
    std::vector<std::vector<Notch>> notches = seam_notches_from(arguments_, meshes, names);
    std::vector<NestPatch> patches;
    patches.reserve(outcomes_.size());
    for (std::size_t p = 0; p < outcomes_.size(); ++p) {
      const bool is_mirrored = outcomes_[p].is_twin && twins_[p] && twins_[p]->match.mirrored;
      PatternOptions annotations =
          is_mirrored ? for_mirror_image(job_.annotations[p]) : job_.annotations[p];
      annotations.notches = std::move(notches[p]);
      patches.push_back({names[p], meshes[p], outcomes_[p].pattern, std::move(annotations)});
    }
    const std::string title = stem_of(job_.path);
    try {
      return try_nest_patches(std::move(patches), job_.options.unit, *job_.nest, job_.folder, title,
                              session_);
    } catch (const Interrupted&) {
      return std::nullopt;
    }
  }

  std::optional<PatchResults> kept_results(std::size_t p) const {
    const ProductPatch& patch = job_.patches[p];
    if (!arguments_.has("--resume") || patch.failure) return std::nullopt;
    return finished_results(jobs_[p], job_.folder / path_of(patch.folder));
  }

  std::vector<std::size_t> not_finished() {
    std::vector<std::optional<PatchResults>> kept(outcomes_.size());
    for (std::size_t p = 0; p < outcomes_.size(); ++p) {
      kept[p] = kept_results(p);
      // Its results are needed once more.
      if (!kept[p] && twins_[p]) kept[twins_[p]->of].reset();
    }
    std::vector<std::size_t> numbers;
    numbers.reserve(outcomes_.size());
    for (std::size_t p = 0; p < outcomes_.size(); ++p) {
      if (kept[p]) {
        keep(p, *std::move(kept[p]));
      } else {
        numbers.push_back(p);
      }
    }
    return numbers;
  }

  void keep(std::size_t p, PatchResults results) {
    PatchOutcome& outcome = outcomes_[p];
    outcome.report = std::move(results.report);
    outcome.mesh = std::move(results.mesh);
    outcome.pattern = std::move(results.pattern);
    outcome.is_twin = results.is_twin;
    outcome.resumed = true;
    ++finished_;
    session_.tell(patch_line(job_.patches[p], outcome));
  }

  bool take(std::size_t p, FlattenedPatch done) {
    PatchOutcome& outcome = outcomes_[p];
    const ProductPatch& patch = job_.patches[p];
    outcome.failure = std::move(done.failure);
    if (!outcome.failure && !done.files) interrupted_ = true;
    if (done.files) write(p, std::move(done));
    if (interrupted_) return false;
    session_.tell(patch_line(patch, outcome));
    ++finished_;
    session_.show_progress("patches",
                           static_cast<double>(finished_) / static_cast<double>(outcomes_.size()),
                           std::to_string(finished_) + " of " + std::to_string(outcomes_.size()));
    return true;
  }

  void write(std::size_t p, FlattenedPatch done) {
    PatchOutcome& outcome = outcomes_[p];
    std::vector<OutputFile> files = std::move(done.files->files);
    // Last, so that it never speaks of files that are not there yet.
    files.push_back(job_file(jobs_[p], files, job_.folder / path_of(job_.patches[p].folder)));
    try {
      session_.write(files, job_.folder);
      outcome.report = std::move(done.files->report);
      outcome.mesh = std::move(done.mesh);
      outcome.pattern = std::move(done.pattern);
      outcome.is_twin = done.is_twin;
    } catch (const Interrupted&) {
      interrupted_ = true;
    } catch (const Error&) {
      outcome.failure = current_failure();
    }
  }

  CommandResult cancelled() const {
    const std::string message = "interrupted; " + std::to_string(finished_) + " of " +
                                std::to_string(outcomes_.size()) +
                                " patches are done, --resume does the rest";
    return {{}, json_failure("interrupted", message), k_exit_interrupted, message};
  }

  CommandResult with_exit_code(CommandResult outcome) const {
    std::string failed, missed, beyond;
    std::size_t failures = 0;
    for (std::size_t p = 0; p < outcomes_.size(); ++p) {
      const std::string name = "\n  " + job_.patches[p].name;
      if (outcomes_[p].failure) failed += (failures++ > 0 ? ", " : "") + job_.patches[p].name;
      if (missed_target(outcomes_[p])) missed += name;
      if (missed_limit(outcomes_[p])) beyond += name;
    }
    if (!failed.empty()) {
      outcome.exit_code = k_exit_failed;
      // The line of each patch gives the reason.
      outcome.complaint = std::to_string(failures) + " of " + std::to_string(outcomes_.size()) +
                          " patches could not be flattened: " + failed;
    } else if (!missed.empty() && arguments_.has("--require-target")) {
      outcome.exit_code = k_exit_target_missed;
      outcome.complaint = "target not met by:" + missed;
    } else if (!beyond.empty()) {
      outcome.exit_code = k_exit_target_missed;
      outcome.complaint = "a limit of strain is not kept by the pattern of:" + beyond;
    }
    return outcome;
  }

  const ProductJob& job_;
  const Arguments& arguments_;
  Session& session_;
  ProductTwins twins_;
  std::vector<std::string> jobs_;
  std::vector<PatchOutcome> outcomes_;
  std::size_t finished_ = 0;
  bool interrupted_ = false;
};

}  // namespace

std::vector<Flag> product_flags() {
  return {
      {"--resume", "",
       "of several patches, keep those whose results are there, whole and of the same job"},
      {"--seam-tolerance",
       "LENGTH",
       "how close borders of several patches must lie to be sewn together, like 0.01mm (default: "
       "at equal places)",
       0,
       false,
       {.range = {.min = 0.0}}}};
}

void refuse_product_flags(const Arguments& arguments) {
  for (const char* flag : {"--resume", "--seam-tolerance"}) {
    if (!arguments.has(flag)) continue;
    throw UsageError("flag " + std::string(flag) + " goes with several patches; the input has one");
  }
}

std::vector<PatternOptions> annotations_of_patches(const PatternOptions& annotations,
                                                   const std::vector<ProductPatch>& patches,
                                                   const Arguments& arguments) {
  refuse_single_patch_flags(arguments);
  std::vector<TriMesh> meshes;
  std::vector<std::string> names;
  meshes.reserve(patches.size());
  names.reserve(patches.size());
  for (const ProductPatch& patch : patches) {
    meshes.push_back(patch.mesh);
    names.push_back(patch.name);
  }
  std::vector<std::vector<Notch>> notches = seam_notches_from(arguments, meshes, names);
  std::vector<PatternOptions> result(patches.size(), annotations);
  for (std::size_t p = 0; p < patches.size(); ++p) {
    result[p].label.name = names[p];
    result[p].notches = std::move(notches[p]);
  }
  return result;
}

CommandResult run_product(const ProductJob& job, const Arguments& arguments, Session& session) {
  ProductRun run(job, arguments, session);
  run.flatten();
  return run.finish();
}

}  // namespace planish::cli
