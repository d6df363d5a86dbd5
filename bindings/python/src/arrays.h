#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include <planish/mesh/tri_mesh.h>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

namespace planish::python {

namespace py = pybind11;

using Numbers = py::array_t<double>;
using Indices = py::array_t<Index>;

/// A read-only view of points, shape (n, 3).
/// @param owner a Python object that holds the points; it lives as long as the view
Numbers view_of(const std::vector<Vec3>& points, const py::object& owner);
/// The same of points in the plane, shape (n, 2).
Numbers view_of(const std::vector<Vec2>& points, const py::object& owner);
/// The same of numbers, shape (n,).
Numbers view_of(const std::vector<double>& values, const py::object& owner);
/// The same of triangles, shape (m, 3).
Indices view_of(const std::vector<Triangle>& triangles, const py::object& owner);
/// The same of indices, shape (n,).
Indices view_of(const std::vector<Index>& indices, const py::object& owner);

/// What the first of some members is of.
template <class Struct, class Member>
Struct struct_of(Member Struct::*);

/// What members lead to, one from the other.
template <auto First, auto... Rest, class Struct>
decltype(auto) along(const Struct& from) {
  if constexpr (sizeof...(Rest) == 0)
    return std::invoke(First, from);
  else
    return along<Rest...>(std::invoke(First, from));
}

/// For a property of Python: a view of the list that members lead to, as view_of() has it.
template <auto First, auto... Rest>
auto view_at(const py::object& self) {
  using Struct = decltype(struct_of(First));
  return view_of(along<First, Rest...>(self.cast<const Struct&>()), self);
}

/// For a property of Python: the value that members lead to.
template <auto First, auto... Rest>
auto value_at(const decltype(struct_of(First))& from) {
  return along<First, Rest...>(from);
}

/// A read-only array that takes over the points, shape (n, 3).
Numbers array_of(std::vector<Vec3> points);
/// The same of points in the plane, shape (n, 2).
Numbers array_of(std::vector<Vec2> points);
/// The same of numbers, shape (n,).
Numbers array_of(std::vector<double> values);

/// Positions of an array of any numeric type, (n, 3), finite or not.
/// @throws py::type_error, py::value_error for arrays of another type or shape
std::vector<Vec3> positions_of(const py::object& object);

/// A mesh of arrays in any order and of any numeric type: (n, 3) finite or not, and (m, 3) whole
/// numbers from 0 to n - 1.
/// @throws py::type_error, py::value_error for arrays of another type or shape; Error
///   index_out_of_range, no_triangles, too_large
TriMesh mesh_of(const py::object& vertices, const py::object& faces);

}  // namespace planish::python
