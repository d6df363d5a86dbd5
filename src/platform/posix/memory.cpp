#include "platform/memory.h"

#include <sys/mman.h>

namespace planish {

void prefer_large_pages([[maybe_unused]] void* memory,
                        [[maybe_unused]] std::size_t bytes) noexcept {
#ifdef MADV_HUGEPAGE
  const std::size_t whole = bytes / k_large_page * k_large_page;
  if (whole > 0) ::madvise(memory, whole, MADV_HUGEPAGE);
#endif
}

}  // namespace planish
