#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <planish/core/error.h>
#include <planish/core/vec.h>
#include <planish/io/read_features.h>

namespace planish {

/// The whole number, at least 0, that a field is or that its word says, the largest where it says a
/// larger one; nothing of others.
std::optional<std::uint64_t> field_count(const Field& field);

/// Takes the fields of a row one after the other. Errors have its place.
class RowCursor {
 public:
  /// Both must outlive the cursor.
  RowCursor(const Rows& rows, const Row& row) : name_(rows.name), row_(row) {}

  bool at_end() const { return at_ == row_.fields.size(); }
  SourceLocation place() const { return {.path = name_, .line = row_.number}; }

  /// @param what is missing where no field is left
  /// @throws Error malformed_file
  const Field& next(const char* what);

  /// The number of a vertex, counted from 0, that a field of the row is.
  /// @param vertex_count of the mesh, where that is known
  /// @throws Error bad_number, index_out_of_range
  Index vertex(const Field& field, std::optional<std::size_t> vertex_count = {}) const;

  /// All fields that are left as numbers of vertices, also with commas between them.
  /// @throws as vertex()
  std::vector<Index> vertices(std::size_t vertex_count);

  /// @throws Error malformed_file where a field is left
  void end();

  [[noreturn]] void fail(ErrorCode code, const std::string& message) const {
    throw Error(code, message, place());
  }

 private:
  const std::string& name_;
  const Row& row_;
  std::size_t at_ = 0;
};

}  // namespace planish
