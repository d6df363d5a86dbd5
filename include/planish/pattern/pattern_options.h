#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include <planish/core/unit.h>
#include <planish/pattern/allowance.h>
#include <planish/pattern/curve.h>
#include <planish/pattern/marks.h>
#include <planish/pattern/notches.h>

namespace planish {

/// What is written inside a piece; nothing where all is empty.
struct PieceLabel {
  std::string name = {};    ///< of the piece
  std::string size = {};    ///< as "40"
  int quantity = 0;         ///< how many to cut; 0: not said, which for machines is one
  std::string fabric = {};  ///< what it is cut from
  std::string note = {};    ///< as "cut on fold"
  int mirrored = 0;         ///< how many of the quantity are mirror images
};

/// The grain of a pattern: a direction on the model, or one in the pattern by its angle to the
/// sheet's x axis, in degrees, counter-clockwise.
using Grain = std::variant<Vec3, double>;

/// What is written of a seam inside the piece, beside a vertex of its border: "seam 3: back" in the
/// middle of its side, "3a" and "3b" near the ends. Sides are sewn a to a and b to b.
struct SeamNumber {
  int number = 0;            ///< of the seam, from 1
  Index vertex = 0;          ///< of the mesh
  std::string partner = {};  ///< the piece on the other side; empty: this one, as along a dart
  char end = 0;              ///< 'a' where the seam begins, 'b' where it ends; 0: its middle
};

/// Where a pattern's places are those of another one, mirrored or not (twin_report()): its lines
/// are drawn from the same point on, and what is written of the outline in thousandths of a
/// millimetre is the mirror image of what is written of the other's, digit by digit.
struct MirrorReference {
  bool mirrored = false;  ///< the other one is the mirror image
  Index start = 0;        ///< vertex of this mesh that the other's outline begins at
};

/// What a pattern gets besides its outline.
struct PatternOptions {
  std::optional<Allowance> allowance = {};          ///< none: the outline is what is cut
  std::vector<EdgeAllowance> edge_allowances = {};  ///< where it is another; idle without allowance
  std::vector<PatternEdge> edges = {};              ///< names, and allowances by number
  double kerf = 0.0;                                ///< that the machine cuts away, millimetres
  bool overlaps = false;  ///< whether the pattern overlaps itself: its cut line goes around both
                          ///< layers, or where much of it does it has neither allowance nor kerf
  Unit sheet_unit = Unit::mm;         ///< of lengths that are written on the sheet
  std::optional<FoldLine> fold = {};  ///< none: the piece is drawn whole
  bool open_fold = false;             ///< sheet_to_cut() draws the whole of a piece that has a fold
  std::vector<Notch> notches = {};    ///< on the border
  NotchSizes notch_sizes = {};        ///< of all notches
  std::optional<Grain> grain = {};    ///< none: no grain line is drawn
  std::vector<Mark> marks = {};       ///< at vertices
  std::vector<InnerLine> inner_lines = {};    ///< from vertex to vertex
  std::vector<SurfaceLine> drawn_lines = {};  ///< inner lines from place to place
  std::vector<SeamNumber> seam_numbers = {};  ///< of a product's seams
  PieceLabel label = {};                      ///< written inside the piece
  bool edge_lengths = false;                  ///< written along the outline, from corner to corner
  LineFit curves = {};       ///< how near curves stay to lines; tolerance 0: no curves
  std::string date = {};     ///< for the sheet's label; never taken from a clock
  double model_scale = 1.0;  ///< for the label: what the model was multiplied with
  /// For the label: how far a place of the surface is from its design at most, model units.
  std::optional<double> moved = {};
  std::string form_faults = {};  ///< for the label: as "is lost", of the form; empty: none
  std::string cautions = {};     ///< for the label: as words_of(), with commas; empty: none
  std::optional<MirrorReference> like =
      {};  ///< of a twin: how its lines follow those of the other one

  /// Whether half of the piece is drawn.
  bool is_half() const { return fold && !fold->opened; }
};

/// The options of a piece for the mirror image of it: a grain that is given by its angle is
/// mirrored, one by a direction on the model stays that. Labels and all that stands at vertices
/// stay.
PatternOptions for_mirror_image(PatternOptions options);

/// The options of a piece for the mesh that is its mirror image, with the same vertices. Stretches
/// of the border are reversed, as the border runs the other way there. The grain is not changed.
PatternOptions on_mirrored_border(PatternOptions options);

/// Checks what can be known before there is a pattern: that notches and the ends of allowances are
/// on the border of the mesh and marks at vertices of it.
/// @param border loops of vertices
/// @param name of the patch; the piece is called so where the options have no name for it
/// @throws Error misplaced_notch, misplaced_allowance, index_out_of_range, naming the piece
void check_pattern_options(const PatternOptions& options, std::size_t vertex_count,
                           std::span<const std::vector<Index>> border, const std::string& name);

/// The vertices that the options name.
std::vector<Index> named_vertices(const PatternOptions& options);

/// The same options for a mesh over some of the vertices.
/// @param source vertex of that mesh -> vertex that the options speak of, increasing, with all that
///   they name; numbers of seams beside other vertices are left out
PatternOptions renumbered(PatternOptions options, std::span<const Index> source);

}  // namespace planish
