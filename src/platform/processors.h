#pragma once

namespace planish {

/// How many processors this process may run on, at least 1: on Linux and Windows those of its
/// affinity mask, as a scheduler of a cluster, `taskset` or a container sets it; elsewhere all.
unsigned usable_processors() noexcept;

}  // namespace planish
