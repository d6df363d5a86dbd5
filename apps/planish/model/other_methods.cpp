#include "model/other_methods.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include <planish/core/error.h>
#include <planish/evolve/own_method.h>
#include <planish/io/mesh_format.h>
#include <planish/io/read_mesh.h>

#include "flags/method_flags.h"
#include "model/model_flags.h"
#include "platform/path.h"
#include "shell/failures.h"

namespace planish::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view k_with = "--with", k_input = "{in}", k_output = "{out}";

/// What one --with says: a file or folder, or the words of a command.
struct OtherResult {
  std::string name;
  std::string place;
  std::vector<std::string> command = {};
};

/// Names stand in tables and in names of files.
bool is_good_name(const std::string& name) {
  constexpr std::size_t longest = 40;
  const auto is_good = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-' || c == '.';
  };
  return !name.empty() && name.size() <= longest && name.front() != '.' && name.front() != '-' &&
         std::all_of(name.begin(), name.end(), is_good);
}

OtherResult other_result_of(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals + 1 == text.size()) {
    throw UsageError(
        "flag --with takes NAME=FILE or NAME=COMMAND, as mine=evolved.obj or "
        "\"mine=./mine {in} {out}\", not " +
        text);
  }
  const std::string name = text.substr(0, equals), value = text.substr(equals + 1);
  asked_in("flag --with", [&] { check_other_name(name); });
  const bool has_input = value.find(k_input) != std::string::npos;
  const bool has_output = value.find(k_output) != std::string::npos;
  if (has_input != has_output)
    throw UsageError("flag --with: a command has both {in} and {out}, and " + value + " has one");
  return {name, value, has_input ? words_of_command(value) : std::vector<std::string>()};
}

[[noreturn]] void fail(const std::string& message) {
  throw Error(ErrorCode::method_failed, message);
}

/// The corners of all triangles, whatever order these and their corners have.
std::vector<Triangle> sorted(std::vector<Triangle> triangles) {
  for (Triangle& corners : triangles)
    std::sort(corners.begin(), corners.end());
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

/// A temporary folder for the files of one run of a program; removed with its content.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    int number = 0;
    do  // until the name is free
      path_ = fs::temp_directory_path() / path_of("planish-" + std::to_string(number++));
    while (!fs::create_directory(path_));
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  fs::path file(const char* name) const { return path_ / name; }

 private:
  fs::path path_;
};

std::string with_place(std::string word, std::string_view mark, const std::string& path) {
  for (std::size_t at = word.find(mark); at != std::string::npos;
       at = word.find(mark, at + path.size()))
    word.replace(at, mark.size(), path);
  return word;
}

/// Runs the program on the surface as it is now.
std::vector<Vec3> result_of_program(std::vector<std::string> words, const SweepInput& input,
                                    Session& session) {
  const TemporaryFolder folder;
  const fs::path in = folder.file("in.obj"), out = folder.file("out.obj");
  write_mesh(in, {input.positions, input.design.triangles()});
  for (std::string& word : words)
    word = with_place(with_place(word, k_input, utf8_of(in)), k_output, utf8_of(out));
  const std::string fault = session.run_program(words);
  if (!fault.empty()) fail("its program " + words.front() + " " + fault);
  try {
    return positions_over(input.design.mesh(), read_mesh(out).mesh);
  } catch (const Error& error) {
    if (error.code() == ErrorCode::method_failed) throw;
    if (error.code() == ErrorCode::file_not_found) fail("its program wrote no mesh to {out}");
    fail("its program wrote a mesh that cannot be read: " + error.message());
  }
}

/// Reads the mesh that a file has, or a folder under the name of the input, as the input was read.
std::vector<Vec3> result_in_file(const std::string& place, const std::string& path,
                                 const SweepInput& input, const Arguments& arguments,
                                 Session& session) {
  std::error_code ignored;
  const fs::path given = path_of(place);
  const bool is_folder = fs::is_directory(given, ignored);
  const fs::path file = is_folder ? given / path_of(path).filename() : given;
  return positions_over(input.design.mesh(), read_piece(utf8_of(file), arguments, session).mesh);
}

}  // namespace

Flag with_flag() {
  return {std::string(k_with),
          "NAME=RESULT",
          "compare a result from outside as that of a method called NAME: a mesh with the "
          "triangles of the input, a folder with such a mesh under the name of each input, or a "
          "command that reads {in} and writes {out}, as \"mine=./mine {in} {out}\"",
          0,
          false,
          {.repeats = true}};
}

std::vector<std::string> words_of_command(const std::string& command) {
  std::vector<std::string> words;
  char quote = 0;
  bool in_word = false;
  for (const char c : command) {
    const bool opens = quote == 0 && (c == '"' || c == '\'');
    const bool divides = quote == 0 && (c == ' ' || c == '\t');
    if (!divides && !in_word) words.emplace_back();
    in_word = !divides;
    if (opens) {
      quote = c;
    } else if (quote != 0 && c == quote) {
      quote = 0;
    } else if (!divides) {
      words.back() += c;
    }
  }
  if (quote != 0) throw UsageError("a quote is not closed in " + command);
  return words;
}

void check_other_name(const std::string& name) {
  if (!is_good_name(name)) {
    throw UsageError(
        "a name has at most 40 letters of ASCII, digits, hyphens, dots and "
        "underscores, not " +
        name);
  }
  const std::vector<std::string> methods = method_names();
  if (std::find(methods.begin(), methods.end(), name) != methods.end())
    throw UsageError("there is already a method " + name);
}

std::vector<Vec3> positions_over(const TriMesh& design, TriMesh result) {
  const std::size_t count = design.positions.size();
  if (result.positions.size() != count) {
    fail("its mesh has " + std::to_string(result.positions.size()) + " vertices, the input has " +
         std::to_string(count));
  }
  if (result.triangles != design.triangles &&
      sorted(std::move(result.triangles)) != sorted(design.triangles))
    fail("its mesh has other triangles than the input, or its vertices have another order");
  return std::move(result.positions);
}

std::vector<CompareRun> runs_with(const std::string& path, const Arguments& arguments,
                                  Session& session) {
  std::vector<CompareRun> runs;
  const auto given = arguments.flags.find(k_with);
  if (given == arguments.flags.end()) return runs;
  std::vector<std::string> names;
  for (const Field& field : given->second) {
    OtherResult other = other_result_of(field_text(field));
    if (std::find(names.begin(), names.end(), other.name) != names.end())
      throw UsageError("flag --with: " + other.name + " is named twice");
    names.push_back(other.name);
    OwnMethod method = {.name = other.name, .usual_sweeps = 1, .moves_border = true};
    method.sweep = [other, path, &arguments, &session](const SweepInput& input) {
      return other.command.empty() ? result_in_file(other.place, path, input, arguments, session)
                                   : result_of_program(other.command, input, session);
    };
    runs.push_back({method, usual_stopping(method)});
  }
  if (!runs.empty() && arguments.has("--fix"))
    throw UsageError(
        "--with and --fix do not go together: what comes from outside knows of no "
        "fixed vertices");
  return runs;
}

}  // namespace planish::cli
