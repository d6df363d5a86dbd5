#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <numeric>
#include <set>
#include <string>
#include <utility>

#include <planish/core/error.h>
#include <planish/core/range.h>
#include <planish/pattern/nest.h>

#include "core/job.h"
#include "core/math.h"
#include "core/split_mix.h"
#include "pattern/nest/nest_shapes.h"
#include "pattern/nest/sheet_columns.h"

namespace planish {

namespace {

constexpr int k_most_copies = 10'000;
constexpr double k_nest_slack = 1e-7;  // millimetres that rounding may cost

/// Millimetres. Further away from the origin, coordinates have too few digits.
constexpr double k_furthest = 1e10;

void check_corners(const PieceOutline& outline) {
  for (const Polygon& loop : outline.loops) {
    for (const Vec2 p : loop) {
      if (!std::isfinite(p.x) || !std::isfinite(p.y))
        throw Error(ErrorCode::non_finite_coordinate,
                    "piece \"" + outline.piece + "\" has a corner whose place is no number");
      if (std::abs(p.x) > k_furthest || std::abs(p.y) > k_furthest)
        throw Error(ErrorCode::too_large,
                    "piece \"" + outline.piece +
                        "\" is more than 10,000 km away from the origin of its coordinates");
    }
  }
}

void check(std::span<const NestPiece> pieces, const NestOptions& options) {
  constexpr double least = std::numeric_limits<double>::min(), most = 1e7;
  check_range("sheet_width", options.width, {least, most});
  if (options.length) check_range("sheet_length", *options.length, {least, most});
  const double shorter = std::min(options.width, options.length.value_or(options.width));
  check_range("gap", options.gap, {0.0, most});
  check_range("margin", options.margin, {0.0, 0.5 * shorter});
  check_range("step", options.step, {0.0, most});
  check_range("tries", options.tries, {0.0, 1'000'000.0});
  double copies = 0.0;
  for (const NestPiece& piece : pieces) {
    check_range("quantity", piece.quantity, {0.0, 1'000'000.0});
    check_range("angle", piece.angle, {-1e6, 1e6});
    copies += piece.quantity;
    check_copies(copies);
    check_corners(piece.outline);
    const bool has_area = piece.quantity == 0 || (!piece.outline.loops.empty() &&
                                                  signed_area(piece.outline.loops.front()) != 0.0);
    if (has_area) continue;
    throw Error(ErrorCode::no_triangles,
                "piece \"" + piece.outline.piece + "\" has no area to be laid on a sheet");
  }
}

double area_of(const PieceOutline& outline) {
  double area = 0.0;
  for (const Polygon& loop : outline.loops)
    area += signed_area(loop);
  return std::abs(area);
}

/// Where a copy came to lie, in columns.
struct LaidCopy {
  std::size_t piece = 0, turn = 0, sheet = 0, column = 0;
  double lift = 0.0;
  double end = std::numeric_limits<double>::infinity();  ///< along the sheet, from its margin
};

/// All copies as one order has laid them.
struct LaidSheets {
  std::vector<LaidCopy> copies;
  std::size_t sheets = 0;
  double end = 0.0;  ///< on the last sheet, from its margin

  bool needs_less_than(const LaidSheets& other) const {
    if (sheets != other.sheets) return sheets < other.sheets;
    return end < other.end - k_nest_slack;
  }
};

/// The pieces in all their turns, which every order lays anew.
class NestEngine {
 public:
  NestEngine(std::span<const NestPiece> pieces, const NestOptions& options, double step)
      : step_(step),
        height_(width_of(options)),
        least_lift_(options.folded ? options.gap : 0.0),
        length_(options.length ? *options.length - 2.0 * options.margin + k_nest_slack
                               : std::numeric_limits<double>::infinity()) {
    shapes_.reserve(pieces.size());
    on_fold_.reserve(pieces.size());
    for (const NestPiece& piece : pieces) {
      on_fold_.push_back(piece.fold.has_value());
      shapes_.push_back(piece.quantity > 0 ? turned_pieces(piece, options, step_)
                                           : std::vector<TurnedPiece>{});
    }
  }

  const TurnedPiece& shape(const LaidCopy& copy) const { return shapes_[copy.piece][copy.turn]; }
  const std::vector<TurnedPiece>& turns(std::size_t piece) const { return shapes_[piece]; }
  double step() const { return step_; }

  /// Lays copies in an order, by the numbers of their pieces; nothing where that needs no less than
  /// what is best so far, which is as known before the last copy: what is begun stays begun.
  /// @param on_copy called before each with how many are laid
  std::optional<LaidSheets> lay(const std::vector<std::size_t>& order,
                                const std::optional<LaidSheets>& best,
                                const std::function<void(std::size_t)>& on_copy) const {
    LaidSheets laid;
    std::vector<OpenSheet> sheets;
    for (const std::size_t piece : order) {
      on_copy(laid.copies.size());
      LaidCopy copy;
      for (std::size_t s = 0; !std::isfinite(copy.end); ++s) {
        if (s == sheets.size()) sheets.push_back(open_sheet());
        copy = best_place(piece, s, sheets[s]);
      }
      const auto lies_last = copy.sheet + 1;
      if (lies_last > laid.sheets) laid.end = 0.0;
      laid.sheets = std::max(laid.sheets, lies_last);
      if (lies_last == laid.sheets) laid.end = std::max(laid.end, copy.end);
      sheets[copy.sheet].columns.take(shape(copy).grown, copy.column, copy.lift);
      laid.copies.push_back(copy);
      if (best && !laid.needs_less_than(*best)) return std::nullopt;
    }
    return laid;
  }

 private:
  struct OpenSheet {
    SheetColumns columns;
    /// For each piece and turn the columns from the first on where it is known to fit no more: what
    /// is taken stays taken.
    std::vector<std::vector<std::size_t>> full;
  };

  OpenSheet open_sheet() const {
    OpenSheet sheet{SheetColumns(height_), {}};
    sheet.full.reserve(shapes_.size());
    for (const auto& turns : shapes_)
      sheet.full.emplace_back(turns.size(), 0);
    return sheet;
  }

  /// The place that ends first along the sheet, of several the lowest one.
  LaidCopy best_place(std::size_t piece, std::size_t sheet, OpenSheet& open) const {
    LaidCopy best;
    for (std::size_t t = 0; t < shapes_[piece].size(); ++t) {
      const TurnedPiece& turn = shapes_[piece][t];
      const double highest =
          on_fold_[piece] ? 0.0 : std::max(0.0, height_ - turn.size.y + k_nest_slack);
      const Span lifts = {std::min(least_lift_, highest), highest};
      std::size_t& column = open.full[piece][t];
      for (;; ++column) {
        const double end = static_cast<double>(column) * step_ + turn.size.x;
        if (end > std::min(length_, best.end + k_nest_slack)) break;
        const auto lift = open.columns.lowest_place(turn.columns, column, lifts);
        if (!lift) continue;
        if (end < best.end - k_nest_slack || *lift < best.lift) {
          best = {piece, t, sheet, column, *lift, end};
        }
        break;
      }
    }
    return best;
  }

  double step_, height_;
  double least_lift_;  ///< a gap beside the fold of the cloth for what does not lie on it
  double length_;
  std::vector<std::vector<TurnedPiece>> shapes_;
  std::vector<bool> on_fold_;  ///< whether the piece lies on the edge at y = 0
};

using NestOrder = std::vector<std::size_t>;

/// The copies by some measure of their pieces, the largest first.
template <class Measure>
NestOrder order_by(std::span<const NestPiece> pieces, const Measure& measure) {
  std::vector<std::size_t> numbers(pieces.size());
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  std::vector<double> sizes;
  sizes.reserve(pieces.size());
  for (const std::size_t p : numbers)
    sizes.push_back(pieces[p].quantity > 0 ? measure(p) : 0.0);
  std::stable_sort(numbers.begin(), numbers.end(),
                   [&](std::size_t a, std::size_t b) { return sizes[a] > sizes[b]; });
  NestOrder order;
  for (const std::size_t p : numbers)
    order.insert(order.end(), static_cast<std::size_t>(pieces[p].quantity), p);
  return order;
}

/// The order of a try: first by several measures, then the best so far with some exchanged.
NestOrder order_of_try(int number, std::span<const NestPiece> pieces, const NestEngine& shop,
                       const NestOrder& best, SplitMix& dice) {
  const auto size = [&](std::size_t p) { return shop.turns(p).front().size; };
  switch (number) {
    case 0:
      return order_by(pieces, [&](std::size_t p) { return area_of(pieces[p].outline); });
    case 1:
      return order_by(pieces, [&](std::size_t p) { return size(p).x; });
    case 2:
      return order_by(pieces, [&](std::size_t p) { return size(p).y; });
    case 3:
      return order_by(pieces, [&](std::size_t p) { return size(p).x * size(p).y; });
    default:
      break;
  }
  NestOrder order = best;
  for (int k = 0; k < 3 && order.size() > 1; ++k)
    std::swap(order[dice.below(order.size())], order[dice.below(order.size())]);
  return order;
}

/// How many orders there are to be. Quarter turns find little more with more of them, and come
/// behind those by half and before free ones.
int tries_for(std::span<const NestPiece> pieces, const NestEngine& shop,
              const NestOptions& options) {
  if (options.tries > 0) return options.tries;
  std::size_t turned_copies = 1;
  for (std::size_t p = 0; p < pieces.size(); ++p)
    turned_copies += static_cast<std::size_t>(pieces[p].quantity) * shop.turns(p).size();
  const std::size_t most = options.turns == Turns::quarter ? 2'500 : 10'000;
  return static_cast<int>(std::clamp<std::size_t>(most / turned_copies, 4, 200));
}

LaidSheets best_of_tries(const NestEngine& shop, std::span<const NestPiece> pieces,
                         const NestOptions& options, const Context& context) {
  std::optional<LaidSheets> best;
  NestOrder best_order;
  std::set<NestOrder> known;
  SplitMix dice;
  const int tries = tries_for(pieces, shop, options);
  for (int number = 0; number < tries; ++number) {
    NestOrder order = order_of_try(number, pieces, shop, best_order, dice);
    if (order.empty()) break;
    if (!known.insert(order).second) continue;
    const auto on_copy = [&](std::size_t laid) {
      const double share = static_cast<double>(laid) / static_cast<double>(order.size());
      report_progress(context, {"nesting", (number + share) / tries});
    };
    std::optional<LaidSheets> laid = shop.lay(order, best, on_copy);
    if (!laid) continue;
    best = std::move(laid);
    best_order = std::move(order);
  }
  return best.value_or(LaidSheets{});
}

/// Numbers of the copies of each piece as they come, and their places in millimetres.
std::vector<NestPlacement> placements_of(const LaidSheets& laid, const NestEngine& shop,
                                         const NestOptions& options) {
  std::vector<NestPlacement> placements;
  placements.reserve(laid.copies.size());
  for (const LaidCopy& copy : laid.copies) {
    const TurnedPiece& shape = shop.shape(copy);
    const Vec2 at = {static_cast<double>(copy.column) * shop.step(), copy.lift};
    placements.push_back(
        {copy.piece, 0, copy.sheet, shape.angle, corner_of(options) + at - shape.low});
  }
  std::stable_sort(placements.begin(), placements.end(),
                   [](const auto& a, const auto& b) { return a.piece < b.piece; });
  for (std::size_t i = 1; i < placements.size(); ++i) {
    if (placements[i].piece == placements[i - 1].piece) {
      placements[i].copy = placements[i - 1].copy + 1;
    }
  }
  return placements;
}

Nesting nesting_of(const LaidSheets& laid, const NestEngine& shop,
                   std::span<const NestPiece> pieces, const NestOptions& options) {
  Nesting nesting{placements_of(laid, shop, options), laid.sheets};
  if (laid.copies.empty()) return nesting;
  nesting.used_length = laid.end + 2.0 * options.margin;
  for (const NestPiece& piece : pieces)
    nesting.piece_area += piece.quantity * (piece.quantity > 0 ? area_of(piece.outline) : 0.0);
  const double before = static_cast<double>(laid.sheets - 1) * options.length.value_or(0.0);
  nesting.sheet_area = options.width * (before + nesting.used_length);
  return nesting;
}

/// The best layout in one set of turns.
Nesting nest_in_turns(std::span<const NestPiece> pieces, const NestOptions& options,
                      const Context& context) {
  const double step = column_step(pieces, options);
  const auto of_boxes = options.step > 0.0 ? std::nullopt : step_of_boxes(pieces, options, step);
  PartsOfJob parts(context);
  const NestEngine shop(pieces, options, step);
  LaidSheets best = best_of_tries(shop, pieces, options, parts.next(of_boxes ? 0.5 : 1.0));
  if (!of_boxes) return nesting_of(best, shop, pieces, options);
  const NestEngine fitting(pieces, options, *of_boxes);
  LaidSheets fitted = best_of_tries(fitting, pieces, options, parts.next(1.0));
  if (fitted.needs_less_than(best)) return nesting_of(fitted, fitting, pieces, options);
  return nesting_of(best, shop, pieces, options);
}

/// All that have no turns of their own get the usual ones.
std::vector<NestPiece> with_own_turns(std::span<const NestPiece> pieces, Turns usual) {
  std::vector<NestPiece> turnable(pieces.begin(), pieces.end());
  for (NestPiece& piece : turnable)
    piece.turns = piece.turns.value_or(usual);
  return turnable;
}

bool needs_less(const Nesting& a, const Nesting& b) {
  if (a.sheets != b.sheets) return a.sheets < b.sheets;
  return a.used_length < b.used_length - k_nest_slack;
}

}  // namespace

std::string_view to_string(Turns turns) {
  switch (turns) {
    case Turns::none:
      return "none";
    case Turns::half:
      return "half";
    case Turns::quarter:
      return "quarter";
    case Turns::free:
      return "free";
  }
  return "unknown";
}

Vec2 NestPlacement::operator()(Vec2 p) const {
  // Quarters of a turn are exact, so that what is square to the sheet stays so.
  constexpr std::array<Vec2, 4> quarters = {{{1.0, 0.0}, {0.0, 1.0}, {-1.0, 0.0}, {0.0, -1.0}}};
  const double radians = angle * std::numbers::pi / 180.0;
  const double quarter = angle / 90.0;
  const bool is_exact = quarter == std::floor(quarter) && quarter >= 0.0 && quarter < 4.0;
  const Vec2 x = is_exact ? quarters[static_cast<std::size_t>(quarter)]
                          : Vec2{math::cos(radians), math::sin(radians)};
  return Vec2{p.x * x.x - p.y * x.y, p.x * x.y + p.y * x.x} + shift;
}

void check_copies(double copies) {
  if (copies <= k_most_copies) return;
  throw Error(ErrorCode::too_large, "there are more than 10000 pieces to be laid on sheets");
}

Nesting nest(std::span<const NestPiece> pieces, const NestOptions& options,
             const Context& context) {
  check(pieces, options);
  const std::vector<NestPiece> turnable = with_own_turns(pieces, options.turns);
  NestOptions widest = options;
  for (const NestPiece& piece : turnable)
    widest.turns = std::max(widest.turns, *piece.turns);
  // Laying is greedy, so with more turns it may come to need more. Hence all sets of turns are
  // tried that are allowed: a larger one is never worse.
  std::vector<NestOptions> sets;
  for (const Turns turns : {Turns::none, Turns::half, Turns::quarter}) {
    NestOptions some = widest;
    some.turns = turns;
    if (turns < widest.turns && all_fit(turnable, some)) sets.push_back(some);
  }
  sets.push_back(widest);
  PartsOfJob parts(context);
  std::optional<Nesting> best;
  for (std::size_t k = 0; k < sets.size(); ++k) {
    const double share = 1.0 / static_cast<double>(sets.size() - k);
    Nesting some = nest_in_turns(turnable, sets[k], parts.next(share));
    if (!best || !needs_less(*best, some)) best = std::move(some);
  }
  return *best;
}

}  // namespace planish
