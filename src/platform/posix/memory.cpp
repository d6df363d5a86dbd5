#include "platform/memory.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <sys/mman.h>
#include <sys/resource.h>

namespace planish {

void prefer_large_pages([[maybe_unused]] void* memory,
                        [[maybe_unused]] std::size_t bytes) noexcept {
#ifdef MADV_HUGEPAGE
  const std::size_t whole = bytes / k_large_page * k_large_page;
  if (whole > 0) ::madvise(memory, whole, MADV_HUGEPAGE);
#endif
}

void trim_heap() noexcept {
#ifdef __GLIBC__
  ::malloc_trim(0);
#endif
}

std::size_t available_memory() {
  constexpr std::size_t kibibyte = 1024;
  std::size_t most = std::numeric_limits<std::size_t>::max();
  rlimit limit = {};
  if (::getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
    most = static_cast<std::size_t>(limit.rlim_cur);
  std::ifstream file("/proc/meminfo");  // of Linux alone
  std::string word;
  for (std::size_t amount = 0; file >> word;) {
    if (word == "MemAvailable:" && file >> amount) return std::min(most, amount * kibibyte);
  }
  return 0;
}

}  // namespace planish
