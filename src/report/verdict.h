#pragma once

#include <string>

#include <planish/report/flatten.h>

namespace planish {

/// What came out, in plain words: whether the pattern can be cut, how much it is strained, and what
/// the sweeps did to energy and strain. Plain UTF-8 text.
std::string verdict_text(const FlattenReport& report);

}  // namespace planish
