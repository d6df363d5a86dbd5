#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <planish/draw/drawing.h>
#include <planish/flatten/flatten.h>

namespace planish {

/// What the block below a pattern says.
struct SheetFacts {
  std::string name;
  Vec2 size;                 ///< of the piece without its allowance, millimetres
  std::string allowance;     ///< its widths, as allowance_words() has them; empty without
  double filled_slit = 0.0;  ///< length of seam line in slits that the allowance fills, millimetres
  std::uint64_t hash = 0;
  std::string date;
  double model_scale = 1.0;          ///< what the model was multiplied with
  std::optional<double> moved = {};  ///< from the design at most, millimetres
  std::string form_faults = {};      ///< as "is lost", of the form; empty: none
  std::string cautions = {};         ///< what the mesh cannot show, in words; empty: none
  std::string lines = {};            ///< what the colours of lines mean, as line_words() says it
  /// Two corners of the box around the places where the outline crosses itself, on the sheet.
  std::optional<std::pair<Vec2, Vec2>> overlap = {};
};

/// The layer "label": two test squares, name, sizes, unit, scale and hash.
Layer sheet_label(const UnfoldReport& unfold, const SheetFacts& facts);

/// The words of the layer "label" but for the name.
std::vector<std::string> sheet_notes(const UnfoldReport& unfold, const SheetFacts& facts);

/// The layer "legend": what the colours of the strain map mean, beside the label.
Layer map_legend(const UnfoldReport& unfold);

}  // namespace planish
