#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>

#include "io/file/cursor_error.h"

namespace planish {

/// The bytes of a number in the given order.
template <class T>
std::array<char, sizeof(T)> to_bytes(T value, std::endian order) {
  auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
  if (order != std::endian::native) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

/// Walks over binary values and never looks outside the bytes.
class ByteCursor {
 public:
  /// `bytes` and `name` must outlive the cursor.
  ByteCursor(std::string_view bytes, std::string_view name, std::size_t offset)
      : bytes_(bytes), name_(name), offset_(offset), item_offset_(offset) {}

  std::size_t remaining() const { return bytes_.size() - offset_; }

  /// What errors name from now on; their place is the byte at which it begins.
  void begin_item(std::string_view kind, std::size_t number) {
    item_ = {kind, number};
    item_offset_ = offset_;
  }

  /// Goes over n bytes. @throws Error truncated_file
  void skip(std::size_t n) {
    if (n > remaining()) fail_end();
    offset_ += n;
  }

  /// The next value. @throws Error truncated_file
  template <class T>
  T value(std::endian order) {
    std::array<char, sizeof(T)> bytes;
    if (sizeof(T) > remaining()) fail_end();
    std::memcpy(bytes.data(), bytes_.data() + offset_, sizeof(T));
    offset_ += sizeof(T);
    if (order != std::endian::native) std::reverse(bytes.begin(), bytes.end());
    return std::bit_cast<T>(bytes);
  }

  ReadPlace place() const { return {item_offset_, item_}; }
  [[noreturn]] void fail_at(const ReadPlace& place, ErrorCode code,
                            const std::string& message) const {
    throw_read_error(code, message, {.path = std::string(name_), .byte = place.at}, place.item);
  }
  [[noreturn]] void fail(ErrorCode code, const std::string& message) const {
    fail_at(place(), code, message);
  }

 private:
  [[noreturn]] void fail_end() const {
    fail(ErrorCode::truncated_file,
         "the file ends within it, after " + std::to_string(bytes_.size()) + " bytes");
  }

  std::string_view bytes_;
  std::string_view name_;
  std::size_t offset_;
  std::size_t item_offset_;
  ReadItem item_;
};

}  // namespace planish
