#pragma once

#include <utility>

#include <planish/evolve/own_method.h>

#include <pybind11/pybind11.h>

#include "job.h"

namespace planish::python {

namespace py = pybind11;

/// A function of Python as a method, called by the calling thread of a job.
/// @param function takes a SweepInput and returns an array (n, 3); it and the job must outlive
/// every
///   call
OwnMethod method_of(const py::object& function, Job& job);

/// The value of the keyword `method` if it is a function, else None; and all other keywords.
std::pair<py::object, py::dict> own_function_of(const py::dict& keywords);

/// SweepInput.
void register_sweep_input(py::module_& module);

}  // namespace planish::python
