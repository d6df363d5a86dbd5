#include "report/product/html_table.h"

#include "draw/text/markup_text.h"
#include "report/page/html_parts.h"

namespace planish {

namespace {

std::string row_of(const std::vector<std::string>& cells, const char* element) {
  std::string html = "<tr>";
  for (const std::string& cell : cells)
    html += "<" + std::string(element) + ">" + escape_markup(cell) + "</" + element + ">";
  return html + "</tr>\n";
}

}  // namespace

std::string html_table_page(const TablePage& page) {
  std::string html =
      "<section>\n<h2>All patches</h2>\n<div class=\"scroll\">\n<table "
      "class=\"compare\">\n<thead>" +
      row_of(page.heads, "th") + "</thead>\n<tbody>\n";
  for (const std::vector<std::string>& row : page.rows)
    html += row_of(row, "td");
  html += "</tbody>\n</table>\n</div>\n</section>\n";
  std::string below;
  for (const std::string& fact : page.facts)
    below += "<p>" + escape_markup(fact) + "</p>\n";
  return html_page({.kind = "patches", .name = page.name, .verdict = page.verdict, .below = below},
                   html);
}

}  // namespace planish
