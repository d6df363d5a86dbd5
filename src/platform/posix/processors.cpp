#include "platform/processors.h"

#include <algorithm>
#include <thread>

#ifdef __linux__
#include <sched.h>
#endif

namespace planish {

unsigned usable_processors() noexcept {
#ifdef __linux__
  // A mask of 1024 processors. Where the system has more, the call fails, and all count.
  cpu_set_t usable;
  if (::sched_getaffinity(0, sizeof usable, &usable) == 0)
    return static_cast<unsigned>(std::max(1, CPU_COUNT(&usable)));
#endif
  return std::max(1U, std::thread::hardware_concurrency());
}

}  // namespace planish
