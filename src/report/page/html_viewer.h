#pragma once

#include <string>

#include <planish/report/html_report.h>

namespace planish {

/// The part of a page where the patch stands beside its pattern: still pictures of the patch, which
/// the page's script takes away for a view that can be turned, and the pattern as a drawing.
struct PatchViewer {
  std::string html;
  std::string data;  ///< for the script, to stand behind the page's content; empty without script
};

/// The same of a comparison, with a choice of the method and without a pattern; nothing without
/// script, as such a page has pictures of every method.
PatchViewer html_viewer(const CompareReport& report);

/// @param pattern as pattern_geometry() of the report
/// @param sheet as pattern_sheet() of that
PatchViewer html_viewer(const FlattenReport& report, const PatternGeometry& pattern,
                        const Drawing& sheet, ColorMap colors);

}  // namespace planish
