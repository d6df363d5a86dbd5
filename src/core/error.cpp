#include <planish/core/error.h>

namespace planish {

std::string_view to_string(ErrorCode code) {
  switch (code) {
    case ErrorCode::file_not_found:
      return "file_not_found";
    case ErrorCode::file_unreadable:
      return "file_unreadable";
    case ErrorCode::file_unwritable:
      return "file_unwritable";
    case ErrorCode::unsupported_format:
      return "unsupported_format";
    case ErrorCode::malformed_file:
      return "malformed_file";
    case ErrorCode::truncated_file:
      return "truncated_file";
    case ErrorCode::bad_number:
      return "bad_number";
    case ErrorCode::index_out_of_range:
      return "index_out_of_range";
    case ErrorCode::no_triangles:
      return "no_triangles";
    case ErrorCode::too_large:
      return "too_large";
    case ErrorCode::non_finite_coordinate:
      return "non_finite_coordinate";
    case ErrorCode::repeated_index:
      return "repeated_index";
    case ErrorCode::duplicate_triangle:
      return "duplicate_triangle";
    case ErrorCode::zero_length_edge:
      return "zero_length_edge";
    case ErrorCode::zero_area:
      return "zero_area";
    case ErrorCode::non_manifold_edge:
      return "non_manifold_edge";
    case ErrorCode::non_manifold_vertex:
      return "non_manifold_vertex";
    case ErrorCode::inconsistent_orientation:
      return "inconsistent_orientation";
    case ErrorCode::non_orientable:
      return "non_orientable";
    case ErrorCode::closed_surface:
      return "closed_surface";
    case ErrorCode::open_surface:
      return "open_surface";
    case ErrorCode::several_components:
      return "several_components";
    case ErrorCode::several_border_loops:
      return "several_border_loops";
    case ErrorCode::handles:
      return "handles";
    case ErrorCode::no_inner_vertex:
      return "no_inner_vertex";
    case ErrorCode::unreferenced_vertex:
      return "unreferenced_vertex";
    case ErrorCode::option_out_of_range:
      return "option_out_of_range";
    case ErrorCode::unknown_name:
      return "unknown_name";
    case ErrorCode::unsupported_constraint:
      return "unsupported_constraint";
    case ErrorCode::misplaced_cut:
      return "misplaced_cut";
    case ErrorCode::not_symmetric:
      return "not_symmetric";
    case ErrorCode::method_failed:
      return "method_failed";
    case ErrorCode::unfold_failed:
      return "unfold_failed";
    case ErrorCode::overlapping_outline:
      return "overlapping_outline";
    case ErrorCode::allowance_too_wide:
      return "allowance_too_wide";
    case ErrorCode::misplaced_allowance:
      return "misplaced_allowance";
    case ErrorCode::misplaced_notch:
      return "misplaced_notch";
    case ErrorCode::misplaced_mark:
      return "misplaced_mark";
    case ErrorCode::no_grain_direction:
      return "no_grain_direction";
    case ErrorCode::piece_too_large:
      return "piece_too_large";
  }
  return "unknown";
}

namespace {

std::string with_place(const std::string& message, const SourceLocation& place) {
  std::string text = place.path;
  if (place.line) text += ":" + std::to_string(*place.line);
  if (place.byte) text += " at byte " + std::to_string(*place.byte);
  return text.empty() ? message : text + ": " + message;
}

}  // namespace

Error::Error(ErrorCode code, const std::string& message, SourceLocation place)
    : std::runtime_error(with_place(message, place)),
      code_(code),
      message_(message),
      place_(std::move(place)) {}

}  // namespace planish
