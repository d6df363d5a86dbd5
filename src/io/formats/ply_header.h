#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "io/file/text_cursor.h"

namespace planish {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

enum class PlyEncoding { ascii, little_endian, big_endian };

struct PlyProperty {
  std::string_view name;
  PlyType type;
  std::optional<PlyType> count_type;  ///< of a list
};

struct PlyElement {
  std::string_view name;
  std::uint64_t count;  ///< as announced, anything up to 2^64 - 1
  std::vector<PlyProperty> properties;

  /// The property of this name, if any.
  const PlyProperty* find(std::string_view property) const;
};

struct PlyHeader {
  PlyEncoding encoding;
  std::vector<PlyElement> elements;
  std::size_t body;  ///< offset of the first byte after the header

  /// The element of this name, if any.
  const PlyElement* find(std::string_view element) const;
};

/// The number of the faces that says which part of the surface each belongs to, if there is one.
const PlyProperty* group_property(const PlyElement& faces);

/// Bytes of a value of the type in a binary file.
std::size_t size_of(PlyType type);

/// Reads the header and leaves the cursor behind it. Names are views of the cursor's text.
PlyHeader read_ply_header(TextCursor& cursor);

}  // namespace planish
