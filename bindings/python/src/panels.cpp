#include "cut/panels.h"

#include <memory>
#include <optional>

#include <planish/panels/suggest_panels.h>

#include <pybind11/stl.h>

#include "arrays.h"
#include "cut/panel_places.h"
#include "cut/panels_text.h"
#include "flags/scale_flag.h"
#include "flags/units.h"
#include "job.h"
#include "keywords.h"
#include "mesh_data.h"
#include "pickle.h"

namespace planish::python {

namespace {

struct PanelsResult {
  std::string name;
  PanelSuggestion found;
  TriMesh cut;
  std::optional<cli::CutOutcome> outcome = {};
  Unit unit = Unit::mm;
  std::vector<std::vector<Vec3>> fixed = {};  ///< places along the seams that were given
  std::vector<std::string> notes = {};
};

PanelsResult suggested_panels(const MeshData& data, const py::dict& keywords, py::object progress) {
  const cli::Arguments arguments = arguments_on(data, "panels", keywords);
  cli::panel_options_from(arguments);
  const Unit unit = cli::unit_from(arguments);
  const double scale = cli::scale_from(arguments);
  Job job(arguments, std::move(progress));
  PanelsResult result = job.run([&](cli::Session& session) {
    cli::CutInput fixed =
        cli::cut_at_fixed_seams(cli::scaled(data.mesh, scale, {}), data.name, arguments, session);
    const Patch patch(std::move(fixed.mesh));
    PanelSuggestion found = cli::panels_as_asked(patch, data.name, arguments, session,
                                                 {.match_seams = arguments.has("--match-seams")});
    cli::CutInput cut = cli::cut_into_panels(found);
    return PanelsResult{data.name, std::move(found),      std::move(cut.mesh), cut.cut,
                        unit,      std::move(fixed.lines)};
  });
  result.notes = notes_on(data, arguments, job.notes());
  return result;
}

std::vector<MeshData> pieces_of(const PanelsResult& result) {
  std::vector<MeshData> pieces;
  for (NamedPatch& piece : cli::pieces_by_place(result.cut, result.name)) {
    MeshData& data = pieces.emplace_back(MeshData{std::move(piece.mesh), std::move(piece.name)});
    data.unit = result.unit;
  }
  return pieces;
}

Indices panel_of_triangles(const PanelsResult& result) {
  std::vector<Index> panel_of(result.found.mesh.triangles.size(), 0);
  for (std::size_t k = 0; k < result.found.panels.size(); ++k) {
    for (const Index t : result.found.panels[k].triangles)
      panel_of[t] = static_cast<Index>(k);
  }
  return Indices(static_cast<py::ssize_t>(panel_of.size()), panel_of.data());
}

}  // namespace

void register_panels(py::module_& module) {
  py::class_<PanelsResult>(module, "PanelsResult", "A product divided into panels.")
      .def(pickled<PanelsResult>())
      .def_readonly("notes", &PanelsResult::notes, "What the program said on the way.")
      .def_property_readonly(
          "met", [](const PanelsResult& result) { return result.found.met; },
          "Whether every panel keeps the limit of strain and has a pattern that lies nowhere over "
          "itself.")
      .def_property_readonly(
          "vertices", view_at<&PanelsResult::found, &PanelSuggestion::mesh, &TriMesh::positions>,
          "Places of the product, of which seams are edges, shape (n, 3), model "
          "units; a read-only view.")
      .def_property_readonly(
          "faces", view_at<&PanelsResult::found, &PanelSuggestion::mesh, &TriMesh::triangles>,
          "Vertices of the triangles, shape (m, 3); a read-only view.")
      .def_property_readonly(
          "panel_of", panel_of_triangles,
          "Of each of its triangles the number of its panel, from 0, shape (m,).")
      .def_property_readonly(
          "seams",
          [](const py::object& self) {
            py::list seams;
            for (const std::vector<Index>& seam : self.cast<const PanelsResult&>().found.seams)
              seams.append(view_of(seam, self));
            return seams;
          },
          "Its vertices along each seam, as `cut` of other functions takes them.")
      .def_property_readonly("pieces", pieces_of,
                             "The panels cut out, each a Mesh, in their order: what "
                             "flatten_product() takes.")
      .def(
          "lines_text",
          [](const PanelsResult& result) {
            return cli::panel_lines(result.found, result.fixed, {});
          },
          "The .obj file that --cut of the program takes.")
      .def_property_readonly(
          "figures",
          [](const PanelsResult& result) {
            return figures_of(
                cli::panels_json(result.found, {result.cut, result.outcome}, result.unit, {}));
          },
          "All figures, with the keys of the program's --json.");
  module.def("suggest_panels", suggested_panels, py::arg("mesh"), py::arg("keywords"),
             py::arg("progress"));
}

}  // namespace planish::python
