#include <iterator>
#include <utility>

#include <planish/report/json_report.h>
#include <planish/sheet/pattern_sheet.h>

#include <pybind11/stl.h>

#include "arrays.h"
#include "commands/jobs.h"
#include "fields.h"
#include "flags/annotation_flags.h"
#include "flags/constraint_flags.h"
#include "flags/limit_flags.h"
#include "flags/unfold_flags.h"
#include "flags/units.h"
#include "flatten/verdict.h"
#include "job.h"
#include "keywords.h"
#include "output/pattern_notes.h"
#include "pattern_data.h"
#include "pickle.h"
#include "platform/path.h"
#include "product/cut_product.h"
#include "product/seams.h"
#include "shell/output_folder.h"
#include "text/own_seams.h"
#include "text/summary.h"

namespace planish::python {

namespace {

struct UnfoldResult {
  std::string name;
  Patch patch;
  UnfoldReport report;
  cli::PatternFiles pattern;
  std::vector<Caution> cautions = {};
  std::optional<cli::CutOutcome> cut = {};
  std::vector<std::string> notes = {};
};

/// A pattern as it can be drawn.
struct Drawable {
  const Patch& model;  ///< that lines were drawn over
  const Patch& patch;
  const UnfoldReport& unfold;
  std::string name;
  cli::PatternFiles pattern;  ///< by the vertices of `patch`
};

FlattenResult flatten_mesh(const MeshData& data, const py::dict& keywords, py::object progress) {
  const cli::Arguments arguments = arguments_on(data, "flatten", keywords);
  FlattenOptions options = cli::flatten_options_from(arguments);
  cli::colors_from(arguments);
  cli::PatternFiles pattern = cli::pattern_files_from(arguments);
  Job job(arguments, std::move(progress));
  FlattenResult result = job.run([&](cli::Session& session) {
    cli::CutInput input =
        cut_input(data, arguments, session, {.panels = cli::panel_rules(options, arguments)});
    const Patch patch(std::move(input.mesh));
    cli::note_obstruction(session, patch);
    options.constraints = cli::constraints_from(arguments, patch, session);
    options.constraints.symmetric_in = input.symmetric_in;
    pattern.annotations =
        cli::annotations_on(std::move(pattern.annotations), arguments, patch, data.name, session);
    options.keep = named_vertices(pattern.annotations);
    if (input.cut) cli::match_own_seams(patch, arguments, options, session.silent_context());
    FlattenReport report = flatten(patch, data.name, options, session.job_context({}));
    cli::warn_of_pattern(session, report.unfold, arguments.has("--unit"));
    cli::note_cautions(session, data.name, report.cautions, cli::unit_from(arguments));
    const Patch& design = report.evolve.remeshed_from ? report.processed : report.input;
    cli::note_unequal_seams(session, design, report.unfold);
    return FlattenResult{std::move(report), pattern, arguments, input.cut,
                         cli::output_format(data.format)};
  });
  result.notes = notes_on(data, arguments, job.notes());
  return result;
}

UnfoldResult unfold_mesh(const MeshData& data, const py::dict& keywords, py::object progress) {
  const cli::Arguments arguments = arguments_on(data, "unfold", keywords);
  cli::UnfoldRequest request = cli::unfold_request_from(arguments, true);
  cli::PatternFiles pattern = {{}, request.output, request.annotations};
  Job job(arguments, std::move(progress));
  UnfoldResult result = job.run([&](cli::Session& session) {
    cli::CutInput input = cut_input(data, arguments, session);
    const Patch patch(std::move(input.mesh));
    pattern.annotations =
        cli::annotations_on(std::move(pattern.annotations), arguments, patch, data.name, session);
    std::vector<Caution> cautions = find_cautions(patch);
    pattern.annotations.cautions = words_of(cautions);
    request.options.symmetric_in = input.symmetric_in;
    UnfoldReport report =
        unfold_patch(patch, request.unit, request.options, session.job_context({}));
    cli::note_cautions(session, data.name, cautions, request.unit);
    cli::warn_of_pattern(session, report, arguments.has("--unit"));
    cli::note_unequal_seams(session, patch, report);
    return UnfoldResult{data.name,           patch,    std::move(report), pattern,
                        std::move(cautions), input.cut};
  });
  result.notes = notes_on(data, arguments, job.notes());
  return result;
}

cli::PatternFormat format_named(const std::string& name) {
  return *cli::pattern_format_of("pattern." + name);
}

/// What keywords ask of a drawing, instead of what its result was made with.
cli::PatternFiles pattern_files_of(const Drawable& drawable, cli::PatternFormat format,
                                   const py::dict& keywords) {
  py::dict all(keywords);
  all["unit"] = std::string(to_string(drawable.unfold.unit));
  const cli::Arguments arguments = arguments_of("unfold", all);
  cli::refuse_idle_pattern_flags(arguments, {format});
  cli::UnfoldRequest request = cli::unfold_request_from(arguments, true);
  cli::PatternFiles files = {{}, std::move(request.output), std::move(request.annotations)};
  files.annotations = Job(arguments, py::none()).run([&](cli::Session& session) {
    return cli::annotations_on(std::move(files.annotations), arguments, drawable.model,
                               drawable.name, session);
  });
  files.annotations.model_scale = drawable.pattern.annotations.model_scale;
  files.annotations.moved = drawable.pattern.annotations.moved;
  files.annotations.form_faults = drawable.pattern.annotations.form_faults;
  files.annotations.cautions = drawable.pattern.annotations.cautions;
  return files;
}

py::bytes drawing_of(const Drawable& drawable, const std::string& format_name,
                     const py::dict& keywords) {
  const cli::PatternFormat format = format_named(format_name);
  const cli::PatternFiles files =
      keywords.empty() ? drawable.pattern : pattern_files_of(drawable, format, keywords);
  std::string content;
  {
    const py::gil_scoped_release no_python;
    const Drawing sheet =
        pattern_sheet(drawable.patch, drawable.unfold, drawable.name, files.annotations);
    const bool is_tiled = files.output.pages && format == cli::PatternFormat::pdf;
    content = is_tiled ? cli::tiled_file(sheet, files.output)
                       : cli::pattern_file(sheet, format, files.output);
  }
  return py::bytes(content);
}

/// The pattern of the result, or that of the design. Pages of paper are a file of their own, made
/// where `paper` stands among the keywords.
py::bytes drawing_of_flatten(const FlattenResult& result, const std::string& format,
                             bool as_designed, const py::dict& keywords) {
  const FlattenReport& report = result.report;
  cli::PatternFiles own = result.pattern;
  own.annotations = on_processed(std::move(own.annotations), report);
  own.output.pages.reset();
  if (as_designed) {
    own.annotations.moved.reset();
    own.annotations.form_faults.clear();
    return drawing_of({report.input, report.input, report.design_pattern,
                       report.name + ", as designed", std::move(own)},
                      format, keywords);
  }
  return drawing_of({report.input, report.processed, report.unfold, report.name, std::move(own)},
                    format, keywords);
}

py::bytes drawing_of_unfold(const UnfoldResult& result, const std::string& format,
                            const py::dict& keywords) {
  return drawing_of({result.patch, result.patch, result.report, result.name, result.pattern},
                    format, keywords);
}

/// Writes what `flatten` of the program writes: role -> path.
WrittenFiles save_result(const FlattenResult& result, const py::object& path) {
  const auto folder = py::module_::import("os").attr("fspath")(path).cast<std::string>();
  const py::gil_scoped_release no_python;
  const auto place = cli::output_folder(folder);
  const SavedFiles saved = files_in(result, place);
  write_files(saved.files, place);
  return saved.paths;
}

/// Lines and points as arrays, millimetres.
py::dict arrays_of(PatternGeometry pattern) {
  const auto lines = [](std::vector<Polygon>& polygons) {
    py::list arrays;
    for (Polygon& polygon : polygons)
      arrays.append(array_of(std::move(polygon)));
    return arrays;
  };
  std::vector<Vec2> notches;
  std::vector<Polygon> strokes;
  for (PlacedNotch& notch : pattern.notches) {
    notches.push_back(notch.at);
    std::move(notch.strokes.begin(), notch.strokes.end(), std::back_inserter(strokes));
  }
  py::dict arrays;
  arrays["seam"] = lines(pattern.outline.loops);
  arrays["cut"] = lines(pattern.cut);
  arrays["notches"] = array_of(std::move(notches));
  arrays["notch_lines"] = lines(strokes);
  arrays["grain"] = lines(pattern.grain);
  arrays["fold"] = array_of(std::move(pattern.fold));
  arrays["marks"] = array_of(std::move(pattern.marks));
  arrays["inner_lines"] = lines(pattern.inner_lines);
  arrays["vertices"] = array_of(std::move(pattern.positions));
  return arrays;
}

PatternGeometry geometry_of(const FlattenResult& result) {
  return pattern_geometry(result.report, result.pattern.annotations);
}

PatternGeometry geometry_of(const UnfoldResult& result) {
  return pattern_geometry(result.patch.mesh(), result.report, result.name,
                          result.pattern.annotations);
}

std::string described_pattern(const py::object& self, const UnfoldReport& report,
                              const std::string& form_faults) {
  const auto shown = [](double value, int digits) {
    return py::str("{:." + std::to_string(digits) + "f}").format(value).cast<std::string>();
  };
  const auto kind = py::type::of(self).attr("__name__").cast<std::string>();
  std::string text = "<planish." + kind + " " + self.attr("name").cast<std::string>() + ": " +
                     shown(report.pattern.width, 1) + " x " + shown(report.pattern.height, 1) +
                     " " + std::string(to_string(report.unit)) + ", strain rms " +
                     shown(100.0 * report.strain.rms, 2) + " %, largest " +
                     shown(100.0 * report.strain.max, 2) + " %";
  if (!report.limits.empty())
    text += all_kept(report.limits) ? ", limits kept" : ", limits NOT kept";
  if (report.pattern.overlaps) text += ", overlaps itself";
  if (!form_faults.empty()) text += ", the form " + form_faults;
  return text + ">";
}

std::string form_faults_of(const FlattenResult& result) {
  return form_faults(result.report.evolve);
}

std::string form_faults_of(const UnfoldResult&) {
  return {};
}

template <class Result, class Class>
void add_unfold_figures(Class& type, const UnfoldReport& (*report)(const Result&)) {
  type.def("__repr__",
           [report](const py::object& self) {
             const auto& result = self.cast<const Result&>();
             return described_pattern(self, report(result), form_faults_of(result));
           })
      .def_property_readonly(
          "uv",
          [report](const py::object& self) {
            return view_of(report(self.cast<const Result&>()).pattern.positions, self);
          },
          "The pattern, shape (n, 2), model units; a read-only view.")
      .def_property_readonly(
          "pattern", [](const Result& result) { return arrays_of(geometry_of(result)); },
          "The pattern with what it carries, millimetres, where svg() draws it: lists of closed "
          "lines seam and cut, the outer one first, of open ones notch_lines, grain and "
          "inner_lines; points notches (on the cut line), fold (its ends), marks and vertices.")
      .def_property_readonly(
          "width", [report](const Result& result) { return report(result).pattern.width; },
          "Of the pattern, model units.")
      .def_property_readonly(
          "height", [report](const Result& result) { return report(result).pattern.height; },
          "Of the pattern, model units.")
      .def_property_readonly(
          "unit",
          [report](const Result& result) { return std::string(to_string(report(result).unit)); },
          "What one model unit is: mm, cm, dm, m or in.")
      .def_property_readonly(
          "overlaps", [report](const Result& result) { return report(result).pattern.overlaps; },
          "Whether the border of the pattern crosses itself.")
      .def_property_readonly(
          "strain_max", [report](const Result& result) { return report(result).strain.max; },
          "Largest |strain| of an edge, a share of length.")
      .def_property_readonly(
          "strain_rms", [report](const Result& result) { return report(result).strain.rms; },
          "Root mean square of the strain, a share of length.")
      .def_property_readonly(
          "limits_met", [](const Result& result) { return result.report.outcome().limits_met(); },
          "Whether every limit and target that was asked for is met.")
      .def_property_readonly(
          "usable", [](const Result& result) { return result.report.outcome().usable(); },
          "Whether the pattern can be cut as it is: limits, form and pattern are as they have to "
          "be, and `missed` is empty.")
      .def_property_readonly(
          "missed", [](const Result& result) { return words_of(result.report.outcome()); },
          "What is missed or wrong, by the words of docs/garments.md: strain, form, overlap.");
}

void register_flatten(py::module_& module) {
  using Result = FlattenResult;
  py::class_<Result, std::shared_ptr<Result>> type(module, "FlattenResult",
                                                   "A patch that was flattened, with its pattern.");
  type.def(pickled<Result>())
      .def_property_readonly("name", value_at<&Result::report, &FlattenReport::name>,
                             "Of the patch.")
      .def_readwrite("notes", &Result::notes, "What the program said on the way.")
      .def_property_readonly(
          "vertices", view_at<&Result::report, &FlattenReport::processed, &Patch::positions>,
          "Places of the processed patch, shape (n, 3), model units; a read-only "
          "view.")
      .def_property_readonly("faces",
                             view_at<&Result::report, &FlattenReport::processed, &Patch::triangles>,
                             "Vertices of the triangles, shape (m, 3); a read-only view.")
      .def_property_readonly("input_vertices",
                             view_at<&Result::report, &FlattenReport::input, &Patch::positions>,
                             "Places before, remeshed or smoothed if that was asked for, shape "
                             "(n, 3), model units; a read-only view.")
      .def_property_readonly("uv_as_designed",
                             view_at<&Result::report, &FlattenReport::design_pattern,
                                     &UnfoldReport::pattern, &Pattern::positions>,
                             "The pattern of the design, shape (n, 2), model units; a read-only "
                             "view.")
      .def_property_readonly(
          "source",
          [](const py::object& self) -> std::optional<Indices> {
            const auto& source = self.cast<const Result&>().report.source;
            if (source.empty()) return std::nullopt;
            return view_of(source, self);
          },
          "Of each vertex the one of the mesh before remeshing, shape (n,); None where they are "
          "the "
          "same.")
      .def_property_readonly(
          "form_kept",
          [](const Result& result) { return result.report.evolve.fairness.keeps_form(); },
          "Whether hills, hollows and edges of the design are kept (docs/fairness.md).")
      .def_property_readonly(
          "smooth", [](const Result& result) { return result.report.evolve.fairness.is_smooth(); },
          "Whether the form has no new ripples or folds (docs/fairness.md).")
      .def_property_readonly(
          "deviation", [](const Result& result) { return result.report.evolve.deviation.max; },
          "How far a vertex moved at most, model units.")
      .def_property_readonly(
          "fields", [](const Result& result) { return fields_dict(fields_of(result.report)); },
          "Figures of every vertex and triangle by their names in docs/fields.md.")
      .def_property_readonly(
          "figures",
          [](const Result& result) {
            return figures_of(json_report(result.report, {}, cli::figures_of_cut(result.cut)));
          },
          "All figures, with the keys of the program's report.json.")
      .def(
          "report_html",
          [](const Result& result) {
            const py::gil_scoped_release no_python;
            return page_of(result);
          },
          "The report, report.html of the program: one page that needs no network.")
      .def("save", save_result, py::arg("folder"),
           "Writes all files that the program writes into the folder; role -> path.")
      .def("_drawing", drawing_of_flatten);
  add_unfold_figures<Result>(
      type, [](const Result& result) -> const UnfoldReport& { return result.report.unfold; });
  module.def("flatten", flatten_mesh, py::arg("mesh"), py::arg("keywords"), py::arg("progress"));
}

void register_unfold(py::module_& module) {
  using Result = UnfoldResult;
  py::class_<Result> type(module, "UnfoldResult", "The pattern of a patch as it is.");
  type.def(pickled<Result>())
      .def_readonly("name", &Result::name, "Of the patch.")
      .def_readwrite("notes", &Result::notes, "What the program said on the way.")
      .def_property_readonly("vertices", view_at<&Result::patch, &Patch::positions>,
                             "Places of the patch, shape (n, 3), model units; a read-only view.")
      .def_property_readonly("faces", view_at<&Result::patch, &Patch::triangles>,
                             "Vertices of the triangles, shape (m, 3); a read-only view.")
      .def_property_readonly(
          "fields",
          [](const Result& result) {
            return fields_dict(fields_of(result.patch, result.report.pattern.positions));
          },
          "Figures of every vertex and triangle by their names in docs/fields.md.")
      .def_property_readonly(
          "figures",
          [](const Result& result) {
            return figures_of(
                json_report(result.report, result.cautions, cli::figures_of_cut(result.cut)));
          },
          "All figures, with the keys of the program's --json.")
      .def("_drawing", drawing_of_unfold);
  add_unfold_figures<Result>(
      type, [](const Result& result) -> const UnfoldReport& { return result.report; });
  module.def("unfold", unfold_mesh, py::arg("mesh"), py::arg("keywords"), py::arg("progress"));
}

}  // namespace

std::vector<std::string> words_of(const Outcome& outcome) {
  std::vector<std::string> words;
  for (const Criterion what : outcome.missed)
    words.emplace_back(to_string(what));
  return words;
}

SavedFiles files_in(const FlattenResult& result, const std::filesystem::path& folder) {
  const WrittenFiles paths =
      cli::paths_in(folder, result.format, result.pattern, result.report.evolve.method.has_value(),
                    result.arguments);
  const std::string json = json_report(result.report, paths, cli::figures_of_cut(result.cut));
  const auto drawn = cli::drawn_pattern(result.report, result.pattern.annotations);
  return {cli::files_of(result.report, drawn, paths, result.format, result.pattern,
                        {cli::colors_from(result.arguments), {}}, json),
          paths};
}

std::string page_of(const FlattenResult& result) {
  return cli::page_of(result.report, cli::drawn_pattern(result.report, result.pattern.annotations),
                      {cli::colors_from(result.arguments), {}});
}

void register_patterns(py::module_& module) {
  register_flatten(module);
  register_unfold(module);
}

}  // namespace planish::python
