#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <planish/core/vec.h>
#include <planish/io/write_file.h>
#include <planish/pattern/pattern_options.h>

#include "product/parts.h"
#include "shell/command.h"

namespace planish::cli {

/// What a patch's results are made from, as its job.json says it: the program's version, a hash of
/// the mesh, the name, the notches and the flags that results depend on; of a twin also the name
/// and the mesh of the other one.
std::string job_of(const ProductPatch& patch, const PatternOptions& annotations,
                   const Arguments& arguments, const ProductPatch* twin_of = nullptr);

/// The job.json that says that these files are the results of the job.
OutputFile job_file(const std::string& job, const std::vector<OutputFile>& files,
                    const std::filesystem::path& folder);

/// Results of a patch as they are needed for the product as a whole.
struct PatchResults {
  std::string report;         ///< its report.json
  TriMesh mesh;               ///< as it was processed
  std::vector<Vec2> pattern;  ///< of that, model units
  bool is_twin = false;       ///< made from what was made of another one
};

/// The results in the folder, where they are those of the job, every file is as it was written, and
/// they are all that is needed: anybody may have written there.
std::optional<PatchResults> finished_results(const std::string& job,
                                             const std::filesystem::path& folder);

}  // namespace planish::cli
