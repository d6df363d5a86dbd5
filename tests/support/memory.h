#pragma once

#include <cstddef>
#include <fstream>

#include <malloc.h>
#include <unistd.h>

namespace planish {

/// Bytes of this process that are in memory now; 0 where the system does not tell.
inline std::size_t resident_bytes() {
  std::ifstream file("/proc/self/statm");
  std::size_t pages = 0, resident = 0;
  file >> pages >> resident;
  return file ? resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) : 0;
}

/// Bytes that all threads have allocated and not freed; 0 under the sanitizers, whose own allocator
/// reports a leak at the end. Resident pages depend on how threads share the heap; this does not.
inline std::size_t allocated_bytes() {
  const struct mallinfo2 heap = mallinfo2();
  return heap.uordblks + heap.hblkhd;
}

}  // namespace planish
