#include "product/job.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include <planish/draw/format_drawing.h>
#include <planish/report/html_report.h>
#include <planish/sheet/product_sheet.h>

#include "flags/annotation_flags.h"
#include "flags/unfold_flags.h"
#include "layout/nest.h"
#include "layout/size_nests.h"
#include "output/open_page.h"
#include "output/pattern_notes.h"
#include "platform/path.h"
#include "product/rename.h"
#include "product/seams.h"
#include "product/state.h"
#include "product/text.h"
#include "shell/command_line.h"
#include "shell/failures.h"
#include "shell/file_name.h"
#include "shell/text.h"
#include "text/json_text.h"
#include "text/lengths.h"
#include "text/written_text.h"

namespace planish::cli {

namespace {

/// One run over all patches.
class ProductRun {
 public:
  ProductRun(const ProductJob& job, const Arguments& arguments, Session& session)
      : job_(job),
        arguments_(arguments),
        session_(session),
        jobs_(job.patches.size()),
        files_(job.patches.size()) {}

  void flatten() {
    report_ = flatten_product(
        job_.patches, job_.options,
        {.earlier = [this](std::size_t p, const PatchTwin* twin,
                           const SewnBorder& border) { return kept(p, twin, border); },
         .on_report = [this](std::size_t p, const FlattenReport& report,
                             const PatchTwin* twin) { make_files(p, report, twin); },
         .on_done = [this](std::size_t p, PatchResult& result) { take(p, result); }},
        session_.job_context({}));
    report_.seams = with_names(std::move(report_.seams), report_.patches, job_.seams, session_);
  }

  CommandResult cancelled() const {
    const std::string message = "interrupted; " + std::to_string(finished_) + " of " +
                                std::to_string(job_.patches.size()) +
                                " patches are done, --resume does the rest";
    return {{}, json_failure("interrupted", message), k_exit_interrupted, message};
  }

  CommandResult finish() {
    if (report_.finished() == 0) return with_exit_code({patch_lines(), json({})});
    const auto nesting = laid_on_sheets();
    const std::string garment =
        json(nesting ? std::optional(nesting->layout) : std::optional<LayoutReport>());
    const std::string picture = format_svg(product_sheet(report_, stem_of(job_.path)));
    std::vector<OutputFile> files = {{job_.folder / path_of("garment.json"), garment},
                                     {job_.folder / path_of("garment.svg"), picture}};
    if (!arguments_.has("--no-report"))
      files.insert(files.begin() + 1, {job_.folder / path_of("garment.html"), page(nesting)});
    if (nesting) files.insert(files.end(), nesting->files.begin(), nesting->files.end());
    const ProductPages pages = on_pages();
    files.insert(files.end(), pages.files.begin(), pages.files.end());
    const bool writes_dxf = std::find(job_.formats.begin(), job_.formats.end(),
                                      PatternFormat::dxf) != job_.formats.end();
    if (writes_dxf && job_.output.dxf.profile != DxfProfile::generic)
      files.push_back({job_.folder / path_of("garment.dxf"), pieces_in_dxf()});
    for (OutputFile& file : nests_of_sizes())
      files.push_back(std::move(file));
    std::string text = patch_lines();
    text += twins_text(report_) + seams_text(report_, job_.is_batch) +
            (nesting ? nesting->text : "") + pages.text + written_text(files) +
            "Each patch has a folder of its own beside these; patterns lie outer side up.\n";
    CommandResult outcome =
        with_pages_checked(with_nesting_checked(with_exit_code({text, garment}), nesting), pages);
    note_cautions_and_sizes(session_, report_, arguments_.has("--unit"));
    note_words();
    note_patterns();
    note_divided_pages(session_, files, job_.output);
    warn_of_left(session_, job_.folder, left_behind(files));
    session_.write(files, job_.folder);
    open_if_asked(arguments_, job_.folder / path_of("garment.html"), session_);
    return outcome;
  }

 private:
  void note_words() const {
    std::vector<std::string> words;
    for (std::size_t p = 0; p < job_.patches.size(); ++p) {
      for (std::string& word : words_of(job_.patches[p].name, job_.annotations[p].label))
        words.push_back(std::move(word));
    }
    note_spelling(session_, words, job_.formats, job_.output);
  }

  /// What earlier runs left beside the pieces, and in the folders of these.
  std::vector<std::string> left_behind(const std::vector<OutputFile>& files) const {
    std::vector<std::filesystem::path> written;
    written.reserve(files.size());
    for (const OutputFile& file : files)
      written.push_back(file.path);
    std::vector<std::string> names;
    for (std::size_t p = 0; p < job_.patches.size(); ++p) {
      written.push_back(folder_of(p));
      std::vector<std::filesystem::path> own;
      if (report_.patches[p].finished) {
        for (const auto& [role, path] : job_.paths[p])
          own.push_back(path_of(path));
      }
      for (const std::string& name : left_of_earlier_runs(folder_of(p), own))
        names.push_back(job_.places[p].folder + "/" + name);
    }
    std::vector<std::string> beside = left_of_earlier_runs(job_.folder, written);
    names.insert(names.begin(), beside.begin(), beside.end());
    return names;
  }

  void note_patterns() const {
    const bool has_allowance =
        std::any_of(job_.annotations.begin(), job_.annotations.end(),
                    [](const PatternOptions& own) { return own.allowance.has_value(); });
    const bool has_notches =
        std::any_of(job_.annotations.begin(), job_.annotations.end(),
                    [](const PatternOptions& own) { return !own.notches.empty(); });
    if (!has_allowance && !has_notches && job_.output.only_layers.empty()) return;
    try {
      const NestJob pieces{patches_with_notches(), report_.unit};
      std::vector<PatternGeometry> patterns;
      for (std::size_t p = 0; p < pieces.patches.size(); ++p) {
        const NestPatch& patch = pieces.patches[p];
        if (patch.pattern.empty()) continue;
        const auto& twin = report_.twins[p];
        patterns.push_back(pattern_geometry(patch, report_.unit));
        // A twin would repeat the notes of the first one.
        if (twin && !pieces.patches[twin->patch].pattern.empty()) patterns.back().notches.clear();
      }
      note_notches(session_, patterns);
      if (!job_.output.only_layers.empty())
        note_empty_layers(session_, pieces_sheet(pieces, report_.twins, ""), job_.output);
      for (const PatternGeometry& pattern : patterns) {
        note_filled(session_, pattern);
        note_left_out(session_, pattern);
      }
    } catch (const Error&) {
      // The piece that cannot be drawn has reported this error already.
    }
  }

  std::filesystem::path folder_of(std::size_t p) const {
    return job_.folder / path_of(job_.places[p].folder);
  }

  std::string patch_lines() const { return job_.path + "  " + pieces_text(report_); }

  std::string page(const std::optional<NestOutcome>& nesting) const {
    ProductPage page{.name = stem_of(job_.path), .project = job_.project};
    if (nesting) {
      page.sheets = nesting->sheets;
      page.on_sheets = words_of(nesting->layouts);
    }
    for (const PatchPlace& place : job_.places)
      page.reports.push_back(place.folder + "/report.html");
    return html_report(report_, page);
  }

  std::string json(const std::optional<LayoutReport>& layout) const {
    ProductFiles files{{}, job_.paths};
    for (const PatchPlace& place : job_.places)
      files.folders.push_back(place.folder);
    return json_report(report_, stem_of(job_.path), files, layout,
                       job_.cut ? std::optional(figures_of(*job_.cut)) : std::nullopt);
  }

  /// Notches are put on seams anew: processed patches may have other numbers of vertices.
  std::vector<NestPatch> patches_with_notches() const {
    std::vector<PatternOptions> annotations = job_.annotations;
    for (std::size_t p = 0; p < annotations.size(); ++p) {
      annotations[p].notches = job_.requests[p].annotations.notches;
      const auto& finished = report_.patches[p].finished;
      if (finished && !finished->source.empty())
        annotations[p] = renumbered(std::move(annotations[p]), finished->source);
    }
    std::vector<TriMesh> meshes;
    for (const ProductPatch& patch : job_.patches)
      meshes.push_back(patch.mesh);
    const std::vector<SeamNotch> notches = seam_notches_from(arguments_, meshes);
    std::vector<NestPatch> patches = about(arguments_.text("--seam-notches"), [&] {
      return patches_to_cut(job_.patches, report_, std::move(annotations), notches);
    });
    for (std::size_t p = 0; p < patches.size(); ++p)
      patches[p].turns = job_.requests[p].turns;
    return patches;
  }

  /// All patches on sheets, if that was asked for.
  std::optional<NestOutcome> laid_on_sheets() const {
    if (!job_.nest) return std::nullopt;
    return try_nest_patches(patches_with_notches(), report_.unit, *job_.nest, job_.folder,
                            stem_of(job_.path), session_);
  }

  /// All patches on pages, if that was asked for. Those of a batch have pages of their own.
  ProductPages on_pages() const {
    if (!job_.output.pages || job_.is_batch) return {};
    return product_pages(patches_with_notches(), report_.unit,
                         job_.nest ? &job_.nest->sheets.any() : nullptr, job_.output, job_.folder,
                         stem_of(job_.path), session_);
  }

  /// Sizes of one piece over each other, where there are several.
  std::vector<OutputFile> nests_of_sizes() const {
    const auto has_sizes = [](const std::string& style) { return !style.empty(); };
    if (std::none_of(job_.styles.begin(), job_.styles.end(), has_sizes)) return {};
    return size_nest_files(patches_with_notches(), job_.styles, report_.unit, job_.formats,
                           job_.output, job_.folder, session_);
  }

  /// As apparel programs read them.
  std::string pieces_in_dxf() const {
    const NestJob pieces{patches_with_notches(), report_.unit};
    return pattern_file(pieces_sheet(pieces, report_.twins, stem_of(job_.path)), PatternFormat::dxf,
                        job_.output);
  }

  std::optional<FinishedPatch> kept(std::size_t p, const PatchTwin* twin,
                                    const SewnBorder& border) {
    const ProductPatch* other = twin ? &job_.patches[twin->patch] : nullptr;
    jobs_[p] = job_of(job_.patches[p], job_.places[p].format, job_.annotations[p], border,
                      arguments_, other, job_.requests[p].own);
    if (!arguments_.has("--resume")) return std::nullopt;
    return finished_results(jobs_[p], folder_of(p));
  }

  /// From any thread.
  void make_files(std::size_t p, const FlattenReport& report, const PatchTwin* twin) {
    const PatternOptions& own = job_.annotations[p];
    files_[p] = job_.files_of(
        report, p, twin ? annotations_of_twin(own, job_.patches[twin->patch].mesh, *twin) : own);
  }

  void take(std::size_t p, PatchResult& result) {
    if (result.finished && !result.resumed) write(p, result);
    session_.tell(patch_line(result));
    ++finished_;
  }

  void write(std::size_t p, PatchResult& result) {
    std::vector<OutputFile> files = std::move(files_[p]);
    note_divided_pages(session_, files, job_.output);
    // Last, so that it never speaks of files that are not there yet.
    files.push_back(job_file(jobs_[p], *result.finished, files, folder_of(p)));
    try {
      session_.write(files, job_.folder);
    } catch (const Error&) {
      result.finished.reset();
      result.failure = current_failure();
    }
  }

  /// The names of those pieces, a line each.
  template <class IsOne>
  std::string names_where(const IsOne& is_one) const {
    std::string names;
    for (const PatchResult& patch : report_.patches) {
      if (patch.finished && is_one(*patch.finished)) names += "\n  " + patch.name;
    }
    return names;
  }

  std::string failures() const {
    std::string names, unfit;  // of all, and of those that were read
    std::size_t count = 0;
    for (std::size_t p = 0; p < report_.patches.size(); ++p) {
      const PatchResult& patch = report_.patches[p];
      if (!patch.failure) continue;
      names += (count++ > 0 ? ", " : "") + patch.name;
      if (!job_.patches[p].failure) unfit += (unfit.empty() ? "" : ",") + patch.name;
    }
    if (count == 0) return {};
    // The line of each patch gives the reason.
    return std::to_string(count) + " of " + std::to_string(report_.patches.size()) +
           " patches could not be flattened: " + names +
           (unfit.empty() ? "" : "\nleave out with --without " + shell_word(unfit));
  }

  /// What is missed, and by which pieces: every one with a cross is named.
  std::string complaints() const {
    const std::string off_target =
        names_where([](const FinishedPatch& patch) { return !patch.outcome().target_met(); });
    const std::string beyond =
        names_where([](const FinishedPatch& patch) { return !all_kept(patch.unfold.limits); });
    const std::string rejected =
        names_where([](const FinishedPatch& patch) { return patch.rejected.has_value(); });
    if (!off_target.empty() && arguments_.has("--require-target"))
      return "target not met by:" + off_target;
    std::string text;
    if (!beyond.empty()) text = "a limit of strain is not kept by the pattern of:" + beyond;
    if (!rejected.empty()) {
      text += (text.empty() ? "" : "\n") +
              std::string(
                  "evolving would have stretched the pattern more, and the pattern of the "
                  "design was written, of:") +
              rejected;
    }
    const std::string others = names_where([](const FinishedPatch& patch) {
      return !patch.outcome().usable() && all_kept(patch.unfold.limits) && !patch.rejected;
    });
    if (!others.empty())
      text += (text.empty() ? "" : "\n") + std::string("do not cut as they are:") + others;
    return text;
  }

  CommandResult with_exit_code(CommandResult outcome) const {
    const std::string failed = failures();
    outcome.complaint = failed.empty() ? complaints() : failed;
    if (!failed.empty())
      outcome.exit_code = k_exit_failed;
    else if (!outcome.complaint.empty())
      outcome.exit_code = k_exit_target_missed;
    return outcome;
  }

  const ProductJob& job_;
  const Arguments& arguments_;
  Session& session_;
  std::vector<PatchJob> jobs_;
  std::vector<std::vector<OutputFile>> files_;  // of each patch, until they are written
  ProductReport report_;
  std::size_t finished_ = 0;
};

}  // namespace

CommandResult run_product(const ProductJob& job, const Arguments& arguments, Session& session) {
  ProductRun run(job, arguments, session);
  try {
    run.flatten();
    return run.finish();
  } catch (const Cancelled&) {
    return run.cancelled();
  }
}

}  // namespace planish::cli
