#include "core/thread_pool.h"

#include <atomic>
#include <new>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

namespace planish {
namespace {

TEST(ThreadPool, VisitsEveryElementOnceForAnyNumberOfThreads) {
  for (const unsigned threads : {1U, 2U, 4U, 7U}) {
    ThreadPool pool(threads);
    EXPECT_EQ(pool.size(), threads);
    for (const std::size_t count : {0U, 1U, 15U, 16U, 1000U, 4097U}) {
      std::vector<int> visits(count, 0);
      pool.for_ranges(count, 8, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
          ++visits[i];
      });
      EXPECT_EQ(visits, std::vector<int>(count, 1)) << count << " on " << threads;
    }
  }
}

TEST(ThreadPool, ReturnsOnlyWhenAllIsDone) {
  ThreadPool pool(4);
  for (int round = 0; round < 500; ++round) {
    std::atomic<std::size_t> sum = 0;
    pool.for_ranges(64, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        sum += i;
    });
    ASSERT_EQ(sum.load(), 64U * 63U / 2U);
  }
}

TEST(ThreadPool, ThrowsOnWhatAPartThrowsAndStaysUsable) {
  for (const unsigned threads : {1U, 4U}) {
    ThreadPool pool(threads);
    for (int round = 0; round < 50; ++round) {
      EXPECT_THROW(pool.for_ranges(1000, 1,
                                   [&](std::size_t begin, std::size_t end) {
                                     if (begin <= 500 && 500 < end) throw std::bad_alloc();
                                   }),
                   std::bad_alloc);
      std::atomic<std::size_t> visits = 0;
      pool.for_ranges(100, 1, [&](std::size_t begin, std::size_t end) { visits += end - begin; });
      ASSERT_EQ(visits.load(), 100U);
    }
  }
}

TEST(ThreadPool, BeginsNoLoopOnceTheJobIsCancelled) {
  for (const unsigned threads : {1U, 4U}) {
    bool cancelled = false;
    ThreadPool pool(Context{.threads = threads, .is_cancelled = [&] { return cancelled; }});
    EXPECT_EQ(pool.size(), threads);
    std::atomic<std::size_t> visits = 0;
    const auto visit = [&](std::size_t begin, std::size_t end) { visits += end - begin; };
    pool.for_ranges(100, 1, visit);
    cancelled = true;
    EXPECT_THROW(pool.for_ranges(100, 1, visit), Cancelled);
    EXPECT_EQ(visits.load(), 100U);
  }
}

}  // namespace
}  // namespace planish
