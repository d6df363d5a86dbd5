#include "platform/memory.h"

#include <algorithm>
#include <memory>
#include <new>

#include <gtest/gtest.h>

namespace planish {
namespace {

constexpr std::align_val_t k_aligned{k_large_page};

struct Free {
  void operator()(char* memory) const { ::operator delete(memory, k_aligned); }
};

std::unique_ptr<char, Free> memory_of(std::size_t bytes) {
  return std::unique_ptr<char, Free>(static_cast<char*>(::operator new(bytes, k_aligned)));
}

TEST(LargePages, LeaveWhatIsWrittenThere) {
  constexpr std::size_t bytes = 3 * k_large_page + 5;
  const auto memory = memory_of(bytes);
  std::fill_n(memory.get(), bytes, 'x');
  prefer_large_pages(memory.get(), bytes);
  EXPECT_EQ(std::count(memory.get(), memory.get() + bytes, 'x'), bytes);
}

TEST(LargePages, MayBeAskedForLessThanOne) {
  const auto memory = memory_of(100);
  prefer_large_pages(memory.get(), 100);
  prefer_large_pages(memory.get(), 0);
  prefer_large_pages(nullptr, 0);
}

TEST(Memory, WhatIsAvailableIsPlausible) {
  // The page with this test needs some megabytes; no machine has an exabyte.
  const std::size_t available = available_memory();
  EXPECT_TRUE(available == 0 || available > std::size_t{1} << 20);
  EXPECT_LT(available, std::size_t{1} << 60);
}

}  // namespace
}  // namespace planish
