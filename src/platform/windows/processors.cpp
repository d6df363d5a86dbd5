#include "platform/processors.h"

#include <algorithm>
#include <bit>
#include <thread>

#include <windows.h>

namespace planish {

unsigned usable_processors() noexcept {
  DWORD_PTR usable = 0, all = 0;
  // Both are 0 where the process has threads in several groups of processors: then all count.
  if (GetProcessAffinityMask(GetCurrentProcess(), &usable, &all) != 0 && usable != 0)
    return static_cast<unsigned>(std::popcount(usable));
  return std::max(1U, std::thread::hardware_concurrency());
}

}  // namespace planish
