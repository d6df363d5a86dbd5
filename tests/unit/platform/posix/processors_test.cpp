#include "platform/processors.h"

#include <thread>

#include <planish/evolve/evolve.h>
#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

#ifdef __linux__

#include <sched.h>

namespace planish {
namespace {

/// Runs work on a thread that may use one processor alone.
template <class Work>
void on_one_processor(const Work& work) {
  std::thread([&] {
    cpu_set_t mask;
    ASSERT_EQ(::sched_getaffinity(0, sizeof mask, &mask), 0);
    int first = 0;
    while (!CPU_ISSET(first, &mask))
      ++first;
    CPU_ZERO(&mask);
    CPU_SET(first, &mask);
    ASSERT_EQ(::sched_setaffinity(0, sizeof mask, &mask), 0);
    work();
  }).join();
}

TEST(PosixProcessors, AreThoseOfTheAffinityMask) {
  cpu_set_t mask;
  ASSERT_EQ(::sched_getaffinity(0, sizeof mask, &mask), 0);
  EXPECT_EQ(usable_processors(), static_cast<unsigned>(CPU_COUNT(&mask)));
  on_one_processor([] { EXPECT_EQ(usable_processors(), 1U); });
}

TEST(PosixProcessors, AreTheThreadsOfAJobThatNamesNone) {
  const Patch patch(make_shape("panel", 200));
  const auto threads_of = [&](const Context& context) {
    return evolve(patch, ControllableLaplacian{}, {.max_sweeps = 1}, {}, context).threads;
  };
  on_one_processor([&] {
    EXPECT_EQ(threads_of({}), 1U);
    EXPECT_EQ(threads_of({.threads = 2}), 2U) << "what is asked for counts";
  });
}

}  // namespace
}  // namespace planish

#endif
