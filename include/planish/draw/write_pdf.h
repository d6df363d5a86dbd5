#pragma once

#include <array>
#include <string>
#include <string_view>

#include <planish/draw/drawing.h>

namespace planish {

/// The drawing as a PDF of one page at true size, with the sheet's size for a page and a word to
/// viewers not to scale it when printing. Each layer is one that viewers can show and hide;
/// coordinates to 0.001 mm. Text is set in Helvetica, which viewers have, as long as it keeps to
/// the characters of Windows-1252 (a minus sign is set as an en dash); other text is drawn as
/// strokes and cannot be searched for. Nothing is compressed and no date written: the same drawing
/// gives the same bytes. Sheets longer than 5.08 m have a larger unit (PDF 1.6), which old viewers
/// ignore.
std::string write_pdf(const Drawing& drawing);

enum class Paper { a4, a3, letter, a0 };

inline constexpr std::array k_papers = {Paper::a4, Paper::a3, Paper::letter, Paper::a0};

/// "a4", ...
std::string_view to_string(Paper paper);

/// @throws Error unknown_name
Paper paper_named(std::string_view name);

/// The drawing at true size on pages of a printer's paper, to be joined. The first page shows where
/// each goes, and test squares. Pages are upright or across, whatever needs fewer; 10 mm at
/// each edge stay free, neighbours overlap by 10 mm, and crosses in the overlap tell how they join.
/// Rows have letters from the top, columns numbers. Pages with nothing on them are crossed out on
/// the first page and left out. Otherwise as write_pdf().
/// @throws Error too_large where it would take more than 10,000 pages
std::string write_tiled_pdf(const Drawing& drawing, Paper paper);

}  // namespace planish
