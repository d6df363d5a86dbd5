#pragma once

#include <string>

#include <pybind11/pybind11.h>

#include "shell/command.h"

namespace planish::python {

namespace py = pybind11;

/// @param verb of the program
const cli::Command& command_named(const std::string& verb);

/// What keywords ask of a verb: lambda_min=0.1 is its flag --lambda-min, lambda_ is --lambda. Lists
/// are values with commas between them, or rows where the flag names a file; True is a switch,
/// False and None are none.
/// @param verb of the program
/// @throws py::type_error for values that no flag takes; UsageError for empty texts
cli::Arguments arguments_of(const std::string& verb, const py::dict& keywords);

}  // namespace planish::python
