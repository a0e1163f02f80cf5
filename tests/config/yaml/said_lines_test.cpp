#include "rubsweep/config/yaml/said_lines.hpp"

#include <gtest/gtest.h>

#include "rubsweep/config/yaml/terminal_text.hpp"

namespace rubsweep::config::yaml {
namespace {

TEST(SaidLines, AreThoseOfEveryMessageAsItWasShown) {
  const std::size_t before = said_lines().size();
  say("one\ntwo\n\n");
  say("th\x1bree");
  const auto lines = said_lines();
  EXPECT_EQ(std::vector<std::string>(lines.begin() + static_cast<std::ptrdiff_t>(before), lines.end()),
            (std::vector<std::string>{"one", "two", "th\\x1bree"}));
}

TEST(SaidLines, AreAThousandAtMost) {
  for (int i = 0; i < 1100; ++i) remember_lines("line\n");
  EXPECT_EQ(said_lines().size(), 1000);
}

}  // namespace
}  // namespace rubsweep::config::yaml
