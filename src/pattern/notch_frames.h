#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <planish/pattern/allowance.h>
#include <planish/pattern/notches.h>

#include "pattern/polygon/border_walk.h"

namespace planish {

/// The stretch of the border that a place belongs to, where it is a corner.
enum class SeatSide { both, before, after };

/// A place of the seam, by its loop and the way along it.
struct NotchSeat {
  std::size_t loop = 0;
  double way = 0.0;
  SeatSide side = SeatSide::both;
};

/// How a notch stands at its place.
struct NotchFrame {
  Vec2 seam;             ///< the place on the seam
  Vec2 along;            ///< the direction of the seam, length 1
  Vec2 inward;           ///< at right angles, to the left
  double reach = 0.0;    ///< from the seam out to where the notch begins
  bool on_seam = false;  ///< no cut line runs beside the place: the notch ends on the seam line
};

/// Finds how notches stand. A notch belongs to the cut line beside its own place: the ray from
/// there, at right angles to the seam, meets it within 2.5 allowances, crosses no other part of the
/// border on its way, and ends beside the same stretch of border. Where a corner has no such line
/// across the seam, that across the edge behind the corner counts, or half way between; where there
/// is none, as where the allowance fills a dart, the notch stands on the seam line.
class NotchFrames {
 public:
  /// @param cut what offset_outline() made of the outline with the allowance
  NotchFrames(const PieceOutline& outline, std::span<const Polygon> cut, const Allowance& allowance,
              const NotchSizes& sizes);

  /// Whether there is more to cut than the outline.
  bool has_allowance() const { return has_allowance_; }
  const BorderWalk& walk(std::size_t loop) const { return walks_[loop]; }
  NotchFrame at(const NotchSeat& seat) const;
  /// Two places as far apart as a double notch's: of the side of a corner, both on that side.
  std::vector<NotchSeat> pair_around(const NotchSeat& place) const;

 private:
  /// Corners beside a way, the nearest ones; no farther than once around.
  struct Between {
    double before, after;
  };
  struct Corner {
    double way = 0.0;
    std::size_t point = 0;
  };

  std::optional<Corner> corner_at(const NotchSeat& seat) const;
  Between between_corners(std::size_t loop, double way) const;
  double width_at(std::size_t loop, std::size_t edge) const;
  double widest_near(const NotchSeat& seat) const;
  NotchFrame across(const NotchSeat& seat, double back, double ahead) const;
  NotchFrame halving(const NotchSeat& seat) const;
  bool is_beside(const NotchSeat& seat, Vec2 hit, double most) const;
  bool leaves_freely(const NotchFrame& frame, double reach, double jag) const;
  std::optional<NotchFrame> met(const NotchSeat& seat, NotchFrame frame, double width,
                                bool runs_beside_line) const;
  std::optional<NotchFrame> along_bare_edge(const NotchSeat& seat, Vec2 inward, Vec2 other,
                                            double width) const;
  std::optional<NotchFrame> at_end_of_fold(const NotchSeat& seat) const;
  NotchSeat beside_bare_edge(NotchSeat seat) const;
  NotchFrame at_corner(const NotchSeat& seat, const Corner& corner) const;
  NotchFrame standing_on_seam(NotchFrame frame) const;

  const PieceOutline& outline_;
  std::span<const Polygon> cut_;
  const Allowance& allowance_;
  NotchSizes sizes_;
  bool has_allowance_;
  std::vector<BorderWalk> walks_;
  std::vector<std::vector<Corner>> corners_;  // of each loop, in order
};

}  // namespace planish
