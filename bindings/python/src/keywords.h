#pragma once

#include <string>

#include <pybind11/pybind11.h>

#include "shell/command.h"

namespace planish::python {

namespace py = pybind11;

/// @param verb of the program
const cli::Command& command_named(const std::string& verb);

/// The command line that keywords stand for, taken apart as the program does: lambda_min=0.1 is
/// --lambda-min 0.1, lambda_ is --lambda. Numbers are written with all their digits, sequences with
/// commas; True is a switch, False and None are none.
/// @param verb of the program
/// @throws py::type_error for values that no flag takes; UsageError as the program
cli::Arguments arguments_of(const std::string& verb, const py::dict& keywords);

}  // namespace planish::python
