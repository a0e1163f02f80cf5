#include "rubsweep/maps/config/yaml/text.hpp"

#include <gtest/gtest.h>

namespace rubsweep::config::yaml {
namespace {

TEST(TextUtf8Length, CountsTheBytesOfASequence) {
  EXPECT_EQ(utf8_length("ab"), 1U);
  EXPECT_EQ(utf8_length("\xC3\xA9x"), 2U);
  EXPECT_EQ(utf8_length("\xE2\x82\xAC"), 3U);
  EXPECT_EQ(utf8_length("\xF4\x8F\xBF\xBF"), 4U);
}

TEST(TextUtf8Length, IsZeroWithoutOne) {
  for (const char* text : {"", "\x80", "\xC3", "\xC3(", "\xC0\x80", "\xE0\x80\x80", "\xED\xA0\x80",
                           "\xF0\x80\x80\x80", "\xF4\x90\x80\x80", "\xF8\x88\x80\x80\x80", "\xFF"}) {
    EXPECT_EQ(utf8_length(text), 0U) << text;
  }
}

TEST(TextFirstUnreadableByte, FindsStrayBytesAndControlCharacters) {
  EXPECT_EQ(first_unreadable_byte("a\tb\r\n\xC3\xA9"), std::nullopt);
  EXPECT_EQ(first_unreadable_byte("ab\xFF"), 2U);
  EXPECT_EQ(first_unreadable_byte("\xC3\xA9\x04"), 2U);
  EXPECT_EQ(first_unreadable_byte("a\x7f"), 1U);
  EXPECT_EQ(first_unreadable_byte(std::string_view("a\0b", 3)), 1U);
}

TEST(TextShown, FitsOneLine) {
  EXPECT_EQ(shown("a\nb\xFF\xC3\xA9"), "a\\x0ab\\xff\xC3\xA9");
  EXPECT_EQ(shown(std::string(60, 'a')), std::string(60, 'a'));
  EXPECT_EQ(shown(std::string(61, 'a')), std::string(60, 'a') + "...");
  EXPECT_EQ(shown("abcdef", 3), "abc...");
}

TEST(TextChildPath, JoinsByDots) {
  EXPECT_EQ(child_path("", "a"), "a");
  EXPECT_EQ(child_path("a.0", "b"), "a.0.b");
  EXPECT_EQ(child_path("a", ""), "a.''");
  EXPECT_EQ(child_path("a", "x\ny"), "a.x\\x0ay");
}

}  // namespace
}  // namespace rubsweep::config::yaml
