#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <planish/pattern/piece_outline.h>

namespace planish {

/// What an allowance is like at corners that stand out.
enum class Corners {
  mitre,   ///< the sides go on until they meet
  square,  ///< cut off at right angles to the middle of the corner, as far out as the sides
  round,   ///< an arc
};
/// "mitre", "square" or "round".
std::string_view to_string(Corners corners);

/// A dart that is sewn and folded to one side, and so not cut out: two edges of the outline that
/// meet at its tip. Points of a loop, in the order of the border.
struct FoldedDart {
  std::size_t loop = 0;    ///< of the outline
  std::size_t from = 0;    ///< where it leaves the border
  std::size_t tip = 0;     ///< its inner end
  std::size_t to = 0;      ///< where it comes back to the border
  bool toward_to = false;  ///< folded over the piece behind `to`, else over that before `from`
};

/// Material to be left beyond the outline of a piece.
struct Allowance {
  double width = 10.0;               ///< millimetres
  Corners corners = Corners::mitre;  ///< how those that stand out are finished
  /// How far from the outline's corner a mitre may reach, in widths; sharper ones are squared.
  double mitre_limit = 2.5;
  bool holes = true;  ///< holes get it too and so become smaller
  bool laps = false;  ///< the outline may cross itself: the line goes around both layers then
  /// Where not empty, the width of each edge in millimetres, instead of `width`: by loop, and by
  /// the edge's first point. 0 for edges without, as along a fold.
  std::vector<std::vector<double>> edge_widths = {};
  /// Where not empty, whether each edge is on a fold (1 or 0): allowances end at its line, also
  /// where the border hardly turns there.
  std::vector<std::vector<unsigned char>> folds = {};
  /// Where not empty, the number of the hem that each edge is in, 0 for none. What a hem adds is
  /// the mirror image of the piece, with its other allowances, in the hem's line.
  std::vector<std::vector<int>> hems = {};
  /// Darts whose cloth stays in the piece, shaped so that its edge lies on that of the piece when
  /// the dart is folded. They need `edge_widths` and `folds`.
  std::vector<FoldedDart> darts = {};
};

/// The outline of a piece with its allowance: the border of all that is no farther from the piece
/// than the width, but for corners that are not round. Arcs are chords that are at most 0.005 mm
/// inside them. Outer lines run counter-clockwise, lines around what is left of holes, and around
/// what a bay closed by its allowance encloses, clockwise; no line meets itself or another one.
/// docs/pattern.md says why that is what comes out.
///
/// A corner that does not look like one from as far off as the allowance is wide, such as a jag of
/// a border of small triangles, is rounded whatever is asked for.
/// @throws Error option_out_of_range (widths that are not above 0, or above the longer side of the
///   piece's box; a limit below 1; a hem wider than the piece behind it), overlapping_outline,
///   allowance_too_wide (fills a hole), misplaced_allowance (a hem that is not straight)
std::vector<Polygon> offset_outline(const PieceOutline& outline, const Allowance& allowance);

/// The allowance of a stretch of the border: from a vertex on, the piece on the left, to another
/// one; all around where both are the same.
struct EdgeAllowance {
  Index from = 0, to = 0;    ///< vertex at which the stretch begins or ends
  double width = 0.0;        ///< millimetres; 0 for none, as along a fold
  bool is_fold = false;      ///< whether it is one
  bool is_hem = false;       ///< folded over at the edge's line, as Allowance::hems has it
  bool takes_darts = false;  ///< darts are folded toward it; its own allowance stays
};

/// Checks that the ends are on one loop of the border, which needs no pattern.
/// @param border loops of vertices
/// @throws Error misplaced_allowance naming the piece and the vertices
void check_edge_allowances(std::span<const std::vector<Index>> border,
                           std::span<const EdgeAllowance> edges, std::string_view piece);

/// A straight stretch of the border along which the material is folded: half of the piece is drawn.
struct FoldLine {
  Index from = 0, to = 0;  ///< vertices at its ends, in either order
  bool opened = false;     ///< the whole piece is drawn, with the line inside
};

/// Checks that the ends are on one loop of the border, which needs no pattern.
/// @throws Error misplaced_allowance naming the piece and the vertices
void check_fold(std::span<const std::vector<Index>> border, const FoldLine& fold,
                std::string_view piece);

/// The stretch between the ends of a fold that is straight in the pattern, without an allowance.
/// @param outline with vertices
/// @throws Error as check_fold(); misplaced_allowance where a point of either stretch is farther
///   from the line than 0.5 mm and a thousandth of its length
EdgeAllowance fold_stretch(const PieceOutline& outline, const FoldLine& fold);

/// What is asked for an edge of the outline, from corner to corner.
struct PatternEdge {
  int number = 0;                        ///< as edges_between_corners() has them, from 1
  std::string name = {};                 ///< as "hem"; empty: none but its number
  std::optional<double> allowance = {};  ///< millimetres; none: that of the piece
  bool is_hem = false;                   ///< its allowance is folded over at its line
  bool takes_darts = false;              ///< darts are folded toward it
  /// Its allowance ends at either end as the mirror image of what is beside it there, so that it
  /// lies on the piece when the seam is pressed open.
  bool mirrors_ends = false;
  bool clockwise = false;  ///< the outline is the mirror image of the one that has the number

  /// For people: its name, else as "edge 2".
  std::string words() const { return name.empty() ? "edge " + std::to_string(number) : name; }
};

/// The allowances that edges ask for, by vertices.
/// @param outline with vertices
/// @param usual width of the piece's allowance, millimetres
/// @throws Error misplaced_allowance for a number that no edge has
std::vector<EdgeAllowance> allowances_of_edges(const PieceOutline& outline,
                                               std::span<const PatternEdge> edges, double usual);

/// What each edge of the outline is called: its name, or as "edge 2".
/// @param outline with vertices
std::vector<std::string> words_of_edges(const PieceOutline& outline,
                                        std::span<const PatternEdge> edges);

/// The allowance with other widths along stretches; where they overlap, the last one counts.
/// @param outline with vertices
/// @throws Error as check_edge_allowances()
Allowance with_edge_allowances(Allowance allowance, const PieceOutline& outline,
                               std::span<const EdgeAllowance> edges);

}  // namespace planish
