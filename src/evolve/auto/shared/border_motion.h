#pragma once

#include <span>
#include <vector>

#include <planish/evolve/method.h>

#include "energy/line_bending.h"
#include "evolve/state/patch_state.h"
#include "evolve/systems/positions.h"

namespace planish {

/// Where the vertices of a border may go: one direction each where they slide along it, three where
/// they move within a distance, none where they stay. Vertices are numbered as in the state, so
/// inner ones first; what says "positions" has one for each vertex that may move at all:
/// vertex_count() of them.
class BorderMotion {
 public:
  /// Takes the border from the state's origins.
  /// @param freedom its distance in the units of the state
  /// @param most_deviation of any vertex, in these units
  /// @param state must outlive it
  BorderMotion(const BorderFreedom& freedom, double most_deviation, const PatchState& state);

  /// Inner vertices, and those of the border where they move.
  std::size_t vertex_count() const { return state_.inner_count() + marks_.size(); }
  /// By vertex of the border whether it may move: not what is fixed, nor corners where it slides;
  /// empty where the border stays.
  std::span<const unsigned char> movable() const { return marks_; }

  /// How many directions each vertex of the border has.
  int direction_count() const;
  /// They are of unit length and at right angles; of the patch as it is.
  /// @param v of the border
  Vec3 direction(Index v, int which) const;

  /// Puts the positions of the border where they may be: the nearest ones, but for the order along
  /// it.
  void restrict(Positions& positions) const;
  /// Vertices that went as far as the distance allows, nearly.
  std::vector<Index> at_limit() const;

  /// One for each vertex of the border where it moves, but for those between two at its own place.
  std::vector<SecondDifference> bends() const;

 private:
  /// A closed curve; its vertices have numbers from `first` on.
  struct Loop {
    Index first;
    std::vector<double> gaps;  // from each vertex to the next
    double length;

    std::size_t size() const { return gaps.size(); }
  };
  Index vertex_of(const Loop& loop, std::size_t i) const {
    return loop.first + static_cast<Index>(i % loop.size());
  }
  Vec3 origin_of(const Loop& loop, std::size_t i) const {
    return state_.origin(vertex_of(loop, i));
  }
  bool is_corner(const Loop& loop, std::size_t i) const;
  const Loop& loop_of(Index v) const;
  double slid_to(const Loop& loop, std::size_t i, Vec3 place) const;
  Vec3 place_at(const Loop& loop, std::size_t i, double slide) const;
  void restrict_slides(const Loop& loop, Positions& positions) const;

  BorderFreedom::Rule rule_;
  double reach_;  // how far a vertex may go from where it was, in the units of the state
  const PatchState& state_;
  std::vector<Loop> loops_;           // none where the border stays
  std::vector<unsigned char> marks_;  // see movable()
};

}  // namespace planish
