#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <planish/core/error.h>
#include <planish/mesh/tri_mesh.h>

#include "core/number_text.h"

namespace planish {

/// The most vertices and the most triangles of a mesh: one number of an Index stays free.
inline constexpr std::uint64_t k_most_items = std::numeric_limits<Index>::max() - 1;

/// Whether a vertex comes twice.
bool has_repeat(std::span<const Index> corners);

/// Refuses a mesh that Index cannot number. `what` is "vertices" or "triangles".
template <class Cursor>
void check_size(std::uint64_t count, const char* what, const Cursor& cursor) {
  if (count <= k_most_items) return;
  cursor.fail(ErrorCode::too_large, "the file has more than " + std::to_string(k_most_items) + " " +
                                        what + ", the most that is supported");
}

/// The vertex that a number of a file names, counted from 0.
/// @param vertices at most k_most_items
template <class Cursor>
Index checked_index(double number, std::uint64_t vertices, const Cursor& cursor) {
  if (number >= 0.0 && number < static_cast<double>(vertices)) {
    const auto index = static_cast<Index>(number);
    if (static_cast<double>(index) == number) return index;
    cursor.fail(ErrorCode::bad_number, number_text(number) + " is not a vertex number");
  }
  cursor.fail(ErrorCode::index_out_of_range, "it refers to vertex " + number_text(number) +
                                                 " but the file has " + std::to_string(vertices) +
                                                 " vertices, counted from 0");
}

/// Collects the faces of a file as triangles; a polygon becomes a fan around its first corner.
class FaceList {
 public:
  void reserve(std::size_t triangles) { triangles_.reserve(triangles); }
  std::size_t size() const { return triangles_.size(); }
  std::vector<Triangle> take() { return std::move(triangles_); }

  /// "split 64 polygons into 128 triangles"; empty if there were triangles only.
  std::string note() const;

  /// Adds a face. Only a triangle may name a vertex twice: such a triangle is plainly degenerate,
  /// while the fan of such a polygon would be a guess.
  template <class Cursor>
  void add(std::span<const Index> corners, const Cursor& cursor) {
    if (corners.size() < 3) {
      cursor.fail(ErrorCode::malformed_file,
                  "a face needs 3 corners but has " + std::to_string(corners.size()));
    }
    check_size(triangles_.size() + corners.size() - 2, "triangles", cursor);
    if (corners.size() == 3) {
      triangles_.push_back({corners[0], corners[1], corners[2]});
      return;
    }
    if (has_repeat(corners)) {
      cursor.fail(ErrorCode::malformed_file,
                  "a face of " + std::to_string(corners.size()) + " corners names a vertex twice");
    }
    add_fan(corners);
  }

 private:
  void add_fan(std::span<const Index> corners);

  std::vector<Triangle> triangles_;
  std::size_t polygons_ = 0;
  std::size_t fan_triangles_ = 0;
};

}  // namespace planish
