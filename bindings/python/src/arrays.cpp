#include "arrays.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <utility>

#include <planish/core/error.h>

namespace planish::python {

namespace {

static_assert(sizeof(Vec3) == 3 * sizeof(double) && sizeof(Vec2) == 2 * sizeof(double) &&
              sizeof(Triangle) == 3 * sizeof(Index));

template <class Number>
py::array_t<Number> view(const Number* data, std::vector<py::ssize_t> shape,
                         const py::object& owner) {
  py::array_t<Number> array(std::move(shape), data, owner);
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

py::ssize_t size_of(std::size_t size) {
  return static_cast<py::ssize_t>(size);
}

/// A Python object that holds a vector and frees it.
template <class Item>
std::pair<const std::vector<Item>*, py::capsule> kept(std::vector<Item> items) {
  auto owned = std::make_unique<std::vector<Item>>(std::move(items));
  py::capsule owner(owned.get(), [](void* data) { delete static_cast<std::vector<Item>*>(data); });
  return {owned.release(), owner};
}

std::string shape_text(const py::array& array) {
  return py::str(array.attr("shape")).cast<std::string>();
}

std::string type_text(const py::array& array) {
  return py::str(array.dtype()).cast<std::string>();
}

/// @throws py::value_error unless the array has three columns
void check_shape(const py::array& array, const std::string& name, const std::string& advice) {
  if (array.ndim() == 2 && array.shape(1) == 3) return;
  throw py::value_error(name + " must have the shape (n, 3), not " + shape_text(array) + advice);
}

[[noreturn]] void refuse_index(py::ssize_t triangle, const std::string& index,
                               std::size_t vertices) {
  throw Error(ErrorCode::index_out_of_range,
              "triangle " + std::to_string(triangle) + " names vertex " + index +
                  ", but there are " + std::to_string(vertices) + " vertices, from 0",
              {.path = {}, .first = static_cast<std::size_t>(triangle)});
}

/// @param Number wide enough for every value of the array
template <class Number>
std::vector<Triangle> triangles_of(const py::array& array, std::size_t vertices) {
  const auto numbers = py::array_t<Number, py::array::c_style | py::array::forcecast>(array);
  std::vector<Triangle> triangles(static_cast<std::size_t>(array.shape(0)));
  const auto at = numbers.template unchecked<2>();
  for (py::ssize_t t = 0; t < array.shape(0); ++t) {
    for (py::ssize_t corner = 0; corner < 3; ++corner) {
      const Number index = at(t, corner);
      if (std::cmp_less(index, 0) || std::cmp_greater_equal(index, vertices))
        refuse_index(t, std::to_string(index), vertices);
      triangles[static_cast<std::size_t>(t)][static_cast<std::size_t>(corner)] =
          static_cast<Index>(index);
    }
  }
  return triangles;
}

std::vector<Triangle> triangles_of(const py::object& object, std::size_t vertices) {
  const py::array array = py::module_::import("numpy").attr("asarray")(object);
  if (array.size() == 0)
    throw Error(ErrorCode::no_triangles, "there are no triangles: faces is empty");
  const char kind = array.dtype().kind();
  if (kind != 'i' && kind != 'u')
    throw py::type_error("faces must be whole numbers, not of type " + type_text(array));
  const bool quads = array.ndim() == 2 && array.shape(1) == 4;
  check_shape(array, "faces", quads ? ": divide each quad into two triangles" : "");
  return kind == 'u' ? triangles_of<std::uint64_t>(array, vertices)
                     : triangles_of<std::int64_t>(array, vertices);
}

}  // namespace

Numbers view_of(const std::vector<Vec3>& points, const py::object& owner) {
  return view(points.empty() ? nullptr : &points.front().x, {size_of(points.size()), 3}, owner);
}

Numbers view_of(const std::vector<Vec2>& points, const py::object& owner) {
  return view(points.empty() ? nullptr : &points.front().x, {size_of(points.size()), 2}, owner);
}

Numbers view_of(const std::vector<double>& values, const py::object& owner) {
  return view(values.data(), {size_of(values.size())}, owner);
}

Indices view_of(const std::vector<Triangle>& triangles, const py::object& owner) {
  return view(triangles.empty() ? nullptr : triangles.front().data(),
              {size_of(triangles.size()), 3}, owner);
}

Indices view_of(const std::vector<Index>& indices, const py::object& owner) {
  return view(indices.data(), {size_of(indices.size())}, owner);
}

Numbers array_of(std::vector<Vec3> points) {
  const auto [data, owner] = kept(std::move(points));
  return view_of(*data, owner);
}

Numbers array_of(std::vector<Vec2> points) {
  const auto [data, owner] = kept(std::move(points));
  return view_of(*data, owner);
}

Numbers array_of(std::vector<double> values) {
  const auto [data, owner] = kept(std::move(values));
  return view_of(*data, owner);
}

std::vector<Vec3> positions_of(const py::object& object) {
  const py::array array = py::module_::import("numpy").attr("asarray")(object);
  const char kind = array.dtype().kind();
  if (kind != 'f' && kind != 'i' && kind != 'u')
    throw py::type_error("vertices must be numbers, not of type " + type_text(array));
  check_shape(array, "vertices", "");
  const auto numbers = py::array_t<double, py::array::c_style | py::array::forcecast>(array);
  std::vector<Vec3> positions(static_cast<std::size_t>(array.shape(0)));
  const auto at = numbers.unchecked<2>();
  for (py::ssize_t v = 0; v < array.shape(0); ++v)
    positions[static_cast<std::size_t>(v)] = {at(v, 0), at(v, 1), at(v, 2)};
  return positions;
}

TriMesh mesh_of(const py::object& vertices, const py::object& faces) {
  TriMesh mesh;
  mesh.positions = positions_of(vertices);
  if (mesh.positions.size() >= std::numeric_limits<Index>::max())
    throw Error(ErrorCode::too_large, "there are too many vertices: at most 4294967294 can be had");
  mesh.triangles = triangles_of(faces, mesh.positions.size());
  return mesh;
}

}  // namespace planish::python
