#include "decimal.h"

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <random>
#include <string>

#include <gtest/gtest.h>

// The program in the browser writes numbers by functions of its own; here they are compared with
// this system's.

namespace planish {
namespace {

template <typename... Options>
std::string of_the_library(auto value, Options... options) {
  std::array<char, 2000> text = {};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, options...).ptr;
  return {text.data(), end};
}

constexpr std::array k_formats = {std::chars_format::fixed, std::chars_format::scientific,
                                  std::chars_format::general};

void expect_same(auto value) {
  EXPECT_EQ(shortest_decimal(value), of_the_library(value));
  for (const std::chars_format format : k_formats)
    EXPECT_EQ(shortest_decimal(value, format), of_the_library(value, format));
}

void expect_same_rounded(double value) {
  for (const std::chars_format format : k_formats) {
    for (const int precision : {0, 2, 3, 6, 12})
      EXPECT_EQ(rounded_decimal(value, format, precision),
                of_the_library(value, format, precision));
  }
}

TEST(Decimal, IsThatOfTheLibraryForNumbersAtRandom) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 5000; ++i) {
    const double value = std::bit_cast<double>(random());
    expect_same(value);
    expect_same(std::bit_cast<float>(static_cast<std::uint32_t>(random())));
    if (i % 10 == 0) expect_same_rounded(value);
  }
}

TEST(Decimal, IsThatOfTheLibraryForNumbersOfPatterns) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 5000; ++i) {
    expect_same(static_cast<double>(static_cast<std::int64_t>(random() >> (i % 64))));
    const double length = static_cast<double>(random() % 2'000'000) / 1000.0 - 1000.0;
    expect_same(length);
    expect_same_rounded(length);
  }
}

// Below a power of two numbers are half as far apart as above it.
TEST(Decimal, IsThatOfTheLibraryForAllPowersOfTwo) {
  for (int power = -1074; power < 1024; ++power)
    expect_same(std::ldexp(1.0, power));
  for (int power = -149; power < 128; ++power)
    expect_same(std::ldexp(-1.0F, power));
}

TEST(Decimal, IsThatOfTheLibraryForWhatIsNoNumber) {
  using Limits = std::numeric_limits<double>;
  for (const double value :
       {0.0, -0.0, Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN(),
        Limits::denorm_min(), Limits::max(), 1e22, 1e23, 1e5, 123456.0}) {
    expect_same(value);
    expect_same_rounded(value);
  }
}

}  // namespace
}  // namespace planish
