#pragma once

#include <memory>
#include <vector>

#include <planish/unfold/strain.h>

#include "panels/division.h"
#include "panels/piece/laid_flat.h"

namespace planish {

/// A piece of a product and its pattern.
struct FlatPiece {
  std::vector<Index> triangles;  ///< of the net's mesh, increasing
  double area = 0.0;             ///< of that of the product
  bool has_pattern = false;
  bool overlaps = false;
  bool changes = false;  ///< it misses the limits, but not by more than FinishOptions::beyond
  EdgeStrain strain = {};

  bool keeps(const StrainLimits& limits) const {
    return has_pattern && !overlaps && (changes || limits.kept_by(strain));
  }
};

/// A division of a product itself.
struct FinishedDivision {
  std::shared_ptr<const SeamNet> net;
  OpenEdges open;
  std::vector<FlatPiece> pieces;
  bool is_valid = false;  ///< each piece keeps the limit and lies nowhere over itself
  double cost = 0.0;      ///< SeamState::cost()
  std::size_t tips = 0;
};

struct FinishOptions {
  PieceLimits limits = {};  ///< of each pattern
  bool match_seams = true;  ///< both sides of each seam get the mean of their lengths in patterns
  SeamPrices prices = {};
  double rms = 0.02;    ///< that a pattern within the limits has at most, about
  double beyond = 1.0;  ///< times the limits: what pieces keep at least, as they can change
};

/// Carries a division over to the product, lays every piece flat, and opens closed runs: where the
/// limit is not kept from their ends (unzip()), where a piece laps one that divides it
/// (dividing_run()).
/// @throws Cancelled
FinishedDivision finished(const Patch& product, const Division& division,
                          const FinishOptions& options, ThreadPool& pool);

/// The same of a division that is its own mirror image: all is done on the half of the product and
/// mirrored, and what is found is carried over to the product.
/// @param half as symmetric_mesh() makes it, on the side that the half of the division is on
/// @throws Cancelled
FinishedDivision finished_mirrored(const Patch& product, const Patch& half,
                                   const Division& division, const FinishOptions& options,
                                   ThreadPool& pool);

}  // namespace planish
