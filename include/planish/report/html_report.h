#pragma once

#include <string>
#include <vector>

#include <planish/draw/color.h>
#include <planish/draw/drawing.h>
#include <planish/flatten/compare.h>
#include <planish/flatten/flatten.h>
#include <planish/flatten/frontier.h>
#include <planish/flatten/product.h>
#include <planish/sheet/pattern_geometry.h>

namespace planish {

/// A file beside a page.
struct PageFile {
  std::string path;     ///< from the page, with slashes
  std::string purpose;  ///< in a few words, plain text: "to print at 100 %"
};

/// A project file of the app (docs/app.md), which asks for the run that a page reports.
struct PageProject {
  std::string name = {};  ///< that it is saved by, plain text
  std::string text = {};  ///< its content; empty: the page offers none
  /// Flags of the run that it has no place for, plain text.
  std::vector<std::string> left_out = {};
  std::string app = "planish.html";  ///< where the app may be, from the page, with slashes
};

/// What the page of the main job says besides the report.
struct FlattenPage {
  ColorMap colors = ColorMap::diverging;  ///< paper: |defect|, blue to red as the 2010 paper has it
  std::string command = {};               ///< the command line that asked for it, plain text
  std::string material = {};      ///< what the pattern was laid on, plain text: "a roll of ..."
  bool fits = true;               ///< on that material
  std::string material_use = {};  ///< how much of that it takes, plain text
  std::vector<SweepRecord> reference = {};  ///< as reference_sweeps()
  std::vector<PageFile> files = {};         ///< with the pattern; links to them
  PageProject project = {};                 ///< for the link that opens the app
};

/// The main job's result as one HTML page that needs nothing else: the patch before and after,
/// which can be turned and compared, beside the pattern with its lines, its strain and where it
/// stretches; figures against the limits given, convergence and histogram. docs/report.md says what
/// each part means. It asks nothing of any network and opens offline. Without scripts, and on
/// paper, it has still pictures. Text from outside is escaped.
/// @param pattern as pattern_geometry() of the report
/// @param sheet as pattern_sheet() of that
std::string html_report(const FlattenReport& report, const PatternGeometry& pattern,
                        const Drawing& sheet, const FlattenPage& page = {});

/// The same with the bare pattern.
std::string html_report(const FlattenReport& report, const FlattenPage& page = {});

/// What the page of a product says besides the report.
struct ProductPage {
  std::string name = {};  ///< of the product, plain text
  /// Of each patch, the path from the page to its own report, with slashes; empty: no link.
  std::vector<std::string> reports = {};
  std::vector<Drawing> sheets = {};  ///< with the pieces on them, nest_sheet()
  std::string on_sheets = {};        ///< what they are and how well they are used, plain text
  PageProject project = {};          ///< for the link that opens the app
};

/// What became of a product as such a page: all pieces together, which can be turned and moved
/// apart; a tile for each piece, those that miss something first, with a picture of its surface,
/// its outline with the seams in colour and numbered, what it is judged by and a link to its own
/// report; below them the sheets and a table of the seams.
std::string html_report(const ProductReport& report, const ProductPage& page);

/// A comparison as such a page: the table of all methods, charts of energy, e_max and e_avg against
/// sweeps and seconds, pictures of what each method made of patch and pattern at one scale, and
/// where Laplacian directions help (direction.h).
std::string html_report(const CompareReport& report);

/// A frontier as such a page: the chart of frontier_svg() and a table of all points.
std::string html_report(const FrontierReport& report);

}  // namespace planish
