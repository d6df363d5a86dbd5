#include <cmath>

#include <planish/core/error.h>
#include <planish/core/range.h>

#include <gtest/gtest.h>

#include "core/number_text.h"

namespace planish {
namespace {

TEST(Error, TellsPathLineAndMessage) {
  const Error error(ErrorCode::bad_number, "\"1,5\" is not a number", {.path = "a.obj", .line = 7});
  EXPECT_STREQ(error.what(), "a.obj:7: \"1,5\" is not a number");
  EXPECT_EQ(error.message(), "\"1,5\" is not a number");
  EXPECT_EQ(to_string(error.code()), "bad_number");
}

TEST(Error, TellsTheByteOfABinaryFile) {
  const Error error(ErrorCode::truncated_file, "ends early", {.path = "a.ply", .byte = 120});
  EXPECT_STREQ(error.what(), "a.ply at byte 120: ends early");
}

TEST(CheckRange, AcceptsTheEndsAndRefusesBeyondAndNaN) {
  EXPECT_NO_THROW(check_range("lambda", 0.0, {0.0, 1.0}));
  EXPECT_NO_THROW(check_range("lambda", 1.0, {0.0, 1.0}));
  EXPECT_THROW(check_range("lambda", 1.0000001, {0.0, 1.0}), Error);
  EXPECT_THROW(check_range("lambda", std::nan(""), {0.0, 1.0}), Error);
  try {
    check_range("lambda", 2.5, {0.0, 1.0});
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::option_out_of_range);
    EXPECT_STREQ(error.what(), "lambda is 2.5 but must be from 0 to 1");
  }
}

TEST(NumberText, IsShortAndExact) {
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(1e300), "1e+300");
  EXPECT_EQ(fixed_text(1.5, 3), "1.5");
  EXPECT_EQ(fixed_text(100.0, 3), "100");
  EXPECT_EQ(fixed_text(-0.0001, 3), "0");
  EXPECT_EQ(fixed_text(1e308, 3).size(), 309U);
}

}  // namespace
}  // namespace planish
