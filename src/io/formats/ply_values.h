#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "io/file/byte_cursor.h"
#include "io/file/text_cursor.h"
#include "io/formats/ply_header.h"

namespace planish {

/// The values of an ASCII PLY file. Within an item line ends count for nothing: some writers break
/// long lines.
class TextValues {
 public:
  static constexpr bool is_text = true;
  explicit TextValues(const TextCursor& cursor) : cursor_(cursor) {}

  static std::uint64_t fewest_bytes(PlyType) { return 2; }
  /// As if the last value had something behind it, too.
  std::uint64_t remaining() const { return cursor_.remaining() + 1; }
  const TextCursor& cursor() const { return cursor_; }
  /// Every item ends where a line does: one number too many or too few would shift all that follow.
  void begin_item(std::string_view kind, std::size_t number) {
    if (std::exchange(in_item_, !kind.empty()) && !cursor_.at_line_end()) {
      cursor_.fail(ErrorCode::malformed_file,
                   "it ends within a line: a number is missing, or there is one too many");
    }
    cursor_.begin_item(kind, number);
  }
  std::string rest_note(std::uint64_t faces) { return cursor_.rest_note(faces); }

  double next(PlyType) {
    cursor_.skip_to_token();
    return cursor_.number();
  }

  void skip(PlyType, std::uint64_t count) {
    for (; count > 0; --count) {
      if (!cursor_.skip_to_token()) cursor_.fail_missing("a number");
      cursor_.token();
    }
  }

 private:
  TextCursor cursor_;
  bool in_item_ = false;
};

/// The values of a binary PLY file.
class BinaryValues {
 public:
  static constexpr bool is_text = false;
  BinaryValues(const ByteCursor& cursor, std::endian order) : cursor_(cursor), order_(order) {}

  static std::uint64_t fewest_bytes(PlyType type) { return size_of(type); }
  std::uint64_t remaining() const { return cursor_.remaining(); }
  const ByteCursor& cursor() const { return cursor_; }
  void begin_item(std::string_view kind, std::size_t number) { cursor_.begin_item(kind, number); }

  std::string rest_note(std::uint64_t /*faces*/) const {
    const std::size_t rest = cursor_.remaining();
    return rest == 0 ? "" : "ignored " + std::to_string(rest) + " bytes after the last item";
  }

  double next(PlyType type) {
    switch (type) {
      case PlyType::int8:
        return value<std::int8_t>();
      case PlyType::uint8:
        return value<std::uint8_t>();
      case PlyType::int16:
        return value<std::int16_t>();
      case PlyType::uint16:
        return value<std::uint16_t>();
      case PlyType::int32:
        return value<std::int32_t>();
      case PlyType::uint32:
        return value<std::uint32_t>();
      case PlyType::float32:
        return static_cast<double>(value<float>());
      case PlyType::float64:
        break;
    }
    return value<double>();
  }

  /// @param count at most 2^32
  void skip(PlyType type, std::uint64_t count) { cursor_.skip(size_of(type) * count); }

 private:
  template <class T>
  T value() {
    return cursor_.value<T>(order_);
  }

  ByteCursor cursor_;
  std::endian order_;
};

}  // namespace planish
