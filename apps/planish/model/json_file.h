#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <planish_json/json.h>

namespace planish::cli {

/// Says what is wrong in a file, and where: "pieces[1].unit: must be ...".
/// @throws Error malformed_file
[[noreturn]] void refuse(const std::string& where, const std::string& what);

/// An object of a file that people write, with its place there. Read strictly.
class JsonEntry {
 public:
  /// @param where it is, as errors name it; empty for the whole file
  /// @throws Error malformed_file for what is no object, and for a key that is none of those
  JsonEntry(const Json& json, std::string where, std::span<const std::string> keys);

  const std::string& where() const { return where_; }
  /// The place of a key.
  std::string where(std::string_view key) const;

  /// The value of a key, or nullptr.
  const Json* find(std::string_view key) const;
  /// The value of a key that must be there.
  const Json& required(std::string_view key) const;

  /// A text, not empty and without control characters.
  std::optional<std::string> text(std::string_view key) const;
  std::string required_text(std::string_view key) const;
  bool yes(std::string_view key) const;

 private:
  const Json& json_;
  std::string where_;
};

/// Reads a JSON file that people write, and makes something of it. What is wrong names the file,
/// and the line where it is no JSON.
/// @param what it is: "a product file"
/// @throws Error file_unreadable, too_large (above 4 MB), malformed_file
Json read_json_file(const std::string& path, std::string_view what);

}  // namespace planish::cli
