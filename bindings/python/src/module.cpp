#include <sstream>
#include <string>
#include <vector>

#include <planish/core/version.h>
#include <planish/measure/material.h>

#include <pybind11/pybind11.h>

#include "errors.h"
#include "flags/material_flag.h"
#include "job.h"
#include "mesh_data.h"
#include "model/material_text.h"
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

/// What `planish materials --json` prints, of all or of the one that the word names.
std::string materials_text(const std::string& word) {
  if (word.empty()) return cli::materials_json(materials());
  const Material material = cli::material_of_word(word);
  return cli::materials_json({&material, 1});
}

}  // namespace

}  // namespace planish::python

PYBIND11_MODULE(_core, module) {
  using namespace planish::python;
  module.doc() = "The library of Planish; import planish instead.";
  module.attr("__version__") = planish::k_version;
  module.def("description", description);
  module.def("materials", materials_text, py::arg("word"));
  py::module_::import("atexit").attr("register")(py::cpp_function(end_jobs));
  register_errors();
  register_mesh(module);
  register_measure(module);
  register_panels(module);
  register_evolve(module);
  register_patterns(module);
  register_compare(module);
  register_product(module);
  register_many(module);
}
