#pragma once

#include <optional>
#include <string>
#include <vector>

#include <planish/io/mesh_format.h>
#include <planish/io/read_mesh.h>
#include <planish/mesh/tri_mesh.h>

#include <pybind11/pybind11.h>

#include "cut/cut_flag.h"
#include "shell/session.h"

namespace planish::python {

namespace py = pybind11;

/// A mesh that Python holds.
struct MeshData {
  TriMesh mesh;
  std::string name;                     ///< of its file without folder and extension, or "mesh"
  MeshFormat format = MeshFormat::obj;  ///< of its file
  std::vector<std::string> notes = {};  ///< what reading did
  FaceGroups groups = {};               ///< the pieces of its file, where there are several
  std::optional<Unit> unit = {};        ///< that its file states
};

/// What keywords ask of a verb on a mesh, whose unit holds where none of them says it.
cli::Arguments arguments_on(const MeshData& data, const std::string& verb,
                            const py::dict& keywords);

/// What reading the mesh did, where keywords say another unit than it has, and what was said then.
std::vector<std::string> notes_on(const MeshData& data, const cli::Arguments& arguments,
                                  const std::vector<std::string>& said);

/// The mesh in its unit and, where --cut asks for it, cut.
cli::CutInput cut_input(const MeshData& data, const cli::Arguments& arguments,
                        cli::Session& session, const cli::OpeningLimits& limits = {});

/// A dictionary of a JSON text.
py::dict figures_of(const std::string& json);

/// Mesh, and functions that read, write and make meshes.
void register_mesh(py::module_& module);
/// What one patch is made into.
void register_measure(py::module_& module);
void register_evolve(py::module_& module);
void register_patterns(py::module_& module);
void register_panels(py::module_& module);
void register_compare(py::module_& module);
void register_product(py::module_& module);
void register_many(py::module_& module);

}  // namespace planish::python
