#include <memory>
#include <optional>

#include <planish/measure/flattenability.h>
#include <planish/report/json_report.h>

#include <pybind11/stl.h>

#include "arrays.h"
#include "commands/jobs.h"
#include "fields.h"
#include "flags/limit_flags.h"
#include "flags/scale_flag.h"
#include "flags/units.h"
#include "job.h"
#include "keywords.h"
#include "mesh_data.h"
#include "pickle.h"
#include "text/suggestion_text.h"

namespace planish::python {

namespace {

struct MeasureResult {
  Patch patch;
  MeasuredPatch measured;
  std::optional<StrainAsDesigned> strain;
  std::vector<double> defects;
  Unit unit = Unit::mm;
};

MeasureResult measure_mesh(const MeshData& data, const py::dict& keywords, py::object progress) {
  const cli::Arguments arguments = arguments_on(data, "measure", keywords);
  const StrainLimits limits = cli::limits_from(arguments);
  const double scale = cli::scale_from(arguments);
  const Unit unit = cli::unit_from(arguments);
  return Job(arguments, std::move(progress)).run([&](cli::Session& session) {
    Patch patch(cli::scaled(data.mesh, scale, {}));
    MeasuredPatch measured = measure_patch(patch, session.job_context({}));
    auto strain = cli::strain_as_asked(patch, limits, session);
    std::vector<double> defects = angle_defects(patch);
    return MeasureResult{std::move(patch), std::move(measured), std::move(strain),
                         std::move(defects), unit};
  });
}

struct CutResult {
  CutSuggestion suggestion;
  SuggestOptions options;
  Unit unit = Unit::mm;
};

CutResult suggested_cuts(const MeshData& data, const py::dict& keywords, py::object progress) {
  const cli::Arguments arguments = arguments_on(data, "suggest-cuts", keywords);
  const SuggestOptions options = cli::suggest_options_from(arguments);
  const Unit unit = cli::unit_from(arguments);
  const double scale = cli::scale_from(arguments);
  return Job(arguments, std::move(progress)).run([&](cli::Session& session) {
    const Patch patch(cli::scaled(data.mesh, scale, {}));
    return CutResult{suggest_cuts(patch, options, session.job_context({})), options, unit};
  });
}

void register_suggestion(py::module_& module) {
  py::class_<CutResult>(module, "CutResult", "Cuts that let a mesh lie flat, and its pattern.")
      .def(pickled<CutResult>())
      .def_property_readonly(
          "cuts",
          [](const py::object& self) {
            py::list paths;
            for (const SuggestedCut& cut : self.cast<const CutResult&>().suggestion.cuts)
              paths.append(view_of(cut.path, self));
            return paths;
          },
          "The vertices of each cut, as `cut` of other functions takes them.")
      .def_property_readonly(
          "met", [](const CutResult& result) { return result.suggestion.met(); },
          "Whether the pattern with all cuts keeps the limit of strain.")
      .def_property_readonly(
          "vertices",
          [](const py::object& self) {
            return view_of(self.cast<const CutResult&>().suggestion.last.cut.mesh.positions, self);
          },
          "Places of the mesh cut open, shape (n, 3), model units; a read-only view.")
      .def_property_readonly(
          "faces",
          [](const py::object& self) {
            return view_of(self.cast<const CutResult&>().suggestion.last.cut.mesh.triangles, self);
          },
          "Its triangles, shape (m, 3); a read-only view.")
      .def_property_readonly(
          "uv",
          [](const py::object& self) {
            return view_of(self.cast<const CutResult&>().suggestion.last.pattern.positions, self);
          },
          "Its pattern, shape (n, 2), model units; a read-only view.")
      .def_property_readonly(
          "source",
          [](const py::object& self) {
            return view_of(self.cast<const CutResult&>().suggestion.last.cut.source, self);
          },
          "Of each of its vertices the one of the mesh before, shape (n,).")
      .def(
          "cuts_text",
          [](const CutResult& result) {
            return cli::suggestion_file(result.suggestion, result.unit);
          },
          "The file that --cut of the program takes.")
      .def_property_readonly(
          "figures",
          [](const CutResult& result) {
            return figures_of(
                cli::suggestion_json(result.suggestion, result.options, result.unit, {}));
          },
          "All figures, with the keys of the program's --json.");
  module.def("suggest_cuts", suggested_cuts, py::arg("mesh"), py::arg("keywords"),
             py::arg("progress"));
}

}  // namespace

void register_measure(py::module_& module) {
  py::class_<MeasureResult>(module, "MeasureResult", "How far a patch is from flat.")
      .def(pickled<MeasureResult>())
      .def_property_readonly("vertices", view_at<&MeasureResult::patch, &Patch::positions>,
                             "Places, shape (n, 3), model units; a read-only view.")
      .def_property_readonly("faces", view_at<&MeasureResult::patch, &Patch::triangles>,
                             "Vertices of the triangles, shape (m, 3); a read-only view.")
      .def_property_readonly(
          "defects", view_at<&MeasureResult::defects>,
          "Angle defects, shape (n,), radians; 0 where a vertex is not inside. A read-only view.")
      .def_property_readonly(
          "uv",
          [](const py::object& self) -> std::optional<Numbers> {
            const auto& strain = self.cast<const MeasureResult&>().strain;
            if (!strain) return std::nullopt;
            return view_of(strain->pattern.positions, self);
          },
          "The pattern of least stretch, shape (n, 2); None of what cannot be laid flat.")
      .def_property_readonly(
          "flattenable", [](const MeasureResult& result) { return result.measured.flattenable; },
          "Whether the patch lies flat without stretch worth cutting for.")
      .def_property_readonly(
          "fields",
          [](const MeasureResult& result) {
            const auto& strain = result.strain;
            return fields_dict(strain ? fields_of(result.patch, strain->pattern.positions)
                                      : fields_of(result.patch));
          },
          "Figures of every vertex and triangle by their names in docs/fields.md.")
      .def_property_readonly(
          "figures",
          [](const MeasureResult& result) {
            return figures_of(json_report(result.measured, result.strain,
                                          find_cautions(result.patch), result.unit));
          },
          "All figures, with the keys of the program's --json.");
  module.def("measure", measure_mesh, py::arg("mesh"), py::arg("keywords"), py::arg("progress"));
  register_suggestion(module);
}

}  // namespace planish::python
