#include "panels/finish.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "panels/carried_seams.h"
#include "panels/divided_piece.h"
#include "panels/folded_seams.h"
#include "panels/piece/laid_flat.h"
#include "panels/seams/unzip.h"

namespace planish {

namespace {

constexpr double k_least_piece = 0.01;  // of the area
constexpr double k_least_part = 0.002;  // of the area, where nothing else mends a piece
constexpr double k_step = 0.02;         // of the root of the area, by which runs are opened
constexpr double k_below = 0.995;       // of the limit that is aimed at
constexpr double k_as_they_are = 0.01;  // mean edges that seams on a product move at most
constexpr int k_rounds = 12;
constexpr int k_divisions = 8;  // in two of what nothing else mends

/// The largest figure of a pattern as a share of its limit.
double excess(const EdgeStrain& strain, const StrainLimits& limits) {
  double most = 0.0;
  for (const LimitCheck& check : check_limits(strain, limits))
    most = std::max(most, check.value / check.limit);
  return most;
}

class Finishing {
 public:
  Finishing(std::shared_ptr<const SeamNet> net, OpenEdges open, const StrainLimits& limits,
            const SeamPrices& prices, ThreadPool& pool)
      : net_(std::move(net)),
        state_(net_->mesh, std::move(open), pool),
        limits_(limits),
        prices_(prices),
        pool_(pool) {}

  FinishedDivision run() {
    lay_flat();
    for (int round = 0; round < k_rounds && open_more(); ++round)
      lay_flat();
    FinishedDivision result{net_, state_.open(), {}, true, state_.cost(prices_), state_.tips()};
    for (std::size_t p = 0; p < flat_.size(); ++p) {
      if (state_.pieces()[p].triangles.empty()) continue;
      result.is_valid = result.is_valid && flat_[p].keeps(limits_);
      result.pieces.push_back(std::move(flat_[p]));
    }
    return result;
  }

 private:
  /// Pieces that are new.
  void lay_flat() {
    const std::size_t first = flat_.size(), count = state_.pieces().size() - first;
    flat_.resize(state_.pieces().size());
    lapping_.resize(state_.pieces().size());
    const auto is_image = [&](std::size_t p) {
      return !state_.pieces()[p].triangles.empty() && state_.is_image(p);
    };
    pool_.for_ranges(count, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = first + begin; i < first + end; ++i) {
        if (!is_image(i)) lay_flat(i);
      }
    });
    for (std::size_t p = first; p < flat_.size(); ++p) {
      if (!is_image(p)) continue;
      const std::vector<Index>& triangles = state_.pieces()[p].triangles;
      flat_[p] = flat_[state_.piece_of(net_->mesh.image_of_triangle(triangles.front()))];
      flat_[p].triangles = triangles;
    }
  }

  void lay_flat(std::size_t p) {
    const PanelPiece& piece = state_.pieces()[p];
    flat_[p] = {piece.triangles, piece.area, false, false, {}};
    if (piece.triangles.empty()) return;
    const PieceCorners corners(net_->mesh, state_.open(), piece.triangles);
    auto flat = laid_flat(net_->mesh, corners, limits_, {.threads = 1});
    if (!flat) return;
    flat_[p].has_pattern = true;
    flat_[p].overlaps = flat->pattern.overlaps;
    flat_[p].strain = flat->strain;
    if (flat_[p].overlaps) lapping_[p] = std::move(flat);
  }

  /// False where nothing can be done.
  bool open_more() {
    bool changed = false;
    const std::size_t count = flat_.size();
    for (std::size_t p = 0; p < count; ++p) {
      const PanelPiece& piece = state_.pieces()[p];
      if (piece.triangles.empty() || flat_[p].keeps(limits_) || state_.is_image(p)) continue;
      // What laps is smaller once it is divided, and may keep the limit then.
      if (flat_[p].overlaps || !flat_[p].has_pattern) {
        changed = divide(p) || changed;
        continue;
      }
      const double aim = piece.strain() * k_below / excess(flat_[p].strain, limits_);
      const std::size_t before = state_.pieces().size();
      unzip(state_, net_->chains, p, aim, k_step);
      changed = changed || state_.pieces().size() > before;
    }
    return changed;
  }

  bool divide(std::size_t p) {
    const std::vector<Index> run =
        dividing_run(state_, net_->chains, p, prices_.piece, lapping_[p]);
    lapping_[p].reset();
    if (run.empty()) return false;
    const SeamRun opened = state_.run_of(run);
    state_.open(opened, state_.opened_pieces(opened));
    return true;
  }

  std::shared_ptr<const SeamNet> net_;
  SeamState state_;
  StrainLimits limits_;
  SeamPrices prices_;
  ThreadPool& pool_;
  std::vector<FlatPiece> flat_;  // by piece of the state
  std::vector<std::optional<LaidFlat>>
      lapping_;  // patterns of those that do, by piece of the state
};

/// What a mirrored product keeps, so that the product, which may differ a little, does as well.
StrainLimits a_little_below(StrainLimits limits) {
  constexpr double k_share = 0.998;
  for (double* limit : {&limits.rms, &limits.p99, &limits.p99_stretch, &limits.p99_compression,
                        &limits.max, &limits.max_stretch, &limits.max_compression})
    *limit *= k_share;
  return limits;
}

FinishedDivision finished(CarriedSeams carried, const StrainLimits& limits,
                          const SeamPrices& prices, ThreadPool& pool) {
  for (int round = 0;; ++round) {
    const auto net = std::make_shared<const SeamNet>(std::move(carried.net));
    FinishedDivision result = Finishing(net, std::move(carried.open), limits, prices, pool).run();
    if (result.is_valid || round == k_divisions) return result;
    std::vector<std::vector<Index>> bad;
    for (const FlatPiece& piece : result.pieces) {
      if (!piece.keeps(limits)) bad.push_back(piece.triangles);
    }
    carried = net->mesh.is_mirrored()
                  ? with_mirrored_pieces_divided(*net, result.open, bad, k_least_part, pool)
                  : with_pieces_divided(*net, result.open, bad, k_least_part, pool);
  }
}

double largest_strain(const SeamState& state) {
  double largest = 0.0;
  for (const PanelPiece& piece : state.pieces())
    largest = std::max(largest, piece.strain());
  return largest;
}

/// The fairest seams that leave the strain about what it is on the thinned product.
/// @param carry lays them on the product, given how far they may move
template <class Carry>
CarriedSeams fair_seams(const Division& division, ThreadPool& pool, const Carry& carry) {
  constexpr double k_more = 1.03;  // of the largest strain
  const double most = k_more * largest_strain(division.state);
  for (const SeamMoves& moves :
       {SeamMoves{.tight = 12.0, .rounds = 4}, SeamMoves{.tight = 6.0, .rounds = 2},
        SeamMoves{.tight = 4.0, .rounds = 1}}) {
    CarriedSeams carried = carry(moves);
    if (largest_strain(SeamState(carried.net.mesh, carried.open, pool)) <= most) return carried;
  }
  return carry(SeamMoves{});
}

}  // namespace

FinishedDivision finished(const Patch& product, const Division& division,
                          const StrainLimits& limits, const SeamPrices& prices, ThreadPool& pool) {
  CarriedSeams carried = fair_seams(division, pool, [&](const SeamMoves& moves) {
    return carried_seams(product, *division.net, division.state.open(), k_least_piece, moves);
  });
  return finished(std::move(carried), limits, prices, pool);
}

FinishedDivision finished_mirrored(const Patch& product, const Patch& half,
                                   const Division& division, const StrainLimits& limits,
                                   const SeamPrices& prices, ThreadPool& pool) {
  const OpenEdges& open = division.state.open();
  CarriedSeams on_half = fair_seams(division, pool, [&](const SeamMoves& moves) {
    return carried_mirrored_seams(half, *division.net, open, k_least_piece, moves);
  });
  const FinishedDivision mirrored =
      finished(std::move(on_half), a_little_below(limits), prices, pool);
  CarriedSeams carried = carried_seams(product, *mirrored.net, mirrored.open, k_least_part,
                                       {.straightened = k_as_they_are});
  return finished(std::move(carried), limits, prices, pool);
}

}  // namespace planish
