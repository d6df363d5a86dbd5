#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <planish/draw/drawing.h>
#include <planish/flatten/flatten.h>
#include <planish/io/write_file.h>
#include <planish/pattern/pattern_options.h>

#include "output/pattern_output.h"

namespace planish::cli {

class Session;

/// The words of a pattern that its user has chosen.
std::vector<std::string> words_of(const std::string& name, const PieceLabel& label);

/// Notes which of the words are spelled with other letters than their own, in formats that have
/// Latin ones only.
void note_spelling(Session& session, const std::vector<std::string>& words,
                   const std::vector<PatternFormat>& formats, const PatternOutput& output);

/// Notes which of the layers that alone are written (--only-layers) have nothing on them in a
/// drawing, which layers have, and whether holes are left out of what is cut.
void note_empty_layers(Session& session, const Drawing& drawing, const PatternOutput& output);

/// How many pages a PDF of ours has; 0 of what is no PDF.
int pages_in(std::string_view pdf);

/// Notes which .pdf files are longer than a page can be: they are divided into pages, or too large
/// even for that.
void note_divided_pages(Session& session, const std::vector<OutputFile>& files,
                        const PatternOutput& output);

/// Names of what earlier runs of `flatten` wrote into the folder, as what it is called tells, and
/// this one does not: drawings, which are not of this pattern, and folders of pieces.
/// @param written files and folders of this run
std::vector<std::string> left_of_earlier_runs(const std::filesystem::path& folder,
                                              std::span<const std::filesystem::path> written);

/// Warns of these names.
void warn_of_left(Session& session, const std::filesystem::path& folder,
                  const std::vector<std::string>& names);

/// Says where a pattern reaches beyond the 16-bit coordinates that many plotters have.
void note_plotter_reach(Session& session, const UnfoldReport& report);

/// Warns of what makes a pattern unfit for cutting, and notes an unusual size.
/// @param is_unit_given the unit need not be questioned
void warn_of_pattern(Session& session, const UnfoldReport& report, bool is_unit_given);

}  // namespace planish::cli
