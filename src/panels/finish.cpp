#include "panels/finish.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "panels/carried_seams.h"
#include "panels/divided_piece.h"
#include "panels/folded_seams.h"
#include "panels/joined_pieces.h"
#include "panels/piece/laid_flat.h"
#include "panels/seams/flat_zip.h"
#include "panels/seams/unzip.h"
#include "unfold/common_length.h"

namespace planish {

namespace {

constexpr double k_least_part = 0.002;  // of the area
constexpr double k_step = 0.02;         // of the root of the area, by which runs are opened
constexpr double k_below = 0.995;       // of the limit that is aimed at
constexpr double k_as_they_are = 0.01;  // mean edges that seams on a product move at most
constexpr int k_rounds = 20;
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
  Finishing(std::shared_ptr<const SeamNet> net, OpenEdges open, const FinishOptions& options,
            ThreadPool& pool)
      : net_(std::move(net)),
        state_(net_->mesh, std::move(open), pool),
        options_(options),
        pool_(pool) {}

  FinishedDivision run() {
    lay_flat();
    for (int round = 0; round < k_rounds; ++round) {
      if (open_more())
        lay_flat();
      else if (!options_.match_seams || !all_keep() || !match_seams())
        break;
    }
    const SeamPrices& prices = options_.prices;
    FinishedDivision result{net_, state_.open(), {}, true, state_.cost(prices), state_.tips()};
    for (std::size_t p = 0; p < laid_.size(); ++p) {
      if (state_.pieces()[p].triangles.empty()) continue;
      result.is_valid = result.is_valid && keeps(laid_[p]);
      result.pieces.push_back(std::move(laid_[p].flat));
    }
    return result;
  }

 private:
  /// A piece and its pattern.
  struct Laid {
    FlatPiece flat;
    std::vector<FlatSide> sides = {};    ///< as they are if seams need not match
    std::vector<EdgeLength> seams = {};  ///< that the pattern was given
    std::optional<LaidFlat> lapping = {};
  };

  bool keeps(const Laid& piece) const { return piece.flat.keeps(options_.limits.strain); }

  /// What misses the limits already misses them with less freedom too.
  bool all_keep() const {
    return std::all_of(laid_.begin(), laid_.end(), [&](const Laid& piece) {
      return piece.flat.triangles.empty() || keeps(piece);
    });
  }

  bool is_image(std::size_t p) const {
    return !state_.pieces()[p].triangles.empty() && state_.is_image(p);
  }

  /// Does it for pieces of which none is the image of another; images get what those have.
  template <class Work>
  void for_pieces(std::size_t first, Work work) {
    pool_.for_ranges(laid_.size() - first, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t p = first + begin; p < first + end; ++p) {
        if (!is_image(p)) work(p);
      }
    });
    for (std::size_t p = first; p < laid_.size(); ++p) {
      if (!is_image(p)) continue;
      const std::vector<Index>& triangles = state_.pieces()[p].triangles;
      laid_[p].flat = laid_[state_.piece_of(net_->mesh.image_of_triangle(triangles.front()))].flat;
      laid_[p].flat.triangles = triangles;
    }
  }

  /// Pieces that are new.
  void lay_flat() {
    const std::size_t first = laid_.size();
    laid_.resize(state_.pieces().size());
    for_pieces(first, [&](std::size_t p) { laid_[p] = laid(state_.pieces()[p], {}); });
  }

  Laid laid(const PanelPiece& piece, std::vector<EdgeLength> seams) const {
    Laid result{{.triangles = piece.triangles, .area = piece.area}, {}, std::move(seams)};
    if (piece.triangles.empty()) return result;
    const PieceCorners corners(net_->mesh, state_.open(), piece.triangles);
    auto flat = laid_flat(net_->mesh, corners, options_.limits, {.threads = 1}, result.seams);
    if (!flat) return result;
    result.flat.has_pattern = true;
    result.flat.overlaps = flat->pattern.overlaps;
    result.flat.strain = flat->strain;
    const double over = excess(flat->strain, options_.limits.strain);
    result.flat.changes = over > 1.0 && over <= options_.beyond;
    result.sides = seam_sides(net_->mesh, state_.open(), corners, piece.triangles, flat->pattern);
    if (result.flat.overlaps) result.lapping = std::move(flat);
    return result;
  }

  /// By edge of the mesh: common_length() of what its sides have in patterns.
  std::vector<double> common_lengths() const {
    std::vector<double> sums(net_->mesh.edges().size(), 0.0);
    std::vector<int> sides(sums.size(), 0);
    for (std::size_t p = 0; p < laid_.size(); ++p) {
      if (state_.pieces()[p].triangles.empty()) continue;
      for (const FlatSide& side : laid_[p].sides) {
        std::array<Index, 2> edges = {side.edge, side.edge};
        if (net_->mesh.is_mirrored()) edges[1] = net_->mesh.image_of_edge(side.edge);
        for (const Index e : edges) {
          sums[e] += side.length;
          ++sides[e];
        }
      }
    }
    for (std::size_t e = 0; e < sums.size(); ++e) {
      if (sides[e] > 0)
        sums[e] =
            common_length(sums[e] / sides[e], net_->mesh.edges()[e].length / net_->mesh.scale());
    }
    return sums;
  }

  /// Lays pieces flat whose seams do not match.
  /// @return whether there were any
  bool match_seams() {
    const std::vector<double> lengths = common_lengths();
    bool changed = false;
    std::vector<std::vector<EdgeLength>> seams(laid_.size());
    for (std::size_t p = 0; p < laid_.size(); ++p) {
      for (const FlatSide& side : laid_[p].sides)
        seams[p].push_back({side.ends, lengths[side.edge]});
      changed = changed || seams[p] != laid_[p].seams;
    }
    for_pieces(0, [&](std::size_t p) {
      if (state_.pieces()[p].triangles.empty() || seams[p] == laid_[p].seams) return;
      std::vector<FlatSide> sides = std::move(laid_[p].sides);
      laid_[p] = laid(state_.pieces()[p], std::move(seams[p]));
      laid_[p].sides = std::move(sides);
    });
    return changed;
  }

  /// False where nothing can be done.
  bool open_more() {
    bool changed = false;
    const std::size_t count = laid_.size();
    for (std::size_t p = 0; p < count; ++p) {
      const PanelPiece& piece = state_.pieces()[p];
      if (piece.triangles.empty() || keeps(laid_[p]) || state_.is_image(p)) continue;
      // What laps is smaller once it is divided, and may keep the limit then.
      const FlatPiece& flat = laid_[p].flat;
      if (flat.overlaps || !flat.has_pattern) {
        changed = divide(p) || changed;
        continue;
      }
      const double over = excess(flat.strain, options_.limits.strain) / options_.beyond;
      const double aim = piece.strain() * k_below / over;
      const std::size_t before = state_.pieces().size();
      unzip(state_, net_->chains, p, aim, k_step);
      changed = changed || state_.pieces().size() > before;
    }
    return changed;
  }

  bool divide(std::size_t p) {
    const std::vector<Index> run =
        dividing_run(state_, net_->chains, p, options_.prices.piece, laid_[p].lapping);
    laid_[p].lapping.reset();
    if (run.empty()) return false;
    const SeamRun opened = state_.run_of(run);
    state_.open(opened, state_.opened_pieces(opened));
    return true;
  }

  std::shared_ptr<const SeamNet> net_;
  SeamState state_;
  const FinishOptions& options_;
  ThreadPool& pool_;
  std::vector<Laid> laid_;  // by piece of the state
};

/// What a mirrored product keeps, so that the product, which may differ a little, does as well.
FinishOptions a_little_below(FinishOptions options) {
  constexpr double k_share = 0.998;
  StrainLimits& limits = options.limits.strain;
  for (double* limit : {&limits.rms, &limits.p99, &limits.p99_stretch, &limits.p99_compression,
                        &limits.max, &limits.max_stretch, &limits.max_compression})
    *limit *= k_share;
  return options;
}

FinishedDivision finished(CarriedSeams carried, const FinishOptions& options, ThreadPool& pool) {
  for (int round = 0;; ++round) {
    const auto net = std::make_shared<const SeamNet>(std::move(carried.net));
    FinishedDivision result = Finishing(net, std::move(carried.open), options, pool).run();
    // Dividing comes first: it mends most pieces with a shorter seam than making room for them.
    if (!result.is_valid && round > 0) {
      OpenEdges joined = with_strained_pieces_joined(result, options, pool);
      result = Finishing(net, std::move(joined), options, pool).run();
    }
    if (result.is_valid || round == k_divisions) return result;
    std::vector<std::vector<Index>> bad;
    for (const FlatPiece& piece : result.pieces) {
      if (!piece.keeps(options.limits.strain)) bad.push_back(piece.triangles);
    }
    carried = net->mesh.is_mirrored()
                  ? with_mirrored_pieces_divided(*net, result.open, bad, k_least_part, pool)
                  : with_pieces_divided(*net, result.open, bad, k_least_part, pool);
  }
}

/// How much pieces strain.
struct Strains {
  double whole = 0.0;    ///< rms of the edges of all, by area
  double largest = 0.0;  ///< of a piece

  explicit Strains(const SeamState& state) {
    double energy = 0.0;
    for (const PanelPiece& piece : state.pieces()) {
      energy += piece.energy;
      largest = std::max(largest, piece.strain());
    }
    whole = std::sqrt(energy);
  }
};

/// The fairest seams that leave the strain about what it is on the thinned product.
/// @param carry lays them on the product, given how far they may move
template <class Carry>
CarriedSeams fair_seams(const Division& division, ThreadPool& pool, const Carry& carry) {
  constexpr double k_more = 1.03, k_more_at_last = 1.2;  // of the strain
  const Strains thin(division.state);
  for (const SeamMoves& moves :
       {SeamMoves{.tight = 12.0, .rounds = 4}, SeamMoves{.tight = 6.0, .rounds = 2},
        SeamMoves{.tight = 4.0, .rounds = 1}, SeamMoves{}, SeamMoves{.straightened = 0.2}}) {
    CarriedSeams carried = carry(moves);
    const Strains strains(SeamState(carried.net.mesh, carried.open, pool));
    const double more = moves.rounds > 0 ? k_more : k_more_at_last;
    if (strains.whole <= more * thin.whole && strains.largest <= more * thin.largest)
      return carried;
  }
  return carry(SeamMoves{.straightened = 0.0});
}

}  // namespace

FinishedDivision finished(const Patch& product, const Division& division,
                          const FinishOptions& options, ThreadPool& pool) {
  CarriedSeams carried = fair_seams(division, pool, [&](const SeamMoves& moves) {
    return carried_seams(product, *division.net, division.state.open(), k_least_part, moves);
  });
  return finished(std::move(carried), options, pool);
}

FinishedDivision finished_mirrored(const Patch& product, const Patch& half,
                                   const Division& division, const FinishOptions& options,
                                   ThreadPool& pool) {
  const OpenEdges& open = division.state.open();
  CarriedSeams on_half = fair_seams(division, pool, [&](const SeamMoves& moves) {
    return carried_mirrored_seams(half, *division.net, open, k_least_part, moves);
  });
  const FinishedDivision mirrored = finished(std::move(on_half), a_little_below(options), pool);
  CarriedSeams carried = carried_seams(product, *mirrored.net, mirrored.open, k_least_part,
                                       {.straightened = k_as_they_are});
  return finished(std::move(carried), options, pool);
}

}  // namespace planish
