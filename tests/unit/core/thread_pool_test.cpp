#include "core/thread_pool.h"

#include <atomic>
#include <chrono>
#include <new>
#include <numeric>
#include <thread>
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

TEST(ThreadPool, EndsALoopBetweenItsPartsOnceTheJobIsCancelled) {
  for (const unsigned threads : {1U, 2U, 4U}) {
    std::atomic<bool> cancelled = false;
    std::atomic<std::size_t> done = 0;
    ThreadPool pool(Context{.threads = threads, .is_cancelled = [&] { return cancelled.load(); }});
    const auto body = [&](std::size_t begin, std::size_t end) {
      done += end - begin;
      cancelled = true;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    };
    EXPECT_THROW(pool.for_ranges(10'000, 1, body), Cancelled);
    EXPECT_LT(done, 10'000U) << threads;
    EXPECT_THROW(pool.stop_if_cancelled(), Cancelled);
    EXPECT_THROW(pool.report(0.5), Cancelled);
    cancelled = false;
    EXPECT_NO_THROW(pool.for_ranges(100, 1, [](std::size_t, std::size_t) {})) << "usable again";
  }
}

TEST(ThreadPool, ReportsTheShareOfAStep) {
  std::vector<double> shares;
  const ThreadPool pool(Context{
      .threads = 1, .on_progress = [&](const Progress& step) { shares.push_back(step.share); }});
  pool.report(0.25);
  pool.report(1.0);
  EXPECT_EQ(shares, (std::vector<double>{0.25, 1.0}));
  EXPECT_NO_THROW(ThreadPool(1).report(0.5));
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
