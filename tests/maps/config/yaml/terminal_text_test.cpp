#include "rubsweep/maps/config/yaml/terminal_text.hpp"

#include <gtest/gtest.h>

namespace rubsweep::config::yaml {
namespace {

TEST(TerminalText, KeepsLinesAndLetters) {
  EXPECT_EQ(printable("rotor: ω = 100\n\tµ 0,1\n"), "rotor: ω = 100\n\tµ 0,1\n");
  EXPECT_EQ(printable(""), "");
}

TEST(TerminalText, ShowsWhatATerminalWouldObey) {
  EXPECT_EQ(printable("a\x1b[31mb"), "a\\x1b[31mb");
  EXPECT_EQ(printable("\r\a\x7f"), "\\x0d\\x07\\x7f");
  EXPECT_EQ(printable("\xc2\x9b"
                      "2J"),
            "\\xc2\\x9b2J");                     // U+009B, an escape sequence in one character
  EXPECT_EQ(printable("\xc2\xa0"), "\xc2\xa0");  // U+00A0 is a blank
}

TEST(TerminalText, ShowsStrayBytes) {
  EXPECT_EQ(printable("\xff\xc3"), "\\xff\\xc3");
  EXPECT_EQ(printable("\x9b"), "\\x9b");
}

TEST(TerminalText, AreThoseOfEveryMessageAsItWasShown) {
  const std::size_t before = said_lines().size();
  say("one\ntwo\n\n");
  say("th\x1bree");
  const auto lines = said_lines();
  EXPECT_EQ(std::vector<std::string>(lines.begin() + static_cast<std::ptrdiff_t>(before), lines.end()),
            (std::vector<std::string>{"one", "two", "th\\x1bree"}));
}

TEST(TerminalText, AreAThousandAtMost) {
  for (int i = 0; i < 1100; ++i) remember_lines("line\n");
  EXPECT_EQ(said_lines().size(), 1000);
}

}  // namespace
}  // namespace rubsweep::config::yaml
