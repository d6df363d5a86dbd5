#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include <planish/core/vec.h>
#include <planish/draw/drawing.h>

namespace planish {

inline constexpr int k_millimetres = 4;                // as $INSUNITS counts units
inline constexpr std::size_t k_longest_dxf_name = 31;  // as R12 allows it

/// The lines of a DXF file: each value below the code of what it is.
class DxfTags {
 public:
  void add(int code, std::string_view value);
  void add(int code, int value);
  /// A real number, which always has a point.
  void add_real(int code, double value);
  /// A point with z = 0, the codes `code`, `code` + 10 and `code` + 20.
  void add_point(int code, Vec2 place);

  void begin_section(std::string_view name);
  void end_section();
  /// A POINT; `height` is its z coordinate.
  void add_point_entity(std::string_view layer, Vec2 place, double height = 0.0);
  /// A TEXT whose line begins at the place.
  void add_text(std::string_view layer, Vec2 at, double height, std::string_view text);
  /// Place, height, words and alignment of a TEXT.
  void add_words(const Text& text);
  /// What follows the name of the text style that every file has.
  void add_text_style();
  /// A POLYLINE with its VERTEX entities and SEQEND.
  /// @param looks tags of colour and line type
  void add_polyline(std::string_view layer, std::span<const Vec2> places, bool closed,
                    const DxfTags& looks);

  void append(const DxfTags& other) { text_ += other.text_; }
  bool is_empty() const { return text_.empty(); }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// Text as a DXF file may hold it: in ASCII, with what has a meaning there escaped.
std::string dxf_text(std::string_view text);

/// A name as R12 allows it.
std::string dxf_name(std::string_view name);

}  // namespace planish
