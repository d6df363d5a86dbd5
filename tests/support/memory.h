#pragma once

#include <cstddef>
#include <fstream>

#include <unistd.h>

namespace planish {

/// Bytes of this process that are in memory now; 0 where the system does not tell.
inline std::size_t resident_bytes() {
  std::ifstream file("/proc/self/statm");
  std::size_t pages = 0, resident = 0;
  file >> pages >> resident;
  return file ? resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) : 0;
}

}  // namespace planish
