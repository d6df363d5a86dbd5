#include "core/simd/isa.h"

#include <gtest/gtest.h>

namespace planish {
namespace {

TEST(Isa, IsNamedAsCompilersNameIt) {
  EXPECT_EQ(to_string(Isa::baseline), "baseline");
  EXPECT_EQ(to_string(Isa::x86_64_v3), "x86-64-v3");
  EXPECT_EQ(to_string(Isa::x86_64_v4), "x86-64-v4");
}

TEST(Isa, BeginsWithWhatEveryProcessorHasAndIsTheBestThereIs) {
  EXPECT_EQ(available_isas().front(), Isa::baseline);
  EXPECT_EQ(best_isa(), available_isas().back());
}

}  // namespace
}  // namespace planish
