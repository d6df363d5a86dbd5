#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <planish/draw/drawing.h>
#include <planish/flatten/flatten.h>
#include <planish/pattern/pattern_options.h>

namespace planish {

/// A stretch of the seam line without a cut line beside it, as the allowance fills a slit, a dart
/// or a narrow bay there.
struct FilledStretch {
  Index vertex = 0;     ///< of the patch, half way along
  double length = 0.0;  ///< millimetres
};

/// A pattern with all that it carries, in millimetres: the lines and points that pattern files and
/// pages draw, where they draw them.
struct PatternGeometry {
  std::string name = {};             ///< of the patch
  PatternOptions options = {};       ///< that it was made with, by its vertices
  PieceOutline outline = {};         ///< the seam line: the outer one first, then those of holes
  std::vector<Polygon> cut = {};     ///< as offset_outline(); without an allowance the seam line
  std::vector<Vec2> positions = {};  ///< of all vertices
  std::vector<PlacedNotch> notches = {};          ///< in the cut line
  FittedLines fitted_cut = {}, fitted_seam = {};  ///< in fewer points, and as curves
  Polygon fold = {};                              ///< its two ends; empty without
  std::vector<Polygon> grain = {};                ///< a line and its arrow heads; empty without
  std::vector<Vec2> marks = {};                   ///< of each of the options
  std::vector<Polygon> inner_lines = {};          ///< by vertices, then those that were drawn
  std::vector<Text> texts = {};                   ///< label, lengths of edges, numbers of seams
  std::vector<FilledStretch> filled = {};         ///< of the seam line
  std::vector<std::string> left_out = {};         ///< what does not fit where it was asked for
  Vec2 size = {}, sheet_size = {};                ///< of the piece without allowance, and its sheet
  std::uint64_t hash = 0;                         ///< of the positions, as it stands on sheets

  /// The seam lines of holes, clockwise.
  std::span<const Polygon> holes() const {
    return std::span(outline.loops).subspan(outline.loops.empty() ? 0 : 1);
  }
};

/// The pattern of a result. One that overlaps itself gets no allowance, nor does a hole that its
/// allowance would fill; a notch that does not fit is left out while others fit.
/// @param options by the vertices of the patch that was given to flatten()
/// @throws Error as offset_outline(), with_edge_allowances(), fold_stretch(), place_notches(),
///   grain_direction() and mark_lines()
PatternGeometry pattern_geometry(const FlattenReport& report, const PatternOptions& options = {});

/// The same of a patch that was laid flat.
/// @param mesh that was laid flat
/// @param name of the patch; that of the piece too where the options have none
PatternGeometry pattern_geometry(const TriMesh& mesh, const UnfoldReport& unfold,
                                 const std::string& name, PatternOptions options = {});

/// Options by the vertices of `report.processed`, with what became of the form and what the mesh
/// cannot show.
/// @param options by the vertices of the patch that was given to flatten()
PatternOptions on_processed(PatternOptions options, const FlattenReport& report);

}  // namespace planish
