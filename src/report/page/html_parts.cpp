#include "report/page/html_parts.h"

#include <cmath>
#include <type_traits>

#include <planish/core/version.h>

#include "core/figure_text.h"
#include "core/number_text.h"
#include "draw/base64.h"
#include "draw/text/markup_text.h"
#include "report/enumerator_name.h"
#include "report/page/page_assets.h"

namespace planish {

namespace {

/// @param source as of picture_source()
/// @param pixels of the picture in one of the page
/// @param alt markup
std::string image_element(const Image& image, const std::string& source, int pixels,
                          const std::string& alt) {
  return "<img width=\"" + std::to_string(image.width / pixels) + "\" height=\"" +
         std::to_string(image.height / pixels) + "\" alt=\"" + alt + "\" src=\"" + source + "\">";
}

std::string head(const std::string& title, std::string_view more_style) {
  const PageScript script = page_script();
  const std::string scripts =
      script.is_there() ? "script-src '" + std::string(script.hash) + "'; " : "";
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
         "<meta name=\"color-scheme\" content=\"light dark\">\n"
         "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; " +
         scripts +
         "style-src 'unsafe-inline'; img-src data:; base-uri 'none'; form-action "
         "'none'\">\n<title>" +
         title + " – Planish</title>\n<style>" + std::string(page_style()) +
         std::string(more_style) + "</style>\n</head>\n";
}

std::string script_element() {
  std::string html = "<script>";
  for (const std::string_view part : page_script().parts)
    html += part;
  return html + "</script>\n";
}

}  // namespace

std::string html_page(const PageFrame& frame, const std::string& content) {
  const std::string title = frame.name.empty() ? "Patch" : escape_markup(frame.name);
  const std::string& verdict = frame.verdict;
  const std::size_t end = verdict.find(". ");
  const std::size_t split = end == std::string::npos ? verdict.size() : end + 1;
  return head(title, frame.style) +
         "<body>\n<main>\n<header>\n<div class=\"title\"><p class=\"brand\">Planish " +
         std::string(frame.kind) + "</p><h1>" + title + "</h1>" + frame.app +
         "</div>\n<p class=\"verdict\"><b>" + escape_markup(verdict.substr(0, split)) + "</b>" +
         escape_markup(verdict.substr(split)) + "</p>\n" + frame.below + "</header>\n" + content +
         "<footer>Made by planish " + k_version + "." +
         (frame.unit.empty() ? "" : " Model unit: " + frame.unit + ".") + "</footer>\n</main>\n" +
         frame.data + (frame.data.empty() || !page_script().is_there() ? "" : script_element()) +
         "</body>\n</html>\n";
}

std::string app_links(const PageProject& project) {
  if (project.text.empty() && !page_script().is_there()) return {};
  std::string html = "<p class=\"app\" data-app=\"" + escape_markup(project.app) + "\">";
  if (!project.text.empty()) {
    html += "<a id=\"project\" href=\"data:application/json;base64," + base64(project.text) +
            "\" download=\"" + escape_markup(project.name) +
            "\" title=\"Lines and options of this run, for the app and for planish flatten: the "
            "model's file goes with it\">Project file</a>";
  }
  std::string flags;
  for (const std::string& flag : project.left_out)
    flags += (flags.empty() ? "" : ", ") + escape_markup(flag);
  if (!flags.empty()) html += "<small>without " + flags + "</small>";
  return html + "</p>";
}

std::string picture_source(const Image& image) {
  return "data:image/png;base64," + base64(format_png(image));
}

std::string html_picture(const Image& image, const std::string& alt, const std::string& caption) {
  return html_picture(image, picture_source(image), alt, caption);
}

std::string html_picture(const Image& image, const std::string& source, const std::string& alt,
                         const std::string& caption) {
  return "<figure><div class=\"plate\">" + image_element(image, source, 1, alt) +
         "</div><figcaption>" + caption + "</figcaption></figure>\n";
}

std::string html_tile_picture(const Image& image, const std::string& alt) {
  return image_element(image, picture_source(image), 2, escape_markup(alt));
}

std::string html_entry(std::string_view name, std::string_view text) {
  return "<dt>" + std::string(name) + "</dt><dd>" + escape_markup(text) + "</dd>\n";
}

LegendLabels defect_labels(ColorMap colors, double limit) {
  const std::string text = significant_text(limit, 1) + "\u00A0rad";
  if (colors == ColorMap::paper) return {"<b>0</b> flattenable", "", "<b>" + text + "</b>"};
  return {"saddle <b>−" + text + "</b>", "<b>0</b> flattenable", "dome <b>+" + text + "</b>"};
}

std::string options_text(const Method& method) {
  std::string text;
  const auto add = [&](std::string_view name, const auto& value, auto&&...) {
    if (!text.empty()) text += ", ";
    text += std::string(name) + " ";
    using Value = std::decay_t<decltype(value)>;
    if constexpr (std::is_same_v<Value, BorderFreedom>) {
      const bool named = value.rule != BorderFreedom::Rule::within;
      text += named ? std::string(enumerator_name(value.rule)) : number_text(value.distance);
    } else if constexpr (std::is_enum_v<Value>) {
      text += enumerator_name(value);
    } else {
      text += std::isfinite(value) ? number_text(value) : "unlimited";
    }
  };
  std::visit([&](auto some) { describe(some, add); }, method);
  return text;
}

std::string effort_text(const EvolveResult& result) {
  return count_text(result.history.size()) +
         (result.history.size() == 1 ? " sweep in " : " sweeps in ") +
         significant_text(result.seconds, 2) + " s on " + std::to_string(result.threads) +
         (result.threads == 1 ? " thread" : " threads");
}

}  // namespace planish
