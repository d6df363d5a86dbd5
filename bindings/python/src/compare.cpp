#include <memory>
#include <optional>

#include <planish/flatten/compare.h>
#include <planish/report/html_report.h>
#include <planish/report/json_report.h>

#include <pybind11/stl.h>

#include "arrays.h"
#include "flags/constraint_flags.h"
#include "flags/method_flags.h"
#include "flags/scale_flag.h"
#include "flags/units.h"
#include "job.h"
#include "keywords.h"
#include "mesh_data.h"
#include "model/other_methods.h"
#include "own_method.h"
#include "pickle.h"
#include "shell/failures.h"

namespace planish::python {

namespace {

struct CompareResult {
  std::shared_ptr<const CompareReport> report;
};

/// One method of a comparison, which it keeps.
struct ComparedResult {
  std::shared_ptr<const CompareReport> report;
  std::size_t number = 0;

  const ComparedMethod& method() const { return report->runs[number]; }
};

/// What is compared besides methods of the library, by its name: functions and results.
std::vector<CompareRun> own_runs(const py::dict& own, const TriMesh& design,
                                 const cli::Arguments& arguments, Job& job) {
  std::vector<CompareRun> runs;
  for (const auto& [key, value] : own) {
    const auto name = key.cast<std::string>();
    cli::check_other_name(name);
    OwnMethod method;
    if (py::isinstance<MeshData>(value)) {
      if (arguments.has("--fix"))
        throw cli::UsageError("fix does not go with a result from outside, as " + name);
      const TriMesh result =
          cli::scaled(value.cast<const MeshData&>().mesh, cli::scale_from(arguments), {});
      method = result_as_method(name, cli::positions_over(design, result));
      runs.push_back({method, usual_stopping(method)});
    } else {
      method = method_of(py::reinterpret_borrow<py::object>(value), job);
      method.name = name;
      runs.push_back({method, cli::stopping_from(arguments, method)});
    }
  }
  return runs;
}

/// @param own None, or by name functions and meshes that are compared too
CompareResult compare_methods(const MeshData& data, const py::object& own, const py::dict& keywords,
                              py::object progress) {
  const cli::Arguments arguments = arguments_on(data, "compare", keywords);
  TriMesh design = cli::scaled(data.mesh, cli::scale_from(arguments), {});
  CompareOptions options = {.unit = cli::unit_from(arguments)};
  Job job(arguments, std::move(progress));
  std::vector<CompareRun> runs;
  if (own.is_none() || !cli::asks_for_no_method(arguments)) runs = cli::runs_from(arguments);
  if (!own.is_none()) {
    for (CompareRun& run : own_runs(own.cast<py::dict>(), design, arguments, job))
      runs.push_back(std::move(run));
  }
  return job.run([&](cli::Session& session) {
    const Patch patch(std::move(design));
    options.constraints = cli::constraints_from(arguments, patch, session);
    return CompareResult{std::make_shared<const CompareReport>(
        compare(patch, data.name, runs, options, session.job_context({})))};
  });
}

py::list runs_of(const CompareResult& result) {
  py::list runs;
  for (std::size_t number = 0; number < result.report->runs.size(); ++number)
    runs.append(ComparedResult{result.report, number});
  return runs;
}

void register_compared(py::module_& module) {
  py::class_<ComparedResult>(module, "ComparedMethod", "What one method made of the patch.")
      .def(pickled<ComparedResult>())
      .def_property_readonly(
          "method",
          [](const ComparedResult& run) { return std::string(name_of(run.method().run.method)); },
          "Its name.")
      .def_property_readonly(
          "failure",
          [](const ComparedResult& run) -> std::optional<std::string> {
            if (!run.method().failure) return std::nullopt;
            return run.method().failure->message;
          },
          "Why it has no result or no pattern; None where it has.")
      .def_property_readonly(
          "verdict",
          [](const ComparedResult& run) { return verdict_text(*run.report, run.method()); },
          "What it did for the pattern and at what price, in a few words.")
      .def_property_readonly(
          "vertices",
          [](const py::object& self) -> std::optional<Numbers> {
            const auto& evolve = self.cast<const ComparedResult&>().method().evolve;
            if (!evolve) return std::nullopt;
            return view_of(evolve->result.positions, self);
          },
          "Places after the last sweep, shape (n, 3), model units; None where it failed.")
      .def_property_readonly(
          "faces",
          [](const py::object& self) {
            return view_of(self.cast<const ComparedResult&>().report->input.triangles(), self);
          },
          "Vertices of the triangles, shape (m, 3); a read-only view.")
      .def_property_readonly(
          "uv",
          [](const py::object& self) -> std::optional<Numbers> {
            const auto& unfold = self.cast<const ComparedResult&>().method().unfold;
            if (!unfold) return std::nullopt;
            return view_of(unfold->pattern.positions, self);
          },
          "The pattern, shape (n, 2), model units; None where there is none.")
      .def_property_readonly(
          "strain_rms",
          [](const ComparedResult& run) -> std::optional<double> {
            if (!run.method().unfold) return std::nullopt;
            return run.method().unfold->strain.rms;
          },
          "Root mean square of the pattern's strain, a share of length; None without a pattern.")
      .def_property_readonly(
          "e_max",
          [](const ComparedResult& run) -> std::optional<double> {
            if (!run.method().evolve) return std::nullopt;
            return run.method().evolve->after.figures.e_max;
          },
          "Largest |angle defect| at the end, radians; None where it failed.");
}

}  // namespace

void register_compare(py::module_& module) {
  register_compared(module);
  py::class_<CompareResult>(module, "CompareResult", "Several methods on one patch.")
      .def(pickled<CompareResult>())
      .def_property_readonly(
          "name", [](const CompareResult& result) { return result.report->name; }, "Of the patch.")
      .def_property_readonly("runs", runs_of, "A ComparedMethod for each, in the order asked for.")
      .def_property_readonly(
          "best",
          [](const CompareResult& result) -> std::optional<ComparedResult> {
            const auto best = best_run(*result.report);
            if (!best) return std::nullopt;
            return ComparedResult{result.report, *best};
          },
          "The one to trust; None where none improved on the patch without harm.")
      .def(
          "report_html",
          [](const CompareResult& result) {
            const py::gil_scoped_release no_python;
            return html_report(*result.report);
          },
          "The comparison as one page that needs no network.")
      .def(
          "history_csv", [](const CompareResult& result) { return history_csv(*result.report); },
          "Every sweep of every method, as comma-separated values.")
      .def_property_readonly(
          "figures",
          [](const CompareResult& result) { return figures_of(json_report(*result.report)); },
          "All figures, with the keys of the program's --json.");
  module.def("compare", compare_methods, py::arg("mesh"), py::arg("own"), py::arg("keywords"),
             py::arg("progress"));
}

}  // namespace planish::python
