#include <planish/core/error.h>
#include <planish/pattern/read_annotations.h>

#include <gtest/gtest.h>

namespace planish {
namespace {

template <class Parse>
void expect_error(Parse parse, ErrorCode code, std::size_t line) {
  try {
    parse();
    FAIL() << to_string(code);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code) << error.what();
    EXPECT_EQ(error.place().line, line);
    EXPECT_EQ(error.place().path, "f.txt");
  }
}

TEST(ReadNotches, TellsVerticesFromShares) {
  const auto notches =
      notches_in(parse_rows("12 v\n0.25 t double # collar\n\n50% slit\n7\n", "n.txt"));
  ASSERT_EQ(notches.size(), 4U);
  EXPECT_EQ(notches[0].vertex(), 12U);
  EXPECT_EQ(notches[0].kind, NotchKind::v);
  EXPECT_FALSE(notches[0].is_double);
  EXPECT_EQ(notches[1].fraction, 0.25);
  EXPECT_EQ(notches[1].kind, NotchKind::t);
  EXPECT_TRUE(notches[1].is_double);
  EXPECT_EQ(notches[2].fraction, 0.5);
  EXPECT_EQ(notches[3].vertex(), 7U);
  EXPECT_EQ(notches[3].kind, NotchKind::slit);
}

TEST(ReadMarks, AreCrossesUnlessDrilled) {
  const auto marks = marks_in(parse_rows("3\n9 drill\n", "m.txt"));
  ASSERT_EQ(marks.size(), 2U);
  EXPECT_EQ(marks[0].kind, MarkKind::cross);
  EXPECT_EQ(marks[1].vertex, 9U);
  EXPECT_EQ(marks[1].kind, MarkKind::drill);
}

TEST(ReadNotches, NameTheLineThatIsWrong) {
  const auto expect = [](const char* text, ErrorCode code, std::size_t line) {
    expect_error([&] { notches_in(parse_rows(text, "f.txt")); }, code, line);
  };
  expect("1 v\n-1 v\n", ErrorCode::bad_number, 2);
  expect("1x\n", ErrorCode::bad_number, 1);
  expect("0.5.5\n", ErrorCode::bad_number, 1);
  expect("%\n", ErrorCode::bad_number, 1);
  expect("99999999999\n", ErrorCode::bad_number, 1);
  expect("\n\n1 w\n", ErrorCode::unknown_name, 3);
  expect("1 v twice\n", ErrorCode::unknown_name, 1);
  expect("1 v double 3\n", ErrorCode::malformed_file, 1);
}

TEST(NotchesIn, TakeNumbersForWhatTheyAre) {
  const auto notches =
      notches_in({"n", {{{std::int64_t{12}, "v"}, 1}, {{1.0}, 2}, {{"25%", "t", "double"}, 3}}});
  ASSERT_EQ(notches.size(), 3U);
  EXPECT_EQ(notches[0].vertex(), 12U);
  EXPECT_EQ(notches[0].kind, NotchKind::v);
  EXPECT_EQ(notches[1].fraction, 1.0);
  EXPECT_FALSE(notches[1].vertex());
  EXPECT_EQ(notches[2].fraction, 0.25);
  EXPECT_EQ(marks_in({"m", {{{std::int64_t{3}}, 1}}}).front().vertex, 3U);
  for (const Field& vertex : {Field(3.0), Field(std::int64_t{-3}), Field(std::int64_t{1} << 40)})
    expect_error([&] { marks_in({"f.txt", {{{vertex}, 7}}}); }, ErrorCode::bad_number, 7);
  EXPECT_EQ(edge_allowances_in({"e", {{{std::int64_t{1}, "2", 0.1}, 1}}}).front().width, 0.1);
}

TEST(ReadSeamNotches, TakesSharesAndLengthsOfOneSeamOrAll) {
  const auto notches =
      seam_notches_in(parse_rows("* 50%\n2 120.5mm v double # side\n1 0.25 t\n", "n.txt"));
  ASSERT_EQ(notches.size(), 3U);
  EXPECT_FALSE(notches[0].seam.has_value());
  EXPECT_EQ(notches[0].place, 0.5);
  EXPECT_FALSE(notches[0].in_millimetres);
  EXPECT_EQ(notches[0].kind, NotchKind::slit);
  EXPECT_EQ(notches[1].seam, 1U);
  EXPECT_EQ(notches[1].place, 120.5);
  EXPECT_TRUE(notches[1].in_millimetres);
  EXPECT_EQ(notches[1].kind, NotchKind::v);
  EXPECT_TRUE(notches[1].is_double);
  EXPECT_EQ(notches[2].seam, 0U);
  EXPECT_EQ(notches[2].place, 0.25);
}

TEST(ReadInnerLines, TakesTheVerticesOfEach) {
  const auto lines = inner_lines_in(parse_rows("1 2 3\n# none\n7 5\n", "l.txt"));
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0], (InnerLine{1, 2, 3}));
  EXPECT_EQ(lines[1], (InnerLine{7, 5}));
  const auto expect = [](const char* text, ErrorCode code, std::size_t line) {
    expect_error([&] { inner_lines_in(parse_rows(text, "f.txt")); }, code, line);
  };
  expect("1 2\n3\n", ErrorCode::malformed_file, 2);
  expect("1 2 x\n", ErrorCode::bad_number, 1);
}

TEST(ReadEdgeAllowances, TakesStretchesAndWidths) {
  const auto edges = edge_allowances_in(parse_rows("12 57 0\n57 203 25.5mm # hem\n", "e.txt"));
  ASSERT_EQ(edges.size(), 2U);
  EXPECT_EQ(edges[0].from, 12U);
  EXPECT_EQ(edges[0].to, 57U);
  EXPECT_EQ(edges[0].width, 0.0);
  EXPECT_EQ(edges[1].width, 25.5);
}

TEST(ReadEdgeAllowances, NameTheLineThatIsWrong) {
  const auto expect = [](const char* text, ErrorCode code, std::size_t line) {
    expect_error([&] { edge_allowances_in(parse_rows(text, "f.txt")); }, code, line);
  };
  expect("1 2 3\n1 2\n", ErrorCode::malformed_file, 2);
  expect("1\n", ErrorCode::malformed_file, 1);
  expect("x 2 3\n", ErrorCode::bad_number, 1);
  expect("1 2 3cm\n", ErrorCode::bad_number, 1);
  expect("1 2 -3\n", ErrorCode::option_out_of_range, 1);
  expect("1 2 3 4\n", ErrorCode::malformed_file, 1);
}

TEST(ReadSeamNotches, NameTheLineThatIsWrong) {
  const auto expect = [](const char* text, ErrorCode code, std::size_t line) {
    expect_error([&] { seam_notches_in(parse_rows(text, "f.txt")); }, code, line);
  };
  expect("0 50%\n", ErrorCode::bad_number, 1);
  expect("* 50%\nall 50%\n", ErrorCode::bad_number, 2);
  expect("1\n", ErrorCode::malformed_file, 1);
  expect("1 12cm\n", ErrorCode::bad_number, 1);
  expect("1 nan\n", ErrorCode::bad_number, 1);
  expect("1 mm\n", ErrorCode::bad_number, 1);
  expect("1 50% x\n", ErrorCode::unknown_name, 1);
  expect("1 50% v double 3\n", ErrorCode::malformed_file, 1);
}

TEST(ReadMarks, NameTheLineThatIsWrong) {
  const auto expect = [](const char* text, ErrorCode code, std::size_t line) {
    expect_error([&] { marks_in(parse_rows(text, "f.txt")); }, code, line);
  };
  expect("1\n0.5\n", ErrorCode::bad_number, 2);
  expect("1 hole\n", ErrorCode::unknown_name, 1);
  expect("1 drill 3\n", ErrorCode::malformed_file, 1);
}

}  // namespace
}  // namespace planish
