#include "pattern/nest/sheet_columns.h"

#include <algorithm>

namespace planish {

namespace {

// Millimetres. Pieces may reach this far into what is taken: far more than rounding does.
constexpr double k_touch = 1e-8;

/// As far up as a piece's spans need to go in one column to meet none that is taken.
double lifted(const std::vector<Span>& piece, const std::vector<Span>& taken, double lift) {
  bool moved = true;
  while (moved) {
    moved = false;
    for (const Span& part : piece) {
      for (const Span& other : taken) {
        if (other.low >= part.high + lift - k_touch) break;
        if (other.high <= part.low + lift + k_touch) continue;
        lift = other.high - part.low;
        moved = true;
      }
    }
    if (piece.size() == 1) break;  // one span has passed all that it could meet
  }
  return lift;
}

double largest_room(const std::vector<Span>& taken, double height) {
  double room = 0.0, from = 0.0;
  for (const Span& span : taken) {
    room = std::max(room, span.low - from);
    from = span.high;
  }
  return std::max(room, height - from);
}

void add_span(std::vector<Span>& taken, Span span) {
  auto first = std::find_if(taken.begin(), taken.end(),
                            [&](const Span& other) { return other.high >= span.low; });
  auto last = first;
  for (; last != taken.end() && last->low <= span.high; ++last)
    span = {std::min(span.low, last->low), std::max(span.high, last->high)};
  taken.insert(taken.erase(first, last), span);
}

}  // namespace

bool SheetColumns::is_hopeless(const ColumnSpans& piece, std::size_t at) const {
  for (std::size_t c = 0; c < piece.columns.size() && at + c < room_.size(); ++c) {
    for (const Span& span : piece.columns[c]) {
      if (span.high - span.low > room_[at + c] + 2.0 * k_touch) return true;
    }
  }
  return false;
}

std::optional<double> SheetColumns::lowest_place(const ColumnSpans& piece, std::size_t at,
                                                 Span lifts) const {
  if (is_hopeless(piece, at)) return std::nullopt;
  const std::size_t columns =
      at < taken_.size() ? std::min(piece.columns.size(), taken_.size() - at) : 0;
  double lift = lifts.low;
  // A column that has let the piece pass may stop it again further up: on until none has since.
  std::size_t passed = 0;
  for (std::size_t c = 0; passed < columns; c = c + 1 < columns ? c + 1 : 0) {
    const double next = lifted(piece.columns[c], taken_[at + c], lift);
    passed = next > lift ? 1 : passed + 1;
    lift = next;
    if (lift > lifts.high + k_touch) return std::nullopt;
  }
  return lift;
}

void SheetColumns::take(const ColumnSpans& grown, std::size_t at, double lift) {
  const auto start = static_cast<std::ptrdiff_t>(at) + grown.first;
  for (std::size_t c = 0; c < grown.columns.size(); ++c) {
    const std::ptrdiff_t k = start + static_cast<std::ptrdiff_t>(c);
    if (k < 0) continue;
    const auto column = static_cast<std::size_t>(k);
    if (column >= taken_.size()) {
      taken_.resize(column + 1);
      room_.resize(column + 1, height_);
    }
    for (const Span& span : grown.columns[c])
      add_span(taken_[column], {span.low + lift, span.high + lift});
    room_[column] = largest_room(taken_[column], height_);
  }
}

}  // namespace planish
