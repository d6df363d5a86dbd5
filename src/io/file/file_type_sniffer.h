#pragma once

#include <string_view>

namespace planish {

/// "UTF-16" or "UTF-32" where the bytes are text of ASCII letters in that encoding, with or without
/// a byte order mark; else empty.
std::string_view wide_encoding(std::string_view bytes);

/// Refuses what is plainly no mesh file but an archive, an image, a document or a scene.
/// @throws Error malformed_file naming the kind
void refuse_foreign(std::string_view bytes, std::string_view name);

}  // namespace planish
