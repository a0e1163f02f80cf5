#include "rubsweep/maps/batch/sha256.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

namespace rubsweep::batch {
namespace {

std::string digits_of(std::string_view text, std::size_t piece) {
  Sha256 sum;
  for (; !text.empty(); text.remove_prefix(std::min(piece, text.size()))) sum.add(text.substr(0, piece));
  return sum.digits();
}

/// Examples from FIPS 180-4 and from NIST's file of examples.
TEST(Sha256, HasTheDigitsOfTheStandard) {
  const std::pair<std::string, std::string> examples[]{
      {"", "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"},
      {"abc", "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"},
      {"abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq",
       "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1"},
      {std::string(1000000, 'a'), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0"}};
  for (const auto& [text, digits] : examples) {
    for (const std::size_t piece : {std::size_t{1}, std::size_t{63}, std::size_t{64}, std::size_t{1000}})
      EXPECT_EQ(digits_of(text, piece), digits) << text.size() << ' ' << piece;
  }
}

/// The text length fits into the last block, or needs one more.
TEST(Sha256, OfTextsAroundTheEndOfABlock) {
  EXPECT_EQ(digits_of(std::string(55, 'x'), 55),
            "d5e285683cd4efc02d021a5c62014694958901005d6f71e89e0989fac77e4072");
  EXPECT_EQ(digits_of(std::string(56, 'x'), 56),
            "04c26261370ee7541549d16dee320c723e3fd14671e66a099afe0a377c16888e");
  EXPECT_EQ(digits_of(std::string(64, 'x'), 64),
            "7ce100971f64e7001e8fe5a51973ecdfe1ced42befe7ee8d5fd6219506b5393c");
}

constexpr std::string_view page = "<!doctype html>\n<p>1.5\n</html>\n";

/// The checksum equals that of `sed '/^<!-- sha256 /d' page.html | sha256sum`.
TEST(Sha256PageSum, StandsInTheSecondLine) {
  EXPECT_EQ(with_page_sum(page),
            "<!doctype html>\n"
            "<!-- sha256 1350fecc816735cec5723e729002cc908ea4c1b54f3b67fc27a84d303bf4e7e2 -->\n"
            "<p>1.5\n</html>\n");
  EXPECT_EQ(check_page(with_page_sum(page)), PageSum::right);
  EXPECT_EQ(check_page(page), PageSum::none);
  EXPECT_EQ(check_page(""), PageSum::none);
  EXPECT_EQ(check_page(with_page_sum("<html>")), PageSum::none);  // no line end, so no place for it
}

TEST(Sha256PageSum, EveryOtherByteIsFound) {
  const std::string whole = with_page_sum(page);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::string other = whole;
    other[i] = other[i] == '7' ? '8' : '7';
    EXPECT_NE(check_page(other), PageSum::right) << i;
    EXPECT_NE(check_page(whole.substr(0, i)), PageSum::right) << i;
  }
}

TEST(Sha256PageSum, EndsOfLinesInCrLfChangeNothing) {
  std::string other;
  for (const char c : with_page_sum(page)) other += c == '\n' ? "\r\n" : std::string(1, c);
  EXPECT_EQ(check_page(other), PageSum::right);
  EXPECT_EQ(without_carriage_returns("a\r\nb\rc\r\n"), "a\nb\rc\n");
  EXPECT_EQ(without_carriage_returns("a\nb\r\n"), "a\nb\r\n");
}

}  // namespace
}  // namespace rubsweep::batch
