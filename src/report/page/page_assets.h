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

/// The style sheets of web/ (cmake/PlanishPageStyle.cmake), for wide and narrow, light and dark
/// screens and for paper.

/// Of every page: base.css, page.css, layout.css, viewer.css, panel.css and pieces.css.
std::string_view page_style();

/// What a page has beside that where strain is shown beside its limit (limit.css): more to choose
/// from, a scale with a field apart.
std::string_view limit_style();

/// What the page of a product has beside that (product.css).
std::string_view product_style();

}  // namespace planish
