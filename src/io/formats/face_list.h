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
#include "io/file/cursor_error.h"

namespace planish {

/// The most vertices and the most triangles of a mesh: one number of an Index stays free.
inline constexpr std::uint64_t k_most_items = std::numeric_limits<Index>::max() - 1;

/// Whether a vertex comes twice.
bool has_repeat(std::span<const Index> corners);

template <class Cursor>
[[noreturn]] void refuse_size(const char* what, const Cursor& cursor) {
  cursor.fail(ErrorCode::too_large, "the file has more than " + std::to_string(k_most_items) + " " +
                                        what + ", the most that is supported");
}

/// Refuses a mesh that Index cannot number. `what` is "vertices" or "triangles".
template <class Cursor>
void check_size(std::uint64_t count, const char* what, const Cursor& cursor) {
  if (count > k_most_items) refuse_size(what, cursor);
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

/// Collects the faces of a file as triangles. Polygons are divided at the end, as a file may have
/// its faces before their places; until then the fan of each holds the numbers of its triangles.
class FaceList {
 public:
  /// @param strict refuses what would be mended with a note
  explicit FaceList(bool strict) : strict_(strict) {}

  void reserve(std::size_t triangles) { triangles_.reserve(triangles); }
  std::size_t size() const { return triangles_.size(); }

  /// "split 64 polygons into 128 triangles" and what was dropped; empty if there were triangles
  /// only.
  std::vector<std::string> notes() const;

  /// Adds a face. A triangle may name a vertex twice: it is plainly degenerate. Of a polygon,
  /// corners that come twice in a row are dropped; what then has fewer than three is kept as a
  /// triangle that names a vertex twice.
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
    if (repeats_in_a_row(corners)) {
      if (strict_) {
        cursor.fail(ErrorCode::malformed_file, "a face of " + std::to_string(corners.size()) +
                                                   " corners names a vertex twice in a row");
      }
      corners = without_repeats(corners);
    }
    add_fan(corners);
    if (corners.size() > 3) {
      polygons_.push_back({triangles_.size() + 2 - corners.size(), corners.size(), cursor.place()});
    }
  }

  /// The triangles, of polygons those that divide them inside.
  /// @param positions of all vertices, finite
  template <class Cursor>
  std::vector<Triangle> take(std::span<const Vec3> positions, const Cursor& cursor) {
    for (const Polygon& polygon : polygons_) {
      if (divide(polygon, positions)) continue;
      cursor.fail_at(polygon.place, ErrorCode::malformed_file, refusal(polygon));
    }
    return std::move(triangles_);
  }

 private:
  struct Polygon {
    std::size_t first, corner_count;  ///< first: of its triangles
    ReadPlace place;
  };

  static bool repeats_in_a_row(std::span<const Index> corners);
  std::span<const Index> without_repeats(std::span<const Index> corners);
  void add_fan(std::span<const Index> corners);
  std::vector<Index> corners_of(const Polygon& polygon) const;
  /// Writes the triangles of a polygon over its fan; false where it crosses itself.
  bool divide(const Polygon& polygon, std::span<const Vec3> positions);
  std::string refusal(const Polygon& polygon) const;

  bool strict_;
  std::vector<Triangle> triangles_;
  std::vector<Polygon> polygons_;
  std::vector<Index> kept_;  // corners of the last polygon of which some were dropped
  std::size_t dropped_ = 0;
};

}  // namespace planish
