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

inline void expect_nothing_from_outside(const std::string& page) {
  for (const char* part : {"http:", "https", "<script", "javascript", "url(", "@import", "<link"}) {
    EXPECT_EQ(count(page, part), 0U) << part;
  }
  EXPECT_THAT(page, testing::HasSubstr("content=\"default-src 'none'; style-src 'unsafe-inline'; "
                                       "img-src data:\""));
}

inline void expect_closed_tags(const std::string& page) {
  for (const std::string tag :
       {"html",       "head",  "body",  "main",  "header", "section", "figure",
        "figcaption", "table", "tbody", "thead", "tr",     "td",      "th",
        "svg",        "div",   "dl",    "dd",    "dt",     "p",       "h2",
        "span",       "b",     "small", "data",  "g",      "ul",      "li"}) {
    EXPECT_EQ(count(page, "<" + tag + ">") + count(page, "<" + tag + " "),
              count(page, "</" + tag + ">"))
        << tag;
  }
}

}  // namespace planish::pages
