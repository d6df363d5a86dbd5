#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <planish/mesh/patch.h>
#include <planish/mesh/seams.h>

namespace planish {

/// A side of a seam along the border of a piece.
struct OutlinedSeam {
  std::size_t number = 1;  ///< from 1, written at its middle
  SeamSide side;           ///< of the piece
};

/// The class that gives a seam its colour on a page, of eight in turn.
std::string seam_class(std::size_t number);

/// How outlines of patterns are drawn: in a window of one size for all pages, at a scale that fits
/// all patterns that are given.
class OutlineWindow {
 public:
  explicit OutlineWindow(std::span<const std::vector<Vec2>> patterns);

  double scale() const { return scale_; }  ///< units of the window per unit of the pattern

 private:
  double scale_ = 1.0;
};

/// The outline of a pattern as SVG for a page, in the middle of the window: the border, and over it
/// each seam in its colour with its number.
/// @param patch the piece
/// @param pattern a position for each vertex
/// @param alt what it shows, plain text
std::string piece_outline(const Patch& patch, std::span<const Vec2> pattern,
                          const OutlineWindow& window, const std::string& alt,
                          std::span<const OutlinedSeam> seams = {});

}  // namespace planish
