#pragma once

#include <cstddef>
#include <span>

// Memory that ends on request. The test program has its own operator new, in all forms, and is
// linked so that calls of malloc and its like from our objects and from the headers compiled into
// them (Eigen) come through here. What shared libraries take for themselves (libpng, zlib, the C
// library) does not.

namespace planish::fault {

enum class Ending { once, for_good };

/// From now on allocations are counted, in all threads together, and the n-th fails, n from 1; or
/// that and all that follow. 0 for none.
void let_memory_end(std::size_t n, Ending ending = Ending::once);

/// From now on allocations are counted, and the numbers noted of those that are the first from
/// their place in the program: the same few callers, one within the other. In all threads together.
void note_places(std::span<std::size_t> numbers);

/// How many were noted; the rest, for which there was no room, not counted.
std::size_t places_noted();

/// As from the beginning: nothing fails. @return how many allocations were counted
std::size_t let_memory_last();

}  // namespace planish::fault
