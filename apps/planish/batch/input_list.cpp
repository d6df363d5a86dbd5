#include "batch/input_list.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <istream>
#include <iterator>
#include <string_view>

#include <planish/core/error.h>
#include <planish/io/mesh_format.h>

#include "platform/path.h"
#include "shell/failures.h"
#include "shell/file_name.h"
#include "shell/safe_names.h"

namespace planish::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view k_blanks = " \t\r";
constexpr std::string_view k_byte_order_mark = "\xEF\xBB\xBF";
constexpr std::size_t k_longest_path = 32'767;  // of Windows; 4,096 bytes elsewhere

std::string_view trimmed(std::string_view line) {
  const std::size_t first = line.find_first_not_of(k_blanks);
  if (first == std::string_view::npos) return {};
  return line.substr(first, line.find_last_not_of(k_blanks) - first + 1);
}

bool is_control(char c) {
  return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
}

void refuse_what_is_no_path(std::string_view path, const SourceLocation& place) {
  if (std::any_of(path.begin(), path.end(), is_control)) {
    throw Error(ErrorCode::malformed_file,
                "has a control character, which no path has: a list is text with a path a line",
                place);
  }
  if (path.size() > k_longest_path) {
    throw Error(ErrorCode::malformed_file,
                "has " + std::to_string(path.size()) + " bytes, more than a path can have", place);
  }
}

bool is_mesh_name(const std::string& path) {
  const std::string extension = lower_extension(path);
  return std::any_of(k_mesh_formats.begin(), k_mesh_formats.end(), [&](MeshFormat format) {
    return extension == "." + std::string(to_string(format));
  });
}

std::string content_of_list(const std::string& file) {
  std::error_code ignored;
  if (!fs::exists(path_of(file), ignored))
    throw Error(ErrorCode::file_not_found, "cannot be read: there is no such file", {.path = file});
  if (fs::is_directory(path_of(file), ignored)) {
    throw Error(ErrorCode::file_unreadable,
                "is a folder; --inputs takes a file with a path a line, or - for standard input",
                {.path = file});
  }
  std::ifstream stream(path_of(file), std::ios::binary);
  std::string content{std::istreambuf_iterator<char>(stream), {}};
  if (!stream && !stream.eof())
    throw Error(ErrorCode::file_unreadable, "cannot be read", {.path = file});
  return content;
}

}  // namespace

Shard shard_from(const Arguments& arguments) {
  if (!arguments.has("--shard")) return {};
  const std::string text = arguments.text("--shard");
  const char* const end = text.data() + text.size();
  Shard shard{0, 0};
  const auto number = std::from_chars(text.data(), end, shard.number);
  if (number.ec == std::errc() && number.ptr != end && *number.ptr == '/') {
    const auto count = std::from_chars(number.ptr + 1, end, shard.count);
    const bool is_whole = count.ec == std::errc() && count.ptr == end;
    if (is_whole && shard.number >= 1 && shard.number <= shard.count) return shard;
  }
  throw UsageError("--shard is \"" + text + "\" but must be K/N with K from 1 to N, like 1/20");
}

std::vector<ListedInput> listed_inputs(const std::string& text, const std::string& name) {
  std::string_view rest = text;
  if (rest.starts_with(k_byte_order_mark)) rest.remove_prefix(k_byte_order_mark.size());
  const fs::path folder = path_of(name).parent_path();
  std::vector<ListedInput> inputs;
  for (std::size_t line = 1; !rest.empty(); ++line) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view path = trimmed(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (path.empty() || path.front() == '#') continue;
    refuse_what_is_no_path(path, {.path = name, .line = line});
    inputs.push_back({.path = utf8_of(folder / path_of(path)), .line = line});
  }
  if (inputs.empty()) {
    throw Error(ErrorCode::malformed_file, "names no input: a list has a path on each line",
                {.path = name});
  }
  return inputs;
}

std::vector<ListedInput> inputs_from(const Arguments& arguments, Session& session) {
  const std::string file = arguments.text("--inputs");
  if (is_mesh_name(file)) {
    throw UsageError("--inputs takes a list of paths, and " + file +
                     " looks like a mesh: give it without --inputs");
  }
  if (file != "-") return listed_inputs(content_of_list(file), file);
  std::istream* const input = session.standard_input();
  if (input == nullptr) throw UsageError("--inputs is - but there is no standard input here");
  const std::string text{std::istreambuf_iterator<char>(*input), {}};
  return listed_inputs(text, "standard input");
}

std::vector<ListedInput> numbered(std::vector<ListedInput> inputs) {
  std::vector<std::string> stems;
  stems.reserve(inputs.size());
  for (const ListedInput& input : inputs)
    stems.push_back(stem_of(input.path));
  std::vector<std::string> folders = safe_names(stems);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    inputs[i].number = i + 1;
    inputs[i].folder = std::move(folders[i]);
  }
  return inputs;
}

std::vector<ListedInput> of_shard(const std::vector<ListedInput>& inputs, const Shard& shard) {
  std::vector<ListedInput> own;
  for (std::size_t i = shard.number - 1; i < inputs.size();
       i += std::min(shard.count, inputs.size() - i))
    own.push_back(inputs[i]);
  return own;
}

}  // namespace planish::cli
