#include "text/memory_text.h"

#include <gtest/gtest.h>

namespace planish::cli {
namespace {

TEST(MemoryText, SaysNothingOfSmallPatchesAndOtherMethods) {
  EXPECT_EQ(memory_text(Auto{}, 99'999, 1), "");
  EXPECT_EQ(memory_text(ControllableLaplacian{}, 5'000'000, 1), "");
}

TEST(MemoryText, OffersRemeshWhereMemoryWouldNotDo) {
  EXPECT_EQ(memory_text(Auto{}, 1'000'000, 16'000'000'000),
            "1000000 vertices take about 7.5 GB of memory");
  EXPECT_EQ(memory_text(Auto{}, 1'000'000, 0), "1000000 vertices take about 7.5 GB of memory");
  EXPECT_EQ(memory_text(Auto{}, 1'000'000, 7'000'000'000),
            "1000000 vertices take about 7.5 GB of memory, and 7.0 GB are free: --remesh works on "
            "fewer vertices, keeps the border and takes about 0.50 GB");
}

}  // namespace
}  // namespace planish::cli
