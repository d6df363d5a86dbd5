#pragma once

#include <string>

#include <planish/flatten/compare.h>

namespace planish {

/// A row per method with its figures, after one for the input: an HTML table. The best figure of
/// each column, of those methods that moved something, has a star. Every number stands in a <data>
/// element with all its digits as value; what there is not is a dash.
std::string compare_table(const CompareReport& report);

/// The mark of a method in tables and headings: a bit of its line in the charts.
std::string run_swatch(std::size_t run);

}  // namespace planish
