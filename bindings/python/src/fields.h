#pragma once

#include <planish/io/mesh_format.h>

#include <pybind11/pybind11.h>

#include "arrays.h"

namespace planish::python {

/// Name -> array, of vertices and of triangles.
inline py::dict fields_dict(MeshFields fields) {
  py::dict named;
  for (auto* some : {&fields.vertices, &fields.triangles}) {
    for (MeshField& field : *some)
      named[py::str(field.name)] = array_of(std::move(field.values));
  }
  return named;
}

}  // namespace planish::python
