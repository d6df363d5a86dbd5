#pragma once

#include <string>

#include <planish/report/flatten.h>

namespace planish {

/// What came out, in plain words: whether the pattern can be cut, how much it is strained, and what
/// the sweeps did to energy and strain. Plain UTF-8 text.
std::string verdict_text(const FlattenReport& report);

/// That the border of the patch as it came is too short for its surface, by how much and what to do
/// about it: one sentence, plain UTF-8 text. Empty where little area is at stake.
std::string border_text(const FlattenReport& report);

}  // namespace planish
