#pragma once

// What tests ask of pages.

#include <cstddef>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace planish::pages {

inline std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) {
    ++found;
  }
  return found;
}

/// The page without the bytes of its pictures, which may hold any letters.
inline std::string without_pictures(std::string page) {
  for (std::size_t at; (at = page.find("data:image/png;base64,")) != std::string::npos;) {
    page.erase(at, page.find('"', at) - at);
  }
  return page;
}

/// The page without its script and the data of that.
inline std::string without_scripts(std::string page) {
  for (std::size_t at; (at = page.find("<script")) != std::string::npos;)
    page.erase(at, page.find("</script>", at) + 9 - at);
  return page;
}

/// @param page whole
inline void expect_nothing_from_outside(const std::string& page) {
  const std::string still = without_scripts(without_pictures(page));
  for (const char* part :
       {"http:", "https", "javascript", "url(", "@import", "<link", " src=\"h"}) {
    EXPECT_EQ(count(still, part), 0U) << part;
  }
  EXPECT_EQ(count(page, "<script"),
            count(page, "<script>") + count(page, "<script type=\"application/json\""))
      << "no script comes from elsewhere";
  EXPECT_THAT(page, testing::HasSubstr("content=\"default-src 'none'; "));
  EXPECT_THAT(page, testing::HasSubstr("style-src 'unsafe-inline'; img-src data:; base-uri 'none'; "
                                       "form-action 'none'\""));
  EXPECT_EQ(count(page, "script-src 'unsafe"), 0U);
}

/// @param whole page
inline void expect_closed_tags(const std::string& whole) {
  const std::string page = without_scripts(without_pictures(whole));
  for (const std::string tag :
       {"html",  "head",  "body",  "main", "header",  "section", "figure", "figcaption",
        "table", "tbody", "thead", "tr",   "td",      "th",      "svg",    "div",
        "dl",    "dd",    "dt",    "p",    "h2",      "span",    "b",      "small",
        "data",  "g",     "ul",    "li",   "details", "summary", "h3",     "code"}) {
    EXPECT_EQ(count(page, "<" + tag + ">") + count(page, "<" + tag + " "),
              count(page, "</" + tag + ">"))
        << tag;
  }
}

}  // namespace planish::pages
