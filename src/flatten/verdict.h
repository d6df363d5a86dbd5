#pragma once

#include <string>

#include <planish/flatten/flatten.h>

namespace planish {

/// What came out, in plain words: whether the pattern can be cut, how much it is strained, and what
/// the sweeps did to energy and strain. Plain UTF-8 text.
std::string verdict_text(const FlattenReport& report);

/// Asks about the unit where a pattern of that size is unlikely: mesh files do not say their unit,
/// and a wrong guess is common and costly. Empty elsewhere.
std::string unit_question(const UnfoldReport& unfold);

/// That the border of the patch as it came is too short for its surface, by how much and what to do
/// about it: one sentence, plain UTF-8 text. Empty where little area is at stake.
std::string border_text(const FlattenReport& report);

}  // namespace planish
