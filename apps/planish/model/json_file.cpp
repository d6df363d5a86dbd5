#include "model/json_file.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

#include <planish/core/error.h>

#include "platform/path.h"
#include "shell/nearest.h"
#include "shell/values.h"

namespace planish::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t k_largest_file = 4'000'000;  // bytes

std::string content_of(const std::string& path, std::string_view what) {
  std::error_code failure;
  const std::uintmax_t size = fs::file_size(path_of(path), failure);
  if (failure) throw Error(ErrorCode::file_unreadable, failure.message());
  if (size > k_largest_file)
    throw Error(ErrorCode::too_large, std::string(what) + " has at most 4 MB");
  std::ifstream file(path_of(path), std::ios::binary);
  std::string content{std::istreambuf_iterator<char>(file), {}};
  if (!file && !file.eof()) throw Error(ErrorCode::file_unreadable, "cannot be read");
  return content;
}

/// Throws where a text is no JSON, or nested so deep that nobody meant it.
[[noreturn]] void refuse_text(const std::string& text, const std::string& path) {
  try {
    // Nothing is kept, so that any depth can be read.
    const Json none =
        Json::parse(text, [](int, Json::parse_event_t, const Json&) { return false; });
  } catch (const Json::parse_error& error) {
    const std::size_t at = std::min(error.byte, text.size());
    const std::string before = text.substr(0, at > 0 ? at - 1 : 0);
    const auto lines = static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
    const std::size_t column = before.size() - (before.rfind('\n') + 1) + 1;  // npos + 1 is 0
    throw Error(ErrorCode::malformed_file,
                "is no JSON, from column " + std::to_string(column) + " on",
                {.path = path, .line = lines + 1});
  }
  throw Error(ErrorCode::malformed_file, "is nested too deep", {.path = path});
}

bool is_control(char c) {
  return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
}

}  // namespace

void refuse(const std::string& where, const std::string& what) {
  throw Error(ErrorCode::malformed_file, where.empty() ? what : where + ": " + what);
}

JsonEntry::JsonEntry(const Json& json, std::string where, std::span<const std::string> keys)
    : json_(json), where_(std::move(where)) {
  if (!json.is_object()) refuse(where_, "must be an object: {...}");
  for (const auto& [key, value] : json.items()) {
    if (std::find(keys.begin(), keys.end(), key) == keys.end())
      refuse(where_, "unknown key \"" + key + "\"" + nearest_hint(key, keys) + "; known are " +
                         list_of(keys));
  }
}

std::string JsonEntry::where(std::string_view key) const {
  return (where_.empty() ? "" : where_ + ".") + std::string(key);
}

const Json* JsonEntry::find(std::string_view key) const {
  const auto found = json_.find(std::string(key));
  return found == json_.end() ? nullptr : &*found;
}

const Json& JsonEntry::required(std::string_view key) const {
  const Json* value = find(key);
  if (value == nullptr) refuse(where_, "needs \"" + std::string(key) + "\"");
  return *value;
}

std::optional<std::string> JsonEntry::text(std::string_view key) const {
  const Json* value = find(key);
  if (value == nullptr) return std::nullopt;
  if (!value->is_string() || value->get<std::string>().empty())
    refuse(where(key), "must be a text in quotes");
  std::string text = value->get<std::string>();
  if (std::any_of(text.begin(), text.end(), is_control))
    refuse(where(key), "must be one line, without control characters");
  return text;
}

std::string JsonEntry::required_text(std::string_view key) const {
  required(key);
  return *text(key);
}

bool JsonEntry::yes(std::string_view key) const {
  const Json* value = find(key);
  if (value == nullptr) return false;
  if (!value->is_boolean()) refuse(where(key), "must be true or false");
  return value->get<bool>();
}

Json read_json_file(const std::string& path, std::string_view what) try {
  const std::string text = content_of(path, what);
  Json json = parse_shallow(text);
  if (json.is_discarded()) refuse_text(text, path);
  return json;
} catch (const Error& error) {
  SourceLocation place = error.place();
  place.path = path;
  throw Error(error.code(), error.message(), place);
}

}  // namespace planish::cli
