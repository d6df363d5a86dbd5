#pragma once

#include <cstddef>

#include <planish/mesh/patch.h>

#include "core/thread_pool.h"

namespace planish {

/// A product over fewer of its vertices, closed or with borders (coarsen()).
/// @param vertices that are to remain, approximately
/// @throws Cancelled
Patch thinned_product(const Patch& patch, std::size_t vertices, const ThreadPool& pool);

}  // namespace planish
