#pragma once

#include <string>
#include <string_view>

#include <planish/draw/color.h>
#include <planish/evolve/evolve.h>
#include <planish/report/html_report.h>

#include "draw/image.h"
#include "report/page/legend.h"

namespace planish {

/// Parts that the pages of all reports are made of: HTML.

/// What a page has around its content.
struct PageFrame {
  std::string_view kind;        ///< of the page, as in "report"
  std::string name;             ///< of the patch, plain text; an empty one reads "Patch"
  std::string verdict;          ///< what came out, plain text; its first sentence is large
  std::string below = {};       ///< markup below that
  std::string_view style = {};  ///< to stand behind that of all pages
  std::string unit = {};        ///< of the model, where the page says it
  std::string data = {};        ///< markup; the page's script works on it, and is not there without
  std::string app = {};         ///< markup beside the name
};

/// How a page leads to the app: a link with the project, to which the page's script adds a button.
std::string app_links(const PageProject& project);

/// The whole page: nothing from outside may be fetched, and no script may run but the page's own.
/// @param content markup
std::string html_page(const PageFrame& frame, const std::string& content);

/// A picture with words below it.
/// @param alt, caption markup
std::string html_picture(const Image& image, const std::string& alt, const std::string& caption);
/// The same, of a picture that is there more than once.
/// @param source picture_source(image)
std::string html_picture(const Image& image, const std::string& source, const std::string& alt,
                         const std::string& caption);

/// The picture itself, as the source of an element.
std::string picture_source(const Image& image);

/// Pixels of a picture in a tile, which is twice as wide as it is shown.
inline constexpr int k_tile_width = 420;

/// A picture in a tile.
/// @param alt plain text
std::string html_tile_picture(const Image& image, const std::string& alt);

/// A term of a list and what is said of it, plain text.
std::string html_entry(std::string_view name, std::string_view text);

/// What the ends of a scale of angle defects mean.
LegendLabels defect_labels(ColorMap colors, double limit);

/// "lambda 0.5, order sequential": as the method describes them. Plain text.
std::string options_text(const Method& method);

/// "10 sweeps in 0.25 s on 2 threads". Plain text.
std::string effort_text(const EvolveResult& result);

}  // namespace planish
