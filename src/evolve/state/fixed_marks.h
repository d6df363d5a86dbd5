#pragma once

#include <cstddef>
#include <vector>

#include <planish/evolve/constraints.h>

namespace planish {

/// By vertex, 1 for those that are fixed; empty where none is.
std::vector<unsigned char> fixed_marks(const Constraints& constraints, std::size_t vertices);

}  // namespace planish
