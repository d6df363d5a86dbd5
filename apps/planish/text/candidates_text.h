#pragma once

#include <string>
#include <vector>

#include <planish/flatten/flatten.h>

#include "text/lengths.h"

namespace planish::cli {

/// Two lines that name the columns of candidate_row().
std::string candidate_head(const ShownLengths& lengths);

/// A surface with its strain, move, bending and sharpest new fold, at most 80 columns wide.
/// @param mark two letters or less before the name
std::string candidate_row(const std::string& mark, const Candidate& candidate,
                          const ShownLengths& lengths);

/// The surfaces that a run computed, the result marked, and how to get the others.
std::string candidates_text(const FlattenReport& report);

}  // namespace planish::cli
