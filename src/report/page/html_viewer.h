#pragma once

#include <string>

#include <planish/report/html_report.h>

namespace planish {

/// The part of a page where the patch stands beside its pattern: still pictures of the patch, which
/// the page's script takes away for a view that can be turned, and the pattern as a drawing.
struct PatchViewer {
  std::string html;
  std::string data;    ///< for the script, to stand behind the page's content; empty without script
  Vec2 cut_size = {};  ///< of the pattern with its allowance, model units
};

/// The same of a comparison, with a choice of the method and without a pattern; nothing without
/// script, as such a page has pictures of every method.
PatchViewer html_viewer(const CompareReport& report);

/// @throws Error as pattern_sheet()
PatchViewer html_viewer(const FlattenReport& report, const FlattenPage& page);

}  // namespace planish
