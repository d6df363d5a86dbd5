#include <string>
#include <vector>

#include <pybind11/stl.h>

#include "batch/input_list.h"
#include "commands/jobs.h"
#include "job.h"
#include "keywords.h"
#include "mesh_data.h"

namespace planish::python {

namespace {

/// The records of what a run made of files, one a patch, lines of JSON in no order.
/// @param paths empty where `inputs` of the keywords names a list
std::vector<std::string> flatten_many(const std::vector<std::string>& paths,
                                      const py::dict& keywords, py::object progress) {
  const cli::Arguments arguments = arguments_of("flatten", keywords);
  return Job(arguments, std::move(progress)).run([&](cli::Session& session) {
    std::vector<cli::ListedInput> inputs;
    for (const std::string& path : paths)
      inputs.push_back({.path = path});
    if (inputs.empty()) inputs = cli::inputs_from(arguments, session);
    std::vector<std::string> records;
    const cli::CommandResult result = cli::flatten_list(
        std::move(inputs), arguments, [&](const std::string& record) { records.push_back(record); },
        session);
    if (result.exit_code == cli::k_exit_interrupted) throw Cancelled();
    return records;
  });
}

}  // namespace

void register_many(py::module_& module) {
  module.def("flatten_many", flatten_many, py::arg("paths"), py::arg("keywords"),
             py::arg("progress"));
}

}  // namespace planish::python
