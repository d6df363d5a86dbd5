#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <planish/core/context.h>
#include <planish/draw/color.h>
#include <planish/flatten/flatten.h>
#include <planish/io/mesh_format.h>
#include <planish/io/write_file.h>
#include <planish/report/html_report.h>
#include <planish/report/json_report.h>
#include <planish/sheet/pattern_geometry.h>

#include "layout/nest.h"
#include "output/pattern_output.h"
#include "shell/command.h"

namespace planish::cli {

/// What of the pattern is written, and how.
struct PatternFiles {
  std::vector<PatternFormat> formats;
  PatternOutput output;
  PatternOptions annotations;
};

/// What --formats, --paper and the flags of pattern and annotations ask for.
/// @throws UsageError, and as annotations_from()
PatternFiles pattern_files_from(const Arguments& arguments);

/// What the page says besides the report.
struct ReportPageOptions {
  ColorMap colors = ColorMap::diverging;
  std::string command;
  SheetFit sheet = {};               ///< no material where none was named
  Context reference = {};            ///< that the sweeps for comparison are run with
  std::vector<PageFile> files = {};  ///< of the pattern, beside the page
  PageProject project = {};
};

/// What the file of a format is for: "pattern" and "as_designed" are the SVG.
std::string role_of(const std::string& pattern, PatternFormat format);

/// The pattern of a result as it is drawn.
struct DrawnPattern {
  PatternGeometry geometry;
  Drawing sheet;   ///< for the page
  Drawing to_cut;  ///< for the files of the pattern, as sheet_to_cut()
};

/// @param annotations by the vertices of the patch that was flattened
/// @throws Error as pattern_geometry()
DrawnPattern drawn_pattern(const FlattenReport& report, const PatternOptions& annotations);

/// Role -> path of all that `flatten` writes of a patch into a folder.
/// @param format of the meshes
/// @param with_design whether the pattern of the design is written besides that of the result
WrittenFiles paths_in(const std::filesystem::path& folder, MeshFormat format,
                      const PatternFiles& pattern, bool with_design, const Arguments& arguments);

/// These files with their content.
/// @param paths as from paths_in()
/// @param drawn as drawn_pattern() of the report
/// @param json the content of report.json
std::vector<OutputFile> files_of(const FlattenReport& report, const DrawnPattern& drawn,
                                 const WrittenFiles& paths, MeshFormat format,
                                 const PatternFiles& pattern, const ReportPageOptions& words,
                                 const std::string& json);

/// The page of a report, report.html.
std::string page_of(const FlattenReport& report, const DrawnPattern& drawn,
                    const ReportPageOptions& words);

}  // namespace planish::cli
