#include "rubsweep/maps/table/encoding.hpp"

#include <gtest/gtest.h>

#include "rubsweep/maps/table/cell.hpp"

namespace rubsweep::table {
namespace {

std::string utf16(std::string_view ascii, bool large_end_first) {
  std::string bytes = large_end_first ? "\xFE\xFF" : "\xFF\xFE";
  for (const char letter : ascii)
    bytes += large_end_first ? std::string{'\0', letter} : std::string{letter, '\0'};
  return bytes;
}

TEST(Encoding, AllBecomeUtf8WithoutAMark) {
  EXPECT_EQ(utf8_of("X [\u00b5m]"), "X [\u00b5m]");
  EXPECT_EQ(utf8_of("\xEF\xBB\xBFX [\u00b5m]"), "X [\u00b5m]");
  EXPECT_EQ(utf8_of("X [\xB5m] 20 \xB0"), "X [\u00b5m] 20 \u00b0");
  EXPECT_EQ(utf8_of(utf16("t;x\n1;2\n", false)), "t;x\n1;2\n");
  EXPECT_EQ(utf8_of(utf16("t;x\n1;2\n", true)), "t;x\n1;2\n");
  EXPECT_EQ(utf8_of(std::string("\xFE\xFF\x03\xBC", 4)), "\u03bc");
}

TEST(Encoding, BytesThatAreNoTextAreRefused) {
  EXPECT_THROW(utf8_of(std::string_view("1,2\0", 4)), Fault);
  EXPECT_THROW(utf8_of(std::string_view("\xB5\0", 2)), Fault);
}

}  // namespace
}  // namespace rubsweep::table
