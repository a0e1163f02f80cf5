#include "rubsweep/maps/config/yaml/number.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace rubsweep::config::yaml {
namespace {

TEST(NumberParse, TakesDecimalNumbers) {
  const struct {
    const char* word;
    double value;
  } cases[] = {
      {"1", 1.0},       {"+1", 1.0},        {"-1", -1.0},
      {"1.", 1.0},      {".5", 0.5},        {"-.5", -0.5},
      {"1e-3", 0.001},  {"2.0e6", 2e6},     {"2.0E+06", 2e6},
      {"007", 7.0},     {"0", 0.0},         {"0.1", 0.1},
      {"1e308", 1e308}, {"5e-324", 5e-324}, {"1.7976931348623157e+308", std::numeric_limits<double>::max()}};
  for (const auto& [word, value] : cases) {
    const ParsedNumber number = parse_number(word);
    EXPECT_EQ(number.error, NumberError::none) << word;
    EXPECT_EQ(number.value, value) << word;
  }
  EXPECT_TRUE(std::signbit(parse_number("-0").value));
}

TEST(NumberParse, RefusesOtherWords) {
  for (const char* word :
       {"",    "-",    ".",   "e5",  "1_000", "0x10",  "1,5", "1e",  "1e+", "--1",  "+-1", "1 ", " 1",
        "1 2", "true", "yes", "0o7", "1:30",  "1.2.3", "1f",  "1d0", "one", "nano", "-in", "+"}) {
    EXPECT_EQ(parse_number(word).error, NumberError::not_a_number) << word;
  }
}

TEST(NumberParse, TellsInfinityAndNan) {
  for (const char* word :
       {".inf", "-.inf", "+.Inf", ".INF", ".nan", ".NaN", "inf", "-inf", "nan", "Infinity"}) {
    EXPECT_EQ(parse_number(word).error, NumberError::not_finite) << word;
  }
}

TEST(NumberParse, TellsWhatNoDoubleHolds) {
  for (const char* word : {"1e400", "-1e400", "1e-400"}) {
    EXPECT_EQ(parse_number(word).error, NumberError::does_not_fit) << word;
  }
}

}  // namespace
}  // namespace rubsweep::config::yaml
