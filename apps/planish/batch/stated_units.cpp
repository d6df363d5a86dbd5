#include "batch/stated_units.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include <planish/core/error.h>
#include <planish/io/mesh_format.h>
#include <planish/io/read_mesh.h>

#include "batch/named_files.h"
#include "flags/units.h"
#include "platform/path.h"
#include "shell/failures.h"

namespace planish::cli {

namespace {

namespace fs = std::filesystem;

/// A mesh file of the input and what it states.
struct InputFile {
  std::string path;
  std::optional<StatedUnit> unit;
};

/// Of a regular file that is a mesh: a pipe can be read once only.
std::optional<InputFile> input_file(const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return std::nullopt;
  try {
    return InputFile{utf8_of(path), read_stated_unit(path)};
  } catch (const Error&) {
    return std::nullopt;
  }
}

std::vector<InputFile> input_files(const Command& command, const Arguments& arguments) {
  std::vector<std::string> paths = arguments.operands;
  if (command.name == "convert") paths.resize(1);  // the other one is written
  for (const char* flag : {"--from", "--to"}) {    // of carry, whose operand is no mesh
    if (arguments.has(flag)) paths.push_back(arguments.text(flag));
  }
  std::vector<InputFile> files;
  const auto add = [&](const fs::path& path) {
    if (auto file = input_file(path)) files.push_back(std::move(*file));
  };
  for (const std::string& path : paths) {
    if (!is_folder(path)) {
      add(path_of(path));
      continue;
    }
    std::error_code failure;
    std::vector<fs::path> entries = entries_of(path_of(path), failure);
    std::sort(entries.begin(), entries.end());
    for (const fs::path& entry : entries)
      add(entry);
  }
  return files;
}

/// "panel.obj: the file says "File units = inches""
std::string says(const InputFile& file) {
  return file.path + ": the file says \"" + file.unit->words + "\"";
}

}  // namespace

Arguments with_stated_unit(const Command& command, Arguments arguments, Session& session) {
  if (find_flag(command, "--unit") == nullptr) return arguments;
  std::vector<InputFile> files = input_files(command, arguments);
  const auto states = [](const InputFile& file) { return file.unit.has_value(); };
  const auto first = std::find_if(files.begin(), files.end(), states);
  if (first == files.end()) return arguments;
  if (arguments.has("--unit")) {
    const Unit asked = unit_from(arguments);
    const auto other = std::find_if(files.begin(), files.end(), [&](const InputFile& file) {
      return states(file) && file.unit->unit != asked;
    });
    if (other != files.end()) {
      session.note(says(*other) + ", but --unit says " + std::string(to_string(asked)) +
                   ", which is taken");
    }
    return arguments;
  }
  const Unit unit = first->unit->unit;
  // What is drawn for carry on two meshes is in the unit that one of them states.
  const bool one_is_enough = arguments.has("--from");
  const bool agree = std::all_of(files.begin(), files.end(), [&](const InputFile& file) {
    return states(file) ? file.unit->unit == unit : one_is_enough;
  });
  if (!agree) return arguments;
  arguments.stated_unit = unit;
  const std::string name(to_string(unit));
  session.note(
      says(*first) + ": taken as with --unit " + name +
      (find_flag(command, "--output") == nullptr && command.name != "convert"
           ? std::string()
           : "; meshes that are written do not say it, so give --unit " + name + " with them"));
  return arguments;
}

}  // namespace planish::cli
