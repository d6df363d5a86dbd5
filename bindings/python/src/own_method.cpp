#include "own_method.h"

#include <span>
#include <string>
#include <vector>

#include <planish/core/error.h>

#include "arrays.h"

namespace planish::python {

namespace {

/// What a function of Python is given, for as long as it keeps it.
struct SweepData {
  Patch design;
  std::vector<Vec3> positions;
  std::vector<Index> movable;
  int sweep = 1;

  Indices ring(Index v) const {
    if (v >= design.vertex_count()) throw py::index_error("there is no vertex of that number");
    const std::span<const Index> neighbours = design.ring(v);
    return Indices(static_cast<py::ssize_t>(neighbours.size()), neighbours.data());
  }
};

/// "umbrella" of a function with that name.
std::string name_of_function(const py::object& function) {
  const auto name = py::str(py::getattr(function, "__name__", py::str("own"))).cast<std::string>();
  return name == "<lambda>" ? "own" : name;
}

}  // namespace

OwnMethod method_of(const py::object& function, Job& job) {
  // No reference is counted: the method is copied where Python's lock is not held.
  return {.name = name_of_function(function),
          .sweep = [callee = py::handle(function), &job](const SweepInput& input) {
            std::vector<Vec3> after;
            job.in_python([&] {
              after = positions_of(
                  callee(SweepData{input.design, input.positions, input.movable, input.sweep}));
            });
            return after;
          }};
}

std::pair<py::object, py::dict> own_function_of(const py::dict& keywords) {
  py::dict others;
  py::object function = py::none();
  for (const auto& [key, value] : keywords) {
    if (key.equal(py::str("method")) && PyCallable_Check(value.ptr()) != 0)
      function = py::reinterpret_borrow<py::object>(value);
    else
      others[key] = value;
  }
  return {function, others};
}

void register_sweep_input(py::module_& module) {
  py::class_<SweepData>(module, "SweepInput", "What a method of your own is given for a sweep.")
      .def_property_readonly(
          "vertices", view_at<&SweepData::positions>,
          "Places before the sweep, shape (n, 3), model units; a read-only view.")
      .def_property_readonly("design", view_at<&SweepData::design, &Patch::positions>,
                             "Places before the first sweep, likewise.")
      .def_property_readonly("faces", view_at<&SweepData::design, &Patch::triangles>,
                             "Vertices of the triangles, shape (m, 3); a read-only view.")
      .def_property_readonly("movable", view_at<&SweepData::movable>,
                             "Vertices that may move, increasing: inner ones that are not fixed. "
                             "Others stay, whatever "
                             "is returned for them.")
      .def_property_readonly("sweep", value_at<&SweepData::sweep>, "The sweep's number, from 1.")
      .def("ring", &SweepData::ring, py::arg("vertex"),
           "The neighbours of a vertex, counter-clockwise; of one on the border from the next to "
           "the "
           "previous vertex of the border.");
}

}  // namespace planish::python
