#include "rubsweep/maps/table/rows.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rubsweep/maps/table/cell.hpp"

namespace rubsweep::table {
namespace {

/// The numbers of all rows, or the error message.
std::string read(std::string_view text) {
  std::string numbers;
  try {
    const Layout layout = layout_of(text);
    Rows rows(text, layout);
    while (rows.next()) {
      for (std::size_t i = 0; i < layout.fewest_cells; ++i)
        if (!layout.columns[i].is_text) numbers += std::to_string(std::lround(10 * rows.number(i))) + ' ';
    }
  } catch (const Fault& fault) {
    return std::to_string(fault.line) + ':' + std::to_string(fault.column) + ": " + fault.wrong;
  }
  return numbers;
}

TEST(Rows, GiveNumbersInEitherWriting) {
  EXPECT_EQ(read("a,b\n1.5,2\n# a word\n3,4\n"), "15 20 30 40 ");
  EXPECT_EQ(read("a;b\n1,5;2\n3;4\n"), "15 20 30 40 ");
  EXPECT_EQ(read("a,b\n\"1,5\",\"2\"\n\"3\",\"4,5\"\n"), "15 20 30 45 ");
  EXPECT_EQ(read("a,b,c\n1,2,x\n3,4\n5,6,\"y,z\"\n"), "10 20 30 40 50 60 ");
}

TEST(Rows, RefuseWhatOneNumberCannotBe) {
  // Thousands separators with decimal commas: 1.000 would be read as 1.
  EXPECT_EQ(read("a;b\n1.000;2\n999,5;3\n"),
            "3:1: '999,5' has a decimal comma, and numbers before it have points");
  EXPECT_EQ(read("a,b\n1,\"1,000\"\n2,\"2,000\"\n"),
            "2:4: '1,000' may have a decimal comma, or commas between thousands");
  EXPECT_EQ(read("a,b\n1,2.5\n2,\"-12,500,000.5\"\n3,4\n"),
            "3:4: '-12,500,000.5' may have a decimal comma, or commas between thousands");
  EXPECT_EQ(read("a;b\n1,000;2,125\n3;4\n"), "10 21 30 40 ");
  EXPECT_EQ(read("a,b\n1,\"0,12\"\n2,\"1234,567\"\n"), "10 1 20 12346 ");
  EXPECT_EQ(read("a;b\n1;2\n3;4,x\n"), "3:3: '4,x' is no number");
  EXPECT_EQ(read("a,b\n1,2\n3\n4,5\n"), "3:1: has another number of cells, 1");
  EXPECT_EQ(read("a,b\n1,2\n3,4,5\n4,5\n"), "3:1: has another number of cells, 3");
  EXPECT_EQ(read("a,b\n1,2\n3,4,5\n6,7,8\n"), "2:1: has another number of cells, 2");
}

std::string utf16(std::string_view ascii, bool large_end_first) {
  std::string bytes = large_end_first ? "\xFE\xFF" : "\xFF\xFE";
  for (const char letter : ascii)
    bytes += large_end_first ? std::string{'\0', letter} : std::string{letter, '\0'};
  return bytes;
}

TEST(RowsEncoding, AllBecomeUtf8WithoutAMark) {
  EXPECT_EQ(utf8_of("X [\u00b5m]"), "X [\u00b5m]");
  EXPECT_EQ(utf8_of("\xEF\xBB\xBFX [\u00b5m]"), "X [\u00b5m]");
  EXPECT_EQ(utf8_of("X [\xB5m] 20 \xB0"), "X [\u00b5m] 20 \u00b0");
  EXPECT_EQ(utf8_of(utf16("t;x\n1;2\n", false)), "t;x\n1;2\n");
  EXPECT_EQ(utf8_of(utf16("t;x\n1;2\n", true)), "t;x\n1;2\n");
  EXPECT_EQ(utf8_of(std::string("\xFE\xFF\x03\xBC", 4)), "\u03bc");
}

TEST(RowsEncoding, BytesThatAreNoTextAreRefused) {
  EXPECT_THROW(utf8_of(std::string_view("1,2\0", 4)), Fault);
  EXPECT_THROW(utf8_of(std::string_view("\xB5\0", 2)), Fault);
}

}  // namespace
}  // namespace rubsweep::table
