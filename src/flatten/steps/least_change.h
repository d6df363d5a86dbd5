#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include <planish/flatten/flatten.h>

namespace planish {

/// Seeks the amount from which on something holds, or up to which it does, in few trials: each goes
/// to where a straight line through what is known crosses the bound.
class BoundarySearch {
 public:
  /// @param excess_of_none of what is bounded over its bound, where the amount is 0
  /// @param first,most amounts to try, above 0
  BoundarySearch(double excess_of_none, double first, double most, int trials);

  /// The amount to try next. None where a trial would bring little, or all were made.
  std::optional<double> next() const;
  /// What the trial came to.
  /// @param excess at most 1 where it holds
  void tell(double amount, double excess);

 private:
  struct Sample {
    double amount, excess;
    bool holds() const { return excess <= 1.0; }
  };
  std::optional<double> crossing_of(const Sample& a, const Sample& b) const;
  std::optional<double> between() const;

  Sample none_, near_;         // near_: the last on the side of none_
  std::optional<Sample> far_;  // the last on the other side
  Sample before_last_, last_;
  double first_, most_;
  int trials_left_;
};

/// A surface with its pattern.
struct EvolvedPattern {
  EvolveReport evolve;
  UnfoldReport unfold;
};

/// How many surfaces a search tries.
struct SearchEffort {
  int runs = 3;            ///< of a method that ends by its estimate of the strain, until that fits
  int trials = 4;          ///< for a boundary
  int first_halvings = 3;  ///< of the way back, of each trial
  int last_halvings = 8;   ///< of the nearest trial, the first ones among them
  int halvings = 6;        ///< of the way back of other surfaces
};

/// What a search runs.
struct SurfaceRuns {
  /// Evolves the design within limits: as of Auto, by its estimate of the strain.
  std::function<EvolveReport(const StrainLimits& limits, double max_deviation)> evolved;
  /// Lays a surface flat as was asked for, and with least stretch.
  std::function<UnfoldReport(const Patch&surface)> unfolded, stretched_least;
  /// Whether a surface is as smooth as was asked for.
  std::function<bool(const std::vector<Vec3>& positions)> is_form_good;
  double bending = 0.0;  ///< design_bending() of the design
  /// Whether a place on the straight way between two surfaces may be a result.
  bool may_be_between = true;
  SearchEffort effort = {};
};

/// The strain of the pattern of least stretch.
const EdgeStrain& least_strain(const UnfoldReport& report);

/// By how much strain is to be multiplied to be at its limit; below 1 where a limit is not kept.
double headroom(const std::vector<LimitCheck>& checks);

/// Positions a share of the way.
std::vector<Vec3> part_way(const std::vector<Vec3>& from, const std::vector<Vec3>& to,
                           double share);

/// Where the pattern keeps the limits, finds by bisection a small share of the move from the design
/// with which a pattern still keeps them, and does not overlap itself where it need not. A surface
/// that bends as was asked for stays so: half way to it there may be more folds. Only positions and
/// pattern follow, not the other figures.
/// @return the share; 1 where it stayed
double go_back(const Patch& design, EvolvedPattern& found, const SurfaceRuns& runs);

/// The nearest surface found of which a pattern keeps the limits: the search is for the largest
/// strain of the surface with which the pattern does (docs/methods/least_change.md). Its figures
/// are those of before going back.
/// @param as_designed of the design, which misses them
/// @param design_strain least_strain() of the design, rms
/// @param first_gone the share of it that the first trial is to take out; none: as if all strain
///   fell alike
/// @return none where no pattern kept them
std::optional<EvolvedPattern> least_change(const Patch& design, const UnfoldReport& as_designed,
                                           double design_strain, const SurfaceRuns& runs,
                                           std::optional<double> first_gone = {});

/// How far a surface may go from its design.
struct Tolerance {
  double distance = 0.0;  ///< of a vertex, model units; above 0

  /// The new fold in degrees and the added bending that a surface within a tolerance has at most.
  static constexpr double most_new_fold = 5.0, most_added = 0.05;

  /// What a surface has of what it may have, as shares.
  struct Use {
    double distance = 0.0, form = 0.0;
    double most() const { return std::max(distance, form); }
  };
  /// @param bending design_bending() of the design
  Use use(const Patch& design, double bending, const std::vector<Vec3>& after) const;
};

/// Takes noise out within a tolerance: waves shorter than a length, those of the border too where
/// that may move.
/// @param wave as of ScanNoise
/// @param reach,border_reach how far inner vertices and those of the border may go, model units
SmoothedDesign smooth_within(const Patch& raw, double wave, double reach, double border_reach);

/// The surface found with the least strain of those within the tolerance: the search is for the
/// smallest strain of the surface with which it stays there. StopReason::strain_met where the
/// strain is too small to measure, deviation_limit, or smooth_limit where it would fold. Its
/// figures are those of before going back, its pattern the one of least stretch.
/// @param design_strain of the pattern of least stretch, rms
EvolvedPattern least_strain_within(const Patch& design, const Tolerance& tolerance,
                                   double design_strain, const SurfaceRuns& runs);

}  // namespace planish
