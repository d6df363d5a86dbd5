#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <planish/flatten/product.h>
#include <planish/io/mesh_format.h>
#include <planish/io/write_file.h>
#include <planish/pattern/pattern_options.h>

#include "shell/command.h"

namespace planish::cli {

/// What a patch's results are made from, besides the version of the program.
struct PatchJob {
  std::string name;
  MeshFormat format = MeshFormat::obj;
  std::string mesh;    ///< a hash of it
  std::string border;  ///< a hash of what of it is sewn
  std::vector<Notch> notches = {};
  std::vector<SeamNumber> seam_numbers = {};
  std::map<std::string, std::string, std::less<>> flags = {};  ///< that results depend on

  struct Other {
    std::string name, mesh;
  };
  std::optional<Other> twin_of = {};  ///< the patch that it is a twin of
};

/// @param settings of this piece alone
PatchJob job_of(const ProductPatch& patch, MeshFormat format, const PatternOptions& annotations,
                const SewnBorder& border, const Arguments& arguments,
                const ProductPatch* twin_of = nullptr,
                const std::map<std::string, std::string>& settings = {});

/// The job.json that says that these files are the results of the job, with the figures that the
/// product as a whole needs.
OutputFile job_file(const PatchJob& job, const FinishedPatch& results,
                    const std::vector<OutputFile>& files, const std::filesystem::path& folder);

/// The results in the folder, where they are those of the job, every file is as it was written, and
/// they are all that is needed: anybody may have written there.
std::optional<FinishedPatch> finished_results(const PatchJob& job,
                                              const std::filesystem::path& folder);

}  // namespace planish::cli
