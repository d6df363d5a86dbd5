#pragma once

#include <cstddef>
#include <string>

#include <planish/evolve/method.h>

namespace planish::cli {

/// The memory that a dense patch will take, for a note before the work begins, and a hint to
/// --remesh where that is more than there is. Empty for methods other than auto, and below 100,000
/// vertices.
/// @param available bytes, 0 where that is not known
std::string memory_text(const Method& method, std::size_t vertices, std::size_t available);

}  // namespace planish::cli
