#include "core/buffer.h"

#include <cstdint>

#include <gtest/gtest.h>

#include "platform/memory.h"

namespace planish {
namespace {

TEST(Buffer, OfManyBytesBeginsAtALargePage) {
  const Buffer<char> buffer(3 * k_large_page);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(buffer.data()) % k_large_page, 0U);
}

TEST(Buffer, HoldsAllOfItsElements) {
  for (const std::size_t size : {std::size_t{0}, std::size_t{7}, k_large_page}) {
    Buffer<std::uint32_t> buffer(size);
    ASSERT_EQ(buffer.size(), size);
    for (std::size_t i = 0; i < size; ++i)
      buffer[i] = static_cast<std::uint32_t>(i);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < size; ++i)
      wrong += buffer[i] != i;
    EXPECT_EQ(wrong, 0U);
  }
}

TEST(Buffer, RefusesMoreThanThereCanBe) {
  EXPECT_THROW(Buffer<double>(std::size_t{1} << 62), std::bad_alloc);
}

}  // namespace
}  // namespace planish
