#include "rubsweep/maps/batch/page_sum.hpp"

#include <gtest/gtest.h>

namespace rubsweep::batch {
namespace {

constexpr std::string_view page = "<!doctype html>\n<p>1.5\n</html>\n";

/// The sum is that of `sed '/^<!-- sha256 /d' page.html | sha256sum`.
TEST(PageSum, StandsInTheSecondLine) {
  EXPECT_EQ(with_page_sum(page),
            "<!doctype html>\n"
            "<!-- sha256 1350fecc816735cec5723e729002cc908ea4c1b54f3b67fc27a84d303bf4e7e2 -->\n"
            "<p>1.5\n</html>\n");
  EXPECT_EQ(check_page(with_page_sum(page)), PageSum::right);
  EXPECT_EQ(check_page(page), PageSum::none);
  EXPECT_EQ(check_page(""), PageSum::none);
  EXPECT_EQ(check_page(with_page_sum("<html>")), PageSum::none);  // no line, no place for it
}

TEST(PageSum, EveryOtherByteIsFound) {
  const std::string whole = with_page_sum(page);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::string other = whole;
    other[i] = other[i] == '7' ? '8' : '7';
    EXPECT_NE(check_page(other), PageSum::right) << i;
    EXPECT_NE(check_page(whole.substr(0, i)), PageSum::right) << i;
  }
}

TEST(PageSum, EndsOfLinesInCrLfChangeNothing) {
  std::string other;
  for (const char c : with_page_sum(page)) other += c == '\n' ? "\r\n" : std::string(1, c);
  EXPECT_EQ(check_page(other), PageSum::right);
  EXPECT_EQ(without_carriage_returns("a\r\nb\rc\r\n"), "a\nb\rc\n");
  EXPECT_EQ(without_carriage_returns("a\nb\r\n"), "a\nb\r\n");
}

}  // namespace
}  // namespace rubsweep::batch
