#include <sstream>
#include <string>
#include <vector>

#include <planish/core/version.h>

#include <pybind11/pybind11.h>

#include "errors.h"
#include "job.h"
#include "mesh_data.h"
#include "run.h"

namespace planish::python {

namespace {

/// What `planish describe --json` prints.
std::string description() {
  const std::vector<std::string> words = {"describe", "--json"};
  std::ostringstream out;
  std::ostringstream err;
  cli::run(words, out, err);
  return out.str();
}

}  // namespace

}  // namespace planish::python

PYBIND11_MODULE(_core, module) {
  using namespace planish::python;
  module.doc() = "The library of Planish; import planish instead.";
  module.attr("__version__") = planish::k_version;
  module.def("description", description);
  py::module_::import("atexit").attr("register")(py::cpp_function(end_jobs));
  register_errors();
  register_mesh(module);
  register_measure(module);
  register_evolve(module);
  register_patterns(module);
  register_compare(module);
  register_product(module);
}
