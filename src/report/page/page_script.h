#pragma once

#include <span>
#include <string_view>

namespace planish {

/// The script of the pages, made of web/ when the program is built, with what it needs of
/// three.js. Where the program was built without Node, there is none, and pages show still
/// pictures.
struct PageScript {
  std::string_view hash;                    ///< as a Content-Security-Policy names it
  std::span<const std::string_view> parts;  ///< that follow on each other

  bool is_there() const { return !parts.empty(); }
};

PageScript page_script();

}  // namespace planish
