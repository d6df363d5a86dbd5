#include "io/formats/face_list.h"

#include <numeric>

#include <gtest/gtest.h>

#include "io/file/byte_cursor.h"
#include "unit/io/io_testing.h"

namespace planish {
namespace {

const ByteCursor k_cursor("", "mesh", 0);

TEST(FaceList, FindsRepeatedVerticesOfSmallAndLargePolygons) {
  std::vector<Index> corners(100);
  std::iota(corners.begin(), corners.end(), 7U);
  for (const std::size_t size : {4U, 8U, 9U, 100U}) {
    const std::span<Index> polygon(corners.data(), size);
    EXPECT_FALSE(has_repeat(polygon));
    const Index last = std::exchange(polygon.back(), polygon.front());
    EXPECT_TRUE(has_repeat(polygon));
    polygon.back() = last;
  }
}

TEST(FaceList, RefusesMoreThanAnIndexCanNumber) {
  EXPECT_NO_THROW(check_size(4294967294, "vertices", k_cursor));
  const Error error = error_of([] { check_size(4294967295, "vertices", k_cursor); });
  EXPECT_EQ(error.code(), ErrorCode::too_large);
  EXPECT_NE(error.message().find("more than 4294967294 vertices"), std::string::npos);
}

TEST(CheckedIndex, AcceptsWholeNumbersInRangeOnly) {
  EXPECT_EQ(checked_index(0.0, 4, k_cursor), 0U);
  EXPECT_EQ(checked_index(3.0, 4, k_cursor), 3U);
  EXPECT_EQ(checked_index(4294967293.0, k_most_items, k_cursor), 4294967293U);
  for (const double value : {-1.0, 4.0, 4294967296.0, 1e300, -1e300}) {
    EXPECT_EQ(error_of([&] { checked_index(value, 4, k_cursor); }).code(),
              ErrorCode::index_out_of_range);
  }
  EXPECT_EQ(error_of([] { checked_index(0.5, 4, k_cursor); }).code(), ErrorCode::bad_number);
}

}  // namespace
}  // namespace planish
