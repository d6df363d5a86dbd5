#pragma once

#include <string_view>

namespace planish {

/// The style sheets of web/ (cmake/PlanishPageStyle.cmake), for wide and narrow, light and dark
/// screens and for paper.

/// Of every page: page.css, layout.css, viewer.css, panel.css and pieces.css.
std::string_view page_style();

/// What a page has beside that where strain is shown beside its limit (limit.css): more to choose
/// from, a scale with a field apart.
std::string_view limit_style();

}  // namespace planish
