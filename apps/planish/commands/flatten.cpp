#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>

#include <planish/io/mesh_format.h>
#include <planish/report/json_report.h>

#include "batch/list_run.h"
#include "batch/records.h"
#include "batch/stated_units.h"
#include "commands/commands.h"
#include "commands/jobs.h"
#include "cut/cut_flag.h"
#include "flags/annotation_flags.h"
#include "flags/constraint_flags.h"
#include "flags/fields_flag.h"
#include "flags/limit_flags.h"
#include "flags/material_flag.h"
#include "flags/method_flags.h"
#include "flags/pick_flag.h"
#include "flags/scale_flag.h"
#include "flags/unfold_flags.h"
#include "flags/units.h"
#include "flatten/verdict.h"
#include "layout/nest.h"
#include "layout/sheet_sizes.h"
#include "model/model_flags.h"
#include "model/project_file.h"
#include "model/project_text.h"
#include "output/flatten_files.h"
#include "output/machine.h"
#include "output/open_page.h"
#include "output/pattern_notes.h"
#include "output/pattern_output.h"
#include "piece/piece_settings.h"
#include "platform/path.h"
#include "product/cut_product.h"
#include "product/job.h"
#include "product/parts.h"
#include "product/rename.h"
#include "product/seams.h"
#include "shell/command_line.h"
#include "shell/failures.h"
#include "shell/file_name.h"
#include "shell/output_folder.h"
#include "shell/session.h"
#include "shell/text.h"
#include "shell/values.h"
#include "text/large_patch.h"
#include "text/own_seams.h"
#include "text/summary.h"
#include "text/written_text.h"

namespace planish::cli {

namespace {

namespace fs = std::filesystem;

std::vector<std::string> color_names() {
  return {"diverging", "paper"};
}

fs::path folder_from(const Arguments& arguments) {
  if (arguments.operands.size() > 1 && !arguments.has("--output"))
    throw UsageError("with several files, say where to write: --output FOLDER");
  const std::string stem = stem_of(arguments.operands.front());
  return output_folder(arguments.text("--output", stem + "-pattern"));
}

void refuse_shared_paths(const WrittenFiles& paths) {
  std::vector<OutputFile> files;
  for (const auto& [role, path] : paths)
    files.push_back({path_of(path), {}});
  refuse_shared_places(files);
}

NestPatch nest_patch(const FlattenReport& report, const DrawnPattern& drawn) {
  return {report.name, report.processed.mesh(), report.unfold.pattern.positions,
          drawn.geometry.options};
}

/// How the pieces are laid on sheets; null where they are not.
std::shared_ptr<const NestRequest> nest_from(const Arguments& arguments,
                                             const PatternFiles& pattern) {
  const auto sheets = sheets_from(arguments);
  if (!sheets) return nullptr;
  return std::make_shared<NestRequest>(NestRequest{*sheets, pattern.formats, pattern.output});
}

/// What the flags ask for, of one patch as of several.
struct FlattenRequest {
  fs::path folder;
  FlattenOptions options;
  PatternFiles pattern;
  ReportPageOptions words;
  std::shared_ptr<const NestRequest> nest;
};

ProductJob product_job(FlattenRequest request, ProductInput input,
                       const std::optional<CutOutcome>& cut, const Arguments& arguments,
                       Session& session) {
  std::vector<PieceRequest> requests =
      named_requests(input, request.pattern.annotations, arguments, session);
  const std::vector<std::string>& inputs = arguments.operands;
  ProductJob job{.path = inputs.size() > 1 ? utf8_of(request.folder) : inputs.front(),
                 .patches = std::move(input.patches),
                 .places = std::move(input.places),
                 .is_batch = input.is_batch,
                 .seams = std::move(input.seams),
                 .styles = std::move(input.styles),
                 .cut = cut,
                 .folder = request.folder,
                 .options = product_options_from(arguments, request.options, cut.has_value()),
                 .requests = std::move(requests),
                 .annotations = {},
                 .paths = {},
                 .files_of = {},
                 .nest = request.nest,
                 .formats = request.pattern.formats,
                 .output = request.pattern.output};
  job.project = request.words.project;
  request.words.project.app = "../" + request.words.project.app;  // a piece has a folder of its own
  // A product has its pages together.
  if (!job.is_batch) request.pattern.output.pages.reset();
  job.annotations = annotations_of_patches(job.requests, job.patches, arguments);
  std::vector<MeshFormat> formats;
  for (std::size_t p = 0; p < job.patches.size(); ++p) {
    job.patches[p].keep = named_vertices(job.annotations[p]);
    formats.push_back(output_format(job.places[p].format));
    FlattenOptions options = request.options;
    if (const auto& limits = job.patches[p].limits) options.limits = *limits;
    job.paths.push_back(paths_in(request.folder / path_of(job.places[p].folder), formats[p],
                                 request.pattern, options.may_change(), arguments));
  }
  std::vector<std::optional<Turns>> turns;
  for (const PieceRequest& own : job.requests)
    turns.push_back(own.turns);
  job.files_of = [request, formats, turns, paths = job.paths](const FlattenReport& report,
                                                              std::size_t p,
                                                              const PatternOptions& annotations) {
    ReportPageOptions words = request.words;
    const DrawnPattern drawn = drawn_pattern(report, annotations);
    if (request.nest) {
      NestPatch alone = nest_patch(report, drawn);
      alone.turns = turns[p];
      words.sheet = fit_alone(std::move(alone), request.options.unit, request.nest->sheets);
    }
    return files_of(report, drawn, paths[p], formats[p],
                    {request.pattern.formats, request.pattern.output, annotations}, words,
                    json_report(report, paths[p]));
  };
  return job;
}

PatternPlan plan_of(const PatternFiles& pattern, Unit unit, const NestRequest* nest) {
  return {unit, pattern.output, pattern.annotations,
          nest ? &nest->sheets.of(pattern.annotations.label.fabric) : nullptr};
}

/// Of a patch, and of a product file.
std::vector<std::string> input_extensions() {
  std::vector<std::string> extensions = names_of(k_mesh_formats);
  extensions.emplace_back("json");
  return extensions;
}

FlattenRequest flatten_request_from(const Arguments& arguments, Session& session) {
  if (arguments.has("--open") && arguments.has("--no-report"))
    throw UsageError("--open shows the report, which --no-report leaves out");
  FlattenOptions options = flatten_options_from(arguments);
  ReportPageOptions words{.colors = colors_from(arguments),
                          .command = command_line(flatten_command(), arguments),
                          .reference = session.silent_context(),
                          .project = project_of(arguments)};
  PatternFiles pattern = pattern_files_from(arguments);
  auto nest = nest_from(arguments, pattern);
  return {folder_from(arguments), std::move(options), std::move(pattern), std::move(words),
          std::move(nest)};
}

/// The result of the one patch of a run. What is drawn on the model joins the pattern's
/// annotations.
FlattenReport report_of_one(FlattenRequest& request, ProductInput& read, bool is_cut,
                            const Arguments& arguments, Session& session) {
  FlattenOptions& options = request.options;
  const std::string& name = read.whole.pieces.front();
  const Patch patch(std::move(read.whole.mesh));
  if (options.may_change()) note_obstruction(session, patch);
  if (!options.remesh && options.may_change())
    note_memory(session, options.method.value_or(options.as_needed), patch.vertex_count());
  options.constraints = constraints_from(arguments, patch, session);
  options.constraints.symmetric_in = read.symmetric_in;
  PatternOptions& annotations = request.pattern.annotations;
  annotations = annotations_on(std::move(annotations), arguments, patch, name, session);
  options.keep = named_vertices(annotations);
  check_pattern_size(patch, name, plan_of(request.pattern, options.unit, request.nest.get()),
                     session);
  if (is_cut) match_own_seams(patch, arguments, options, session.silent_context());
  Context context = session.job_context(read.path);
  if (!options.remesh) context = offering_remesh(std::move(context), patch, session);
  return with_turned(flatten(patch, name, options, context), read.whole.turned);
}

void note_result(const FlattenReport& report, const DrawnPattern& drawn,
                 const PatternFiles& pattern, const WrittenFiles& paths, const Arguments& arguments,
                 Session& session) {
  // The text itself asks about the unit of what is far too small or large.
  const bool is_unit_settled = arguments.has("--unit") || !unit_question(report.unfold).empty();
  warn_of_pattern(session, report.unfold, is_unit_settled);
  const Patch& design = report.evolve.remeshed_from ? report.processed : report.input;
  note_unequal_seams(session, design, report.unfold);
  note_pattern(session, drawn.geometry);
  note_empty_layers(session, drawn.sheet, pattern.output);
  if (paths.contains(role_of("pattern", PatternFormat::plt)))
    note_plotter_reach(session, report.unfold);
}

CommandResult flatten_one(FlattenRequest request, ProductInput read,
                          const std::optional<CutOutcome>& cut, const Arguments& arguments,
                          Session& session) {
  const PatternFiles& pattern = request.pattern;
  const std::string &path = read.path, name = read.whole.pieces.front();
  const MeshFormat format = output_format(read.whole.format);
  const WrittenFiles paths =
      paths_in(request.folder, format, pattern, request.options.may_change(), arguments);
  refuse_shared_paths(paths);
  const std::string size = size_text(read.whole.mesh);
  const FlattenReport report = about(
      path, [&] { return report_of_one(request, read, cut.has_value(), arguments, session); });
  const DrawnPattern drawn =
      about(path, [&] { return drawn_pattern(report, pattern.annotations); });
  std::optional<NestOutcome> nesting;
  std::optional<LayoutReport> layout;
  if (request.nest) {
    nesting = about(path, [&] {
      return nest_patches({nest_patch(report, drawn)}, request.options.unit, *request.nest,
                          request.folder, name, session);
    });
    layout = nesting->layout;
    request.words.sheet = nesting->layouts.front();
    request.words.sheet.use += "; drawn in " + utf8_of(nesting->files.front().path.filename());
  }
  const std::string json = json_report(report, paths, figures_of_cut(cut), layout);
  std::vector<OutputFile> files = about(
      path, [&] { return files_of(report, drawn, paths, format, pattern, request.words, json); });
  if (nesting) files.insert(files.end(), nesting->files.begin(), nesting->files.end());
  note_result(report, drawn, pattern, paths, arguments, session);
  const std::string text =
      path + "  (" + size + ")\n" + flatten_text(report) + (nesting ? nesting->text : "");
  CommandResult outcome = with_target_checked(
      {text + written_text(request.folder, paths, files), json}, arguments, report.evolve);
  note_spelling(session, words_of(name, pattern.annotations.label), pattern.formats,
                pattern.output);
  note_divided_pages(session, files, pattern.output);
  std::vector<fs::path> written;
  written.reserve(files.size());
  for (const OutputFile& file : files)
    written.push_back(file.path);
  warn_of_left(session, request.folder, left_of_earlier_runs(request.folder, written));
  session.write(files, request.folder);
  open_if_asked(arguments, request.folder / path_of("report.html"), session);
  return with_design_checked(with_limits_checked(std::move(outcome), report.unfold.limits), report);
}

/// @param is_listed it is one of many inputs, whose --resume is about all of them
CommandResult flatten_inputs(const Arguments& given, bool is_listed, Session& session) {
  const Arguments arguments = without_pieces_out(with_machine(given));
  // Errors of the request come before any work.
  FlattenRequest request = flatten_request_from(arguments, session);
  ProductInput read =
      read_product(session, arguments.operands, arguments, arguments.has("--product"));
  if (read.is_batch) refuse_seam_flags(arguments);
  if (!read.is_described) note_idle_evolve_flags(session, arguments);
  const std::optional<CutOutcome> cut = cut_product(read, request.options, arguments, session);
  request.options.constraints.symmetric_in = read.symmetric_in;
  const bool is_product = read.patches.size() > 1 || read.is_described || arguments.has("--piece");
  if (is_product) rename_pieces(read, arguments);
  if (is_product || read.patches.front().failure) {
    check_copies_of(read.patches.size(),
                    plan_of(request.pattern, request.options.unit, request.nest.get()));
    return run_product(product_job(std::move(request), std::move(read), cut, arguments, session),
                       arguments, session);
  }
  Arguments of_one = arguments;
  if (is_listed) of_one.flags.erase("--resume");
  refuse_product_flags(of_one, !read.left_out.empty());
  return flatten_one(std::move(request), std::move(read), cut, arguments, session);
}

CommandResult flatten_listed(const Arguments& arguments, Session& session) {
  const Arguments own = with_project(flatten_command(), arguments);
  return flatten_inputs(with_stated_unit(flatten_command(), own, session), true, session);
}

CommandResult run_flatten(const Arguments& arguments, Session& session) {
  if (!arguments.has("--inputs")) {
    refuse_list_flags(arguments);
    return flatten_inputs(arguments, false, session);
  }
  if (!arguments.operands.empty())
    throw UsageError("name inputs on the command line or with --inputs, not both");
  return flatten_list(
      inputs_from(arguments, session), arguments,
      [&](const std::string& record) { session.print(record); }, session);
}

}  // namespace

CommandResult flatten_list(std::vector<ListedInput> inputs, const Arguments& arguments,
                           const std::function<void(const std::string& record)>& on_record,
                           Session& session) {
  if (!arguments.has("--output"))
    throw UsageError("with --inputs, say where to write: --output FOLDER");
  Arguments first = arguments;
  first.operands = {inputs.front().path};
  flatten_request_from(with_machine(first), session);  // its errors come before any work
  return run_list({numbered(std::move(inputs)), flatten_listed,
                   [&](const Json& record) { on_record(record_line(record)); }},
                  arguments, session);
}

ColorMap colors_from(const Arguments& arguments) {
  const std::string name = arguments.text("--colors", "diverging");
  return known_name("color map", name, color_names()) == "paper" ? ColorMap::paper
                                                                 : ColorMap::diverging;
}

FlattenOptions flatten_options_from(const Arguments& arguments) {
  const Method method = method_from(arguments, Auto{});
  refuse_unsupported_constraints(arguments, method);
  const auto* as_needed = std::get_if<Auto>(&method);
  matches_seams_of_product(arguments);  // refuses what contradicts itself
  return picked({.method = asks_to_evolve(arguments) ? std::optional(method) : std::nullopt,
                 .as_needed = as_needed != nullptr ? *as_needed : Auto{},
                 .stopping = stopping_from(arguments, method),
                 .unit = unit_from(arguments),
                 .smooth_first = smooth_first_from(arguments),
                 .remesh = arguments.has("--remesh"),
                 .match_seams = arguments.has("--match-seams"),
                 .fold = fold_ends_from(arguments),
                 .least_stretch = arguments.has("--least-stretch"),
                 .limits = limits_from(arguments),
                 .material = material_name_from(arguments),
                 .ways = !arguments.has("--no-report")},
                arguments);
}

Command flatten_command() {
  std::vector<FlagGroup> groups = {
      {"Output",
       {{"--output", "FOLDER", "where to write (default: the input's name with -pattern)", 'o'},
        unit_flag(),
        scale_flag(),
        remesh_flag(),
        smooth_first_flag(),
        match_seams_flag(),
        no_match_seams_flag(),
        least_stretch_flag(),
        pick_flag(),
        formats_flag(),
        {"--colors",
         "NAME",
         "colours of the report's pictures: diverging or paper (default diverging)",
         0,
         false,
         {.choices = color_names(), .standard = "diverging"}},
        {"--textured", "",
         "also write the processed patch as textured.obj, with the pattern in millimetres as "
         "texture coordinates"},
        {"--history",
         "FILE",
         "write the figures of every sweep to FILE, as comma-separated values",
         0,
         false,
         {.extensions = {"csv"}}},
        fields_flag(),
        {"--no-report", "",
         "do not write the page of the report, and do not compute the table of ways to less "
         "stretch"},
        open_flag(),
        {"--require-target", "", "end with exit code 3 if e_max ends above --target-e-max"}}}};
  for (Flag& flag : pattern_flags("also write the pattern as a .pdf of pages to join"))
    groups.front().flags.push_back(std::move(flag));
  for (Flag& flag : product_flags())
    groups.front().flags.push_back(std::move(flag));
  for (Flag& flag : cut_flags())
    groups.front().flags.push_back(std::move(flag));
  groups.push_back({"Many inputs", list_flags()});
  groups.push_back(model_flags());
  groups.push_back(annotation_flags());
  groups.push_back(nest_flags());
  for (FlagGroup& group : method_flags(Auto{})) {
    if (group.method == Auto::name) group.first_title = "How to evolve";
    groups.push_back(std::move(group));
  }
  groups.push_back(constraint_flags());
  mark_first(groups,
             {"--output", "--unit", "--cut", "--max-deviation", "--formats", "--paper",
              "--allowance", "--notches", "--grain", "--max-strain", "--material", "--pick"});
  return {
      "flatten",
      "the whole job: from a patch to its pattern at true size",
      "INPUT... [-o FOLDER]",
      "Lays a patch flat as it is, with its stretch spread out, and says how much the sheet must "
      "stretch. Changes the form only if a limit or --pick asks for less stretch, and then as "
      "little as needed. Writes into FOLDER: the pattern at true size (pattern.svg, .dxf and "
      ".pdf), the pattern of the design if the form may change (as-designed.*), the processed "
      "patch and the flat pattern as meshes, and a report with pictures (report.html, "
      "report.json). Either all files are written or none.",
      {"INPUT"},
      std::move(groups),
      {"planish flatten panel.obj", "planish flatten panel.obj -o out --unit cm --max-strain 2%",
       "planish flatten front.obj back.obj -o out --product",
       "planish flatten panel.obj --cut darts.txt",
       "planish flatten panel.obj --paper a4 --dxf-profile lectra",
       "planish flatten panel.obj --allowance 10mm --grain 0,0,1 --quantity 2",
       "planish flatten jacket.obj --allowance 10mm --grain 0,0,1 --sheet 1500mm",
       "planish flatten suit.json -o out",
       "planish flatten panel.obj --material leather --max-deviation 5mm",
       "planish flatten panel.obj --target-e-max 0.001 --require-target",
       "planish flatten --inputs patches.txt -o out --shard 1/20 --no-report --resume"},
      run_flatten,
      false,
      true,
      {{.extensions = input_extensions()}}};
}

}  // namespace planish::cli
