#pragma once

#include <string>
#include <string_view>

namespace planish {

/// Bytes as base64 (RFC 4648), for data inside of a page.
std::string base64(std::string_view bytes);

}  // namespace planish
