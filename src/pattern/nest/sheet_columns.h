#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "pattern/polygon/column_spans.h"

namespace planish {

/// What is taken of a sheet, column by column. Heights go from 0 to that of the sheet.
class SheetColumns {
 public:
  explicit SheetColumns(double height) : height_(height) {}

  /// The column from which on nothing is taken.
  std::size_t end() const { return taken_.size(); }

  /// The lowest place where a piece meets nothing that is taken, if there is one.
  /// @param piece its columns from number 0 on, its lowest place at height 0
  /// @param at the number of the sheet's column that its first one comes to lie on
  /// @param lifts how far the piece may be lifted, from the least on
  std::optional<double> lowest_place(const ColumnSpans& piece, std::size_t at, Span lifts) const;

  /// Takes the columns of a piece and of the gap around it; what is off the sheet is left out.
  void take(const ColumnSpans& grown, std::size_t at, double lift);

 private:
  bool is_hopeless(const ColumnSpans& piece, std::size_t at) const;

  double height_;
  std::vector<std::vector<Span>> taken_;  ///< from the lowest up; they do not meet
  std::vector<double> room_;              ///< the height of the largest free span
};

}  // namespace planish
