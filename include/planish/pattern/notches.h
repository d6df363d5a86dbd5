#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <planish/mesh/seams.h>
#include <planish/pattern/allowance.h>
#include <planish/pattern/piece_outline.h>

namespace planish {

/// The form of a notch: one line, two that meet, or one with a bar.
enum class NotchKind { slit, v, t };
/// "slit", "v" or "t".
std::string_view to_string(NotchKind kind);

/// A mark in the edge that tells which places of two pieces are sewn together.
struct Notch {
  std::optional<std::array<Index, 2>> edge = {};  ///< ends of that it is on; twice the same: there
  double fraction = 0.0;             ///< of the edge's length or, without, of the outer border's
  NotchKind kind = NotchKind::slit;  ///< its form
  bool is_double = false;            ///< two side by side, NotchSizes::spacing apart

  /// At a vertex of the border.
  static Notch at_vertex(Index vertex, NotchKind kind = NotchKind::slit, bool is_double = false) {
    return {{{vertex, vertex}}, 0.0, kind, is_double};
  }
  /// @param fraction of the outer border's length in the pattern, 0 to 1, from its vertex of the
  ///   smallest number on, counter-clockwise
  static Notch at_fraction(double fraction, NotchKind kind = NotchKind::slit,
                           bool is_double = false) {
    return {{}, fraction, kind, is_double};
  }
  /// On an edge of the border, which may run either way.
  /// @param fraction of its length, 0 to 1, from `from`
  static Notch on_edge(Index from, Index to, double fraction, NotchKind kind = NotchKind::slit,
                       bool is_double = false) {
    return {{{from, to}}, fraction, kind, is_double};
  }

  /// The vertex that it is at; none where a fraction of the border gives its place.
  std::optional<Index> vertex() const {
    return edge && edge->front() == edge->back() ? std::optional(edge->front()) : std::nullopt;
  }
};

/// Millimetres.
struct NotchSizes {
  double depth = 5.0;    ///< from the line that is cut towards the seam
  double width = 4.0;    ///< of a V at the edge, of a T's bar
  double spacing = 6.0;  ///< of a double notch's two, along the seam
};

/// Checks that places are on the border, which needs no pattern.
/// @param border loops of vertices
/// @throws Error misplaced_notch naming the piece and the place
void check_notches(std::span<const std::vector<Index>> border, std::span<const Notch> notches,
                   std::string_view piece);

/// A notch where it is cut. A double one is two of them.
struct PlacedNotch {
  NotchKind kind = NotchKind::slit;  ///< its form
  Vec2 at;                           ///< where it begins, on the line that is cut; millimetres
  Vec2 inward;                       ///< its direction, at right angles to the seam; length 1
  double depth = 0.0;                ///< millimetres
  double width = 0.0;                ///< of a V at the edge, of a T's bar; 0 of a slit; millimetres
  /// No cut line runs beside the place, as the allowance fills a dart there: the notch is drawn in
  /// what fills it, up to the seam line, and `at` is its outer end.
  bool on_seam = false;
  std::vector<Polygon> strokes = {};  ///< as open lines; a T has a second one, its bar
};

/// Notches begin at the line that is cut and run at right angles to the seam towards it. They
/// belong to the cut line beside their own place, at most 2.5 allowances away; where there is none
/// they stand on the seam line (PlacedNotch::on_seam). At a corner a place on an edge belongs to
/// that edge: its notch is across it where that meets its own cut line, else across the edge behind
/// the corner, so that both sides of a seam have theirs at the same way from its end. A vertex at a
/// corner has its notch half way between, or beside an edge without an allowance across the other
/// one. Notches that come to the same place are one.
/// @param cut what offset_outline() made of the outline, or the outline's own loops
/// @param outline with vertices where notches name any
/// @param allowance of the cut line; where that is the outline itself, edges of width 0 are folds
/// @throws Error option_out_of_range for sizes that are not above 0; misplaced_notch for places off
///   the border and for notches that reach through the seam, or where there is no allowance to
///   where the piece is not
std::vector<PlacedNotch> place_notches(const PieceOutline& outline, std::span<const Polygon> cut,
                                       std::span<const Notch> notches, const NotchSizes& sizes = {},
                                       const Allowance& allowance = {});

/// A notch on both sides of a seam.
struct SeamNotch {
  std::optional<std::size_t> seam = {};  ///< counted from 0; none: every seam
  double place = 0.5;                    ///< along the first side of the seam from its first vertex
  bool in_millimetres = false;           ///< the place; else it is a share of the length, 0 to 1
  NotchKind kind = NotchKind::slit;      ///< its form, on both sides
  bool is_double = false;                ///< two side by side, on both sides
};

/// Slits at places of the model, each on the seam whose first side is nearest to it.
/// @param places model units
/// @param patches whose seams they are
/// @throws Error misplaced_notch for a place that is farther from all seams than three of the mean
///   edges of the nearest one
std::vector<SeamNotch> seam_notches_at(std::span<const Vec3> places, std::span<const Seam> seams,
                                       std::span<const TriMesh> patches);

/// The notches of every patch that those of the seams come to. The two of a pair are at one place
/// of the model: on the same edge at the same share of it; of sides matched as curves, at
/// matched_share(). In patterns whose seams match they are at the same length from the end of the
/// seam, but for the difference that such sides have on the model.
/// @param patches whose seams they are; lengths are measured on them
/// @param names of the patches, for messages
/// @param unit millimetres in a model unit
/// @throws Error misplaced_notch for seams that there are not and places beyond a seam's length
std::vector<std::vector<Notch>> notches_of_patches(std::span<const SeamNotch> notches,
                                                   std::span<const Seam> seams,
                                                   std::span<const TriMesh> patches,
                                                   std::span<const std::string> names, double unit);

}  // namespace planish
