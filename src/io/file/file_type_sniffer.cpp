#include "io/file/file_type_sniffer.h"

#include <array>
#include <string>

#include <planish/core/error.h>

namespace planish {
namespace {

using namespace std::string_view_literals;

struct Kind {
  std::string_view begins, name;
};

constexpr std::array<Kind, 18> k_kinds = {{{"\x1f\x8b"sv, "a gzip archive; unpack it"},
                                           {"PK\3\4"sv, "a zip archive (as 3MF is); unpack it"},
                                           {"\x28\xb5\x2f\xfd"sv, "a zstd archive; unpack it"},
                                           {"\xfd"
                                            "7zXZ\0"sv,
                                            "an xz archive; unpack it"},
                                           {"BZh91AY"sv, "a bzip2 archive; unpack it"},
                                           {"7z\xbc\xaf\x27\x1c"sv, "a 7z archive; unpack it"},
                                           {"Rar!\x1a\7"sv, "a rar archive; unpack it"},
                                           {"\x89PNG"sv, "a PNG image"},
                                           {"\xff\xd8\xff"sv, "a JPEG image"},
                                           {"%PDF-"sv, "a PDF document"},
                                           {"glTF"sv, "a glTF scene"},
                                           {"Kaydara FBX"sv, "an FBX scene"},
                                           {"BLENDER"sv, "a Blender scene"},
                                           {"ISO-10303-21"sv, "a STEP model"},
                                           {"<?xml"sv, "XML or HTML"},
                                           {"<!DOCTYPE"sv, "XML or HTML"},
                                           {"<html"sv, "XML or HTML"},
                                           {"<HTML"sv, "XML or HTML"}}};

}  // namespace

std::string_view wide_encoding(std::string_view bytes) {
  const auto begins = [bytes](std::string_view with) { return bytes.starts_with(with); };
  if (begins("\0\0\xfe\xff"sv) || begins("\xff\xfe\0\0"sv)) return "UTF-32";
  if (begins("\xff\xfe"sv) || begins("\xfe\xff"sv)) return "UTF-16";
  if (bytes.size() < 4) return {};
  // Which of the first four bytes are zero.
  unsigned zeros = 0;
  for (const char byte : bytes.substr(0, 4))
    zeros = 2 * zeros + (byte == '\0' ? 1U : 0U);
  if (zeros == 0b0111 || zeros == 0b1110) return "UTF-32";
  return zeros == 0b0101 || zeros == 0b1010 ? "UTF-16"sv : ""sv;
}

void refuse_foreign(std::string_view bytes, std::string_view name) {
  for (const Kind& kind : k_kinds) {
    if (!bytes.starts_with(kind.begins)) continue;
    throw Error(ErrorCode::malformed_file, "the file is no mesh but " + std::string(kind.name),
                {.path = std::string(name), .byte = 0});
  }
}

}  // namespace planish
