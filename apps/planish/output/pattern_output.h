#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <planish/draw/drawing.h>
#include <planish/draw/format_drawing.h>

#include "shell/command.h"

namespace planish::cli {

enum class PatternFormat { svg, dxf, pdf, plt };

std::string_view to_string(PatternFormat format);

/// The format that the extension of a path names, in either case; nothing for other extensions.
std::optional<PatternFormat> pattern_format_of(const std::string& path);

/// How patterns are written.
struct PatternOutput {
  DxfOptions dxf;
  SvgOptions svg = {};
  std::optional<PageOptions> pages;  ///< to be joined
  bool stroked_text = false;
  bool map = false;                      ///< with the strain map, in .svg and .pdf
  std::vector<std::string> only_layers;  ///< that are written; empty: all
  bool layers_by_name = true;            ///< the user has named these layers
};

/// --paper, --page-overlap, --map, --only-layers, --text, and how a .dxf is written, for verbs that
/// write patterns.
/// @param paper_doc what --paper does there
std::vector<Flag> pattern_flags(const std::string& paper_doc);

/// @throws UsageError, Error unknown_name for unknown names
PatternOutput pattern_output_from(const Arguments& arguments);

/// Refuses those of the flags above that none of the formats heeds.
/// @throws UsageError
void refuse_idle_pattern_flags(const Arguments& arguments,
                               const std::vector<PatternFormat>& formats);

/// --formats, and the formats that it names.
Flag formats_flag();
/// @throws UsageError for unknown names
std::vector<PatternFormat> formats_from(const Arguments& arguments);

/// The content of a pattern's file on one sheet.
std::string pattern_file(const Drawing& sheet, PatternFormat format, const PatternOutput& output);

/// The content of a PDF on output.pages.
std::string tiled_file(const Drawing& sheet, const PatternOutput& output);

}  // namespace planish::cli
