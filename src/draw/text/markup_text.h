#pragma once

#include <string>
#include <string_view>

namespace planish {

/// Text from outside made safe between and inside the tags of SVG and HTML: & < > " ' as entities,
/// tabs and line ends as blanks; other control characters, bytes that are no UTF-8 and code points
/// that XML forbids as U+FFFD.
std::string escape_markup(std::string_view text);

}  // namespace planish
