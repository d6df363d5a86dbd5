#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <planish/draw/color.h>
#include <planish/flatten/product.h>

#include <pybind11/pybind11.h>

#include "cut/cut_flag.h"
#include "mesh_data.h"
#include "output/flatten_files.h"
#include "shell/command.h"

namespace planish::python {

/// What `flatten` made of a patch, with what its flags ask of drawings.
struct FlattenResult {
  FlattenReport report;
  cli::PatternFiles pattern;
  cli::Arguments arguments;
  std::optional<cli::CutOutcome> cut = {};
  MeshFormat format = MeshFormat::obj;  ///< of the meshes that it writes
  std::vector<std::string> notes = {};
};

/// Files, and their paths by role.
struct SavedFiles {
  std::vector<OutputFile> files;
  WrittenFiles paths;
};

/// What `flatten` of the program writes into a folder.
SavedFiles files_in(const FlattenResult& result, const std::filesystem::path& folder);

/// The words of what is missed.
std::vector<std::string> words_of(const Outcome& outcome);

/// The page of a result.
std::string page_of(const FlattenResult& result);

}  // namespace planish::python
