#pragma once

namespace planish {

/// How many processors this process may run on, at least 1: on Linux and Windows those of its
/// affinity mask, as a cluster's scheduler, `taskset` or the cpuset of a container sets it;
/// elsewhere all. Quotas of processor time set no mask.
unsigned usable_processors() noexcept;

}  // namespace planish
