#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace planish {

/// What can be wrong with a file, a mesh or a request. docs/errors.md has a paragraph on each.
enum class ErrorCode {
  // Files
  file_not_found,
  file_unreadable,
  file_unwritable,
  unsupported_format,
  // What a file says
  malformed_file,
  truncated_file,
  bad_number,
  index_out_of_range,
  no_triangles,
  too_large,
  // What a mesh is
  non_finite_coordinate,
  repeated_index,
  duplicate_triangle,
  zero_length_edge,
  zero_area,
  non_manifold_edge,
  non_manifold_vertex,
  inconsistent_orientation,
  non_orientable,
  closed_surface,
  open_surface,
  several_components,
  several_border_loops,
  handles,
  no_inner_vertex,
  unreferenced_vertex,
  // What was asked
  option_out_of_range,
  unknown_name,
  unsupported_constraint,
  misplaced_cut,
  not_symmetric,
  // What could not be done
  unfold_failed,
  overlapping_outline,
  allowance_too_wide,
  misplaced_allowance,
  misplaced_notch,
  misplaced_mark,
  no_grain_direction,
  piece_too_large,
  method_failed,
};

/// The stable name of a code, as in "non_manifold_edge".
std::string_view to_string(ErrorCode code);

/// Where the fault is. Only what is known is set.
struct SourceLocation {
  std::string path;                       ///< file
  std::optional<std::size_t> line = {};   ///< line of a text file, from 1
  std::optional<std::size_t> byte = {};   ///< offset in a binary file, from 0
  std::optional<std::size_t> first = {};  ///< first vertex, triangle or edge at fault, from 0
  std::optional<std::size_t> count = {};  ///< how many are at fault
};

/// A fault of the input or the request: a stable code, a message that names the cause and what to
/// do, and the place. Not converging is never an error; faults of ours are assertions.
class Error : public std::runtime_error {
 public:
  /// @param message one line, without the place, which what() puts in front
  Error(ErrorCode code, const std::string& message, SourceLocation place = {});

  /// The kind of fault, for programs to act on.
  ErrorCode code() const noexcept { return code_; }
  /// Where it is, as far as that is known.
  const SourceLocation& place() const noexcept { return place_; }
  /// The message without the place; what() has "path:line: message".
  const std::string& message() const noexcept { return message_; }

 private:
  ErrorCode code_;
  std::string message_;
  SourceLocation place_;
};

}  // namespace planish
