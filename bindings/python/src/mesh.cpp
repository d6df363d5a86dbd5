#include <sstream>

#include <planish/io/write_file.h>
#include <planish/mesh/inspect.h>
#include <planish/mesh/shapes.h>

#include <pybind11/stl.h>

#include "arrays.h"
#include "flags/scale_flag.h"
#include "flags/units.h"
#include "job.h"
#include "keywords.h"
#include "mesh_data.h"
#include "model/model_flags.h"
#include "model/model_text.h"
#include "model/orient.h"
#include "pickle.h"
#include "platform/path.h"
#include "shell/failures.h"
#include "shell/file_name.h"
#include "shell/values.h"

namespace planish::python {

namespace {

std::string other_unit_text(Unit unit) {
  return ", but unit= says " + std::string(to_string(unit)) + ", which is taken";
}

/// @param keywords as flags of convert, which prepares the mesh of a file and nothing else
MeshData mesh_from_file(const std::string& path, const py::dict& keywords) {
  cli::Arguments arguments = arguments_of("convert", keywords);
  const py::gil_scoped_release no_python;
  ReadResult file = read_mesh(path_of(path), {.strict = arguments.has("--strict")});
  const auto stated = file.unit ? std::optional(file.unit->unit) : std::nullopt;
  const auto unit = arguments.has("--unit") ? cli::unit_from(arguments) : stated;
  if (file.unit) {
    file.notes.push_back("the file says \"" + file.unit->words + "\"" +
                         (unit == stated ? "" : other_unit_text(*unit)));
  }
  // Lengths of keywords are in the unit of the file.
  arguments.stated_unit = unit;
  const ModelOptions options =
      cli::model_options_from(arguments, cli::names_in(file, cli::stem_of(path)));
  Model model =
      cli::about(path, [&] { return prepare_model(std::move(file), options, cli::stem_of(path)); });
  cli::check_model(model, arguments, path);
  std::vector<std::string> turning = cli::turn_inside_out(model, options);
  MeshData data{std::move(model.mesh), cli::stem_of(path), model.format, std::move(model.notes)};
  data.unit = unit;
  if (model.pieces.size() == 1) data.name = model.pieces.front();
  if (model.pieces.size() > 1)
    data.groups = {model.divided_by, std::move(model.pieces), std::move(model.piece_of)};
  for (std::string& note :
       cli::work_notes(model.work, cli::ShownLengths(cli::unit_from(arguments))))
    data.notes.push_back(std::move(note));
  data.notes.insert(data.notes.end(), turning.begin(), turning.end());
  return data;
}

void mesh_to_file(const std::string& path, const MeshData& data) {
  const py::gil_scoped_release no_python;
  write_mesh(path_of(path), data.mesh);
}

void bytes_to_file(const std::string& path, const py::bytes& content) {
  const std::vector<OutputFile> files = {{path_of(path), std::string(content)}};
  const py::gil_scoped_release no_python;
  write_files(files);
}

MeshData made_sample(const std::string& name, const py::dict& keywords) {
  const cli::Arguments arguments = arguments_of("sample", keywords);
  std::vector<std::string> names;
  for (const Shape& shape : shapes())
    names.emplace_back(shape.name);
  const std::string known = cli::known_name("sample", name, names);
  const int vertices =
      cli::whole_number_of("--vertices", arguments.value("--vertices", 5000), {100, 10'000'000});
  return {make_shape(known, static_cast<std::size_t>(vertices)), known};
}

std::string described_mesh(const MeshData& data) {
  return "<planish.Mesh " + data.name + ": " + std::to_string(data.mesh.positions.size()) +
         " vertices, " + std::to_string(data.mesh.triangles.size()) + " triangles>";
}

py::list problems_of(const MeshData& data) {
  py::list problems;
  for (const Problem& problem : inspect(data.mesh).problems) {
    py::dict entry;
    entry["code"] = std::string(to_string(problem.code));
    entry["message"] = problem.message;
    entry["count"] = problem.count;
    entry["first"] = problem.first;
    problems.append(entry);
  }
  return problems;
}

}  // namespace

cli::Arguments arguments_on(const MeshData& data, const std::string& verb,
                            const py::dict& keywords) {
  cli::Arguments arguments = arguments_of(verb, keywords);
  arguments.stated_unit = data.unit;
  return arguments;
}

std::vector<std::string> notes_on(const MeshData& data, const cli::Arguments& arguments,
                                  const std::vector<std::string>& said) {
  std::vector<std::string> notes = data.notes;
  const Unit unit = cli::unit_from(arguments);
  if (data.unit && *data.unit != unit)
    notes.push_back("the mesh is in " + std::string(to_string(*data.unit)) + other_unit_text(unit));
  notes.insert(notes.end(), said.begin(), said.end());
  return notes;
}

cli::CutInput cut_input(const MeshData& data, const cli::Arguments& arguments,
                        cli::Session& session, const cli::OpeningLimits& limits) {
  return cli::cut_as_asked(cli::scaled(data.mesh, cli::scale_from(arguments), {}), data.name,
                           arguments, session, limits);
}

py::dict figures_of(const std::string& json) {
  return py::module_::import("json").attr("loads")(json);
}

void register_mesh(py::module_& module) {
  py::class_<MeshData>(module, "Mesh", "A triangle mesh: places of vertices, and triangles.")
      .def(pickled<MeshData>())
      .def(py::init([](const py::object& vertices, const py::object& faces, std::string name) {
             return MeshData{mesh_of(vertices, faces), std::move(name)};
           }),
           py::arg("vertices"), py::arg("faces"), py::arg("name") = "mesh",
           "A copy of arrays: (n, 3) numbers, and (m, 3) whole numbers of vertices from 0.")
      .def_readonly("name", &MeshData::name, "What drawings and reports call it.")
      .def_readonly("notes", &MeshData::notes, "What the reader of its file did.")
      .def_property_readonly(
          "unit",
          [](const MeshData& data) -> std::optional<std::string> {
            if (!data.unit) return std::nullopt;
            return std::string(to_string(*data.unit));
          },
          "What one unit is, as unit= said or else its file; the default of unit= of what is made "
          "of it. None where nothing says it.")
      .def_property_readonly("vertices", view_at<&MeshData::mesh, &TriMesh::positions>,
                             "Places, shape (n, 3), model units; a read-only view.")
      .def_property_readonly("faces", view_at<&MeshData::mesh, &TriMesh::triangles>,
                             "Vertices of the triangles, shape (m, 3), from 0; a read-only view.")
      .def_property_readonly(
          "group_names", [](const MeshData& data) { return data.groups.names; },
          "The names of the pieces of its file; empty where there are fewer than two.")
      .def_property_readonly(
          "face_groups",
          [](const py::object& self) {
            return view_of(self.cast<const MeshData&>().groups.of_triangle, self);
          },
          "Of each triangle the number of its piece; empty where there are none.")
      .def_property_readonly("problems", problems_of,
                             "Every fault and oddity by kind: code, message, count, first.")
      .def(
          "renamed",
          [](const MeshData& data, std::string name) {
            MeshData renamed = data;
            renamed.name = std::move(name);
            return renamed;
          },
          py::arg("name"), "The same mesh under another name.")
      .def("__repr__", described_mesh);
  module.def("read", mesh_from_file, py::arg("path"), py::arg("keywords"));
  module.def("write", mesh_to_file, py::arg("path"), py::arg("mesh"));
  module.def("write_bytes", bytes_to_file, py::arg("path"), py::arg("content"));
  module.def("sample", made_sample, py::arg("name"), py::arg("keywords"));
}

}  // namespace planish::python
