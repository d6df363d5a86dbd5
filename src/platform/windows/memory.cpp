#include "platform/memory.h"

#include <algorithm>

#include <windows.h>

namespace planish {

void prefer_large_pages(void*, std::size_t) noexcept {}

void trim_heap() noexcept {}

std::size_t available_memory() {
  MEMORYSTATUSEX status = {};
  status.dwLength = sizeof status;
  if (GlobalMemoryStatusEx(&status) == 0) return 0;
  // The second is what the process may still be promised, which other processes use up too.
  return static_cast<std::size_t>(std::min(status.ullAvailPhys, status.ullAvailPageFile));
}

}  // namespace planish
