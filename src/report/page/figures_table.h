#pragma once

#include <string>

#include <planish/flatten/flatten.h>

namespace planish {

/// All figures of a report, before, after and what changed, each with a few plain words: an HTML
/// table. Every number stands in a <data> element with all its digits as value.
std::string figures_table(const FlattenReport& report);

}  // namespace planish
