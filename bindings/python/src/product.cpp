#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <optional>

#include <planish/draw/format_drawing.h>
#include <planish/flatten/product.h>
#include <planish/io/write_file.h>
#include <planish/report/html_report.h>
#include <planish/report/json_report.h>
#include <planish/sheet/product_sheet.h>

#include <pybind11/stl.h>

#include "batch/stated_units.h"
#include "commands/jobs.h"
#include "flags/scale_flag.h"
#include "flags/units.h"
#include "job.h"
#include "keywords.h"
#include "model/model_flags.h"
#include "output/machine.h"
#include "pattern_data.h"
#include "pickle.h"
#include "piece/piece_settings.h"
#include "platform/path.h"
#include "product/job.h"
#include "product/parts.h"
#include "product/rename.h"
#include "product/seams.h"
#include "product/text.h"
#include "shell/failures.h"
#include "shell/output_folder.h"
#include "shell/safe_names.h"

namespace planish::python {

namespace {

struct ProductResult {
  std::string name;
  ProductReport report;
  std::vector<std::shared_ptr<FlattenResult>> results;  ///< of the patches; null of a failed one
  std::vector<std::string> notes = {};
};

/// Of a twin, what is drawn follows the other one.
cli::PatternFiles files_of(const cli::PatternFiles& pattern, const PatternOptions& own,
                           const ProductPatch* other, const PatchTwin* twin) {
  cli::PatternFiles files = pattern;
  files.annotations = twin == nullptr ? own : annotations_of_twin(own, other->mesh, *twin);
  return files;
}

/// @param asked what keywords ask
/// @param with_unit gives the same with the unit that files or meshes have; called with the session
/// @param patches_of gives what is to be flattened; called with the session and the keywords
ProductResult flatten_patches(
    const std::string& name, const cli::Arguments& asked, py::object progress,
    const std::function<cli::Arguments(cli::Session&)>& with_unit,
    const std::function<cli::ProductInput(cli::Session&, const cli::Arguments&)>& patches_of) {
  Job job(asked, std::move(progress));
  ProductResult result = job.run([&](cli::Session& session) {
    const cli::Arguments arguments = cli::without_pieces_out(cli::with_machine(with_unit(session)));
    const FlattenOptions options = cli::flatten_options_from(arguments);
    const ProductOptions product = cli::product_options_from(arguments, options, false);
    cli::colors_from(arguments);
    const cli::PatternFiles pattern = cli::pattern_files_from(arguments);
    cli::ProductInput input = patches_of(session, arguments);
    const auto requests = cli::named_requests(input, pattern.annotations, arguments, session);
    std::vector<ProductPatch>& patches = input.patches;
    const auto annotations = cli::annotations_of_patches(requests, patches, arguments);
    for (std::size_t p = 0; p < patches.size(); ++p)
      patches[p].keep = named_vertices(annotations[p]);
    ProductResult made{name, {}, {}};
    made.results.resize(patches.size());
    const auto keep = [&](std::size_t p, const FlattenReport& report, const PatchTwin* twin) {
      const ProductPatch* other = twin == nullptr ? nullptr : &patches[twin->patch];
      made.results[p] = std::make_shared<FlattenResult>(
          FlattenResult{report, files_of(pattern, annotations[p], other, twin), arguments});
    };
    made.report = flatten_product(patches, product, {.on_report = keep}, session.job_context({}));
    made.report.seams =
        cli::with_names(std::move(made.report.seams), made.report.patches, input.seams, session);
    cli::note_cautions_and_sizes(session, made.report, asked.has("--unit"));
    return made;
  });
  result.notes = job.notes();
  return result;
}

ProductResult flatten_files(const std::string& name, const std::vector<std::string>& paths,
                            const py::dict& keywords, py::object progress) {
  cli::Arguments asked = arguments_of("flatten", keywords);
  asked.operands = paths;
  return flatten_patches(
      name, asked, std::move(progress),
      [&](cli::Session& session) {
        return cli::with_stated_unit(command_named("flatten"), asked, session);
      },
      [&](cli::Session& session, const cli::Arguments& arguments) {
        return cli::read_product(session, paths, arguments, true);
      });
}

/// The unit that all meshes have.
std::optional<Unit> common_unit(
    const std::vector<std::pair<std::string, const MeshData*>>& meshes) {
  const std::optional<Unit> unit = meshes.front().second->unit;
  const bool agree = std::all_of(meshes.begin(), meshes.end(),
                                 [&](const auto& mesh) { return mesh.second->unit == unit; });
  return agree ? unit : std::nullopt;
}

ProductResult flatten_meshes(const std::string& name,
                             const std::vector<std::pair<std::string, const MeshData*>>& meshes,
                             const py::dict& keywords, py::object progress) {
  cli::Arguments asked = arguments_of("flatten", keywords);
  asked.stated_unit = common_unit(meshes);
  ProductResult result = flatten_patches(
      name, asked, std::move(progress), [&](cli::Session&) { return asked; },
      [&](cli::Session&, const cli::Arguments& arguments) {
        for (const cli::Flag& flag : cli::model_flags().flags) {
          if (!arguments.has(flag.name)) continue;
          throw cli::UsageError(flag.name + " is of files; planish.read() has it for a mesh");
        }
        const cli::RunUnit unit = cli::run_unit_from(arguments);
        cli::ProductInput input;
        for (const auto& [patch, data] : meshes) {
          const Unit own = unit.is_asked ? unit.unit : data->unit.value_or(unit.unit);
          const double scale =
              cli::scale_from(arguments) * millimetres_per(own) / millimetres_per(unit.unit);
          input.patches.push_back({.name = patch, .mesh = cli::scaled(data->mesh, scale, patch)});
        }
        input.places.resize(input.patches.size());
        return input;
      });
  std::vector<std::string> notes;
  for (const auto& [patch, data] : meshes) {
    for (const std::string& note : data->notes)
      notes.push_back(patch + ": " + note);
  }
  result.notes.insert(result.notes.begin(), notes.begin(), notes.end());
  return result;
}

std::string json_of(const ProductResult& result) {
  ProductFiles none;
  none.folders.resize(result.report.patches.size());
  none.files.resize(result.report.patches.size());
  return json_report(result.report, result.name, none);
}

/// Writes the files of each patch into a folder of its own, and those of the whole beside these.
/// @return of the whole: role -> path
WrittenFiles save_product(const ProductResult& result, const py::object& path) {
  const auto place = py::module_::import("os").attr("fspath")(path).cast<std::string>();
  const py::gil_scoped_release no_python;
  const std::filesystem::path folder = cli::output_folder(place);
  std::vector<std::string> names;
  for (const PatchResult& patch : result.report.patches)
    names.push_back(patch.name);
  ProductFiles written = {cli::safe_names(names), {}};
  ProductPage page{.name = result.name};
  std::vector<OutputFile> files;
  for (std::size_t p = 0; p < names.size(); ++p) {
    const std::string& own = written.folders[p];
    page.reports.push_back(own + "/report.html");
    written.files.emplace_back();
    if (result.results[p] == nullptr) continue;
    SavedFiles saved = files_in(*result.results[p], folder / path_of(own));
    std::move(saved.files.begin(), saved.files.end(), std::back_inserter(files));
    written.files.back() = std::move(saved.paths);
  }
  const auto add = [&](const char* name, std::string content) {
    files.push_back({folder / path_of(name), std::move(content)});
    return utf8_of(files.back().path);
  };
  const WrittenFiles paths = {
      {"garment_json", add("garment.json", json_report(result.report, result.name, written))},
      {"garment_html", add("garment.html", html_report(result.report, page))},
      {"garment_svg", add("garment.svg", format_svg(product_sheet(result.report, result.name)))}};
  write_files(files, folder);
  return paths;
}

/// What each piece misses; nothing of those that miss nothing.
std::map<std::string, std::vector<std::string>> missed_by_pieces(const ProductReport& report) {
  std::map<std::string, std::vector<std::string>> missed;
  for (const PatchResult& patch : report.patches) {
    std::vector<std::string> of_piece = words_of(patch.outcome());
    if (!of_piece.empty()) missed[patch.name] = std::move(of_piece);
  }
  return missed;
}

}  // namespace

void register_product(py::module_& module) {
  py::class_<ProductResult>(module, "ProductResult", "The patches of a product, flattened.")
      .def(pickled<ProductResult>())
      .def_readonly("name", &ProductResult::name, "Of the product.")
      .def_readwrite("notes", &ProductResult::notes, "What the program said on the way.")
      .def_property_readonly(
          "names",
          [](const ProductResult& result) {
            std::vector<std::string> names;
            for (const PatchResult& patch : result.report.patches)
              names.push_back(patch.name);
            return names;
          },
          "Of the patches, in their order.")
      .def_property_readonly(
          "patches", [](const ProductResult& result) { return result.results; },
          "A FlattenResult of each, None of one that failed.")
      .def_property_readonly(
          "failures",
          [](const ProductResult& result) {
            std::map<std::string, std::string> failures;
            for (const PatchResult& patch : result.report.patches) {
              if (patch.failure) failures[patch.name] = patch.failure->message;
            }
            return failures;
          },
          "Of each patch that failed, by its name, why.")
      .def_property_readonly(
          "missed", [](const ProductResult& result) { return missed_by_pieces(result.report); },
          "What each piece misses, by its name: the words of FlattenResult.missed, or failure. "
          "Empty where every piece can be cut as it was asked for.")
      .def("save", save_product, py::arg("folder"),
           "Writes the files of each patch into a folder of its own name, and garment.json, .html "
           "and .svg beside these; role -> path of the latter.")
      .def(
          "report_html",
          [](const ProductResult& result) {
            const py::gil_scoped_release no_python;
            return html_report(result.report, ProductPage{.name = result.name});
          },
          "All pieces and their seams as one page that needs no network.")
      .def(
          "layout_svg",
          [](const ProductResult& result) {
            return format_svg(product_sheet(result.report, result.name));
          },
          "All pieces side by side at true size, seams in colours: garment.svg of the program.")
      .def_property_readonly(
          "figures", [](const ProductResult& result) { return figures_of(json_of(result)); },
          "All figures, with the keys of the program's garment.json.");
  module.def("flatten_files", flatten_files, py::arg("name"), py::arg("paths"), py::arg("keywords"),
             py::arg("progress"));
  module.def("flatten_meshes", flatten_meshes, py::arg("name"), py::arg("meshes"),
             py::arg("keywords"), py::arg("progress"));
}

}  // namespace planish::python
