#include "rubsweep/maps/config/yaml/text.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

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

TEST(TextTerminalText, KeepsLinesAndLetters) {
  EXPECT_EQ(printable("rotor: ω = 100\n\tµ 0,1\n"), "rotor: ω = 100\n\tµ 0,1\n");
  EXPECT_EQ(printable(""), "");
}

TEST(TextTerminalText, ShowsWhatATerminalWouldObey) {
  EXPECT_EQ(printable("a\x1b[31mb"), "a\\x1b[31mb");
  EXPECT_EQ(printable("\r\a\x7f"), "\\x0d\\x07\\x7f");
  EXPECT_EQ(printable("\xc2\x9b"
                      "2J"),
            "\\xc2\\x9b2J");                     // U+009B introduces an escape sequence
  EXPECT_EQ(printable("\xc2\xa0"), "\xc2\xa0");  // U+00A0 is a blank
}

TEST(TextTerminalText, ShowsStrayBytes) {
  EXPECT_EQ(printable("\xff\xc3"), "\\xff\\xc3");
  EXPECT_EQ(printable("\x9b"), "\\x9b");
}

TEST(TextTerminalText, AreThoseOfEveryMessageAsItWasShown) {
  const std::size_t before = said_lines().size();
  say("one\ntwo\n\n");
  say("th\x1bree");
  const auto lines = said_lines();
  EXPECT_EQ(std::vector<std::string>(lines.begin() + static_cast<std::ptrdiff_t>(before), lines.end()),
            (std::vector<std::string>{"one", "two", "th\\x1bree"}));
}

TEST(TextTerminalText, AreAThousandAtMost) {
  for (int i = 0; i < 1100; ++i) remember_lines("line\n");
  EXPECT_EQ(said_lines().size(), 1000);
}

constexpr std::array<std::string_view, 5> names{"mass_kg", "stiffness_n_per_m", "restitution",
                                                "restitution_delivered", "kind"};

TEST(TextNearest, FindsAMisspeltName) {
  EXPECT_EQ(nearest("mas_kg", names), "mass_kg");
  EXPECT_EQ(nearest("mass_gk", names), "mass_kg");
  EXPECT_EQ(nearest("stifness_n_per_m", names), "stiffness_n_per_m");
  EXPECT_EQ(nearest("resitution_deliverd", names), "restitution_delivered");
  EXPECT_EQ(nearest("kin", names), "kind");
  EXPECT_EQ(nearest("kindd", names), "kind");
}

TEST(TextNearest, FindsANameWithoutItsUnit) {
  EXPECT_EQ(nearest("mass", names), "mass_kg");
  EXPECT_EQ(nearest("stiffness", names), "stiffness_n_per_m");
  constexpr std::array<std::string_view, 2> longest_first{"speed_of_sound_m_per_s", "speed_hz"};
  EXPECT_EQ(nearest("speed", longest_first), "speed_hz");
}

TEST(TextNearest, PrefersTheSmallerDistanceThenTheFirstListed) {
  constexpr std::array<std::string_view, 3> similar{"casings", "casino", "casing"};
  EXPECT_EQ(nearest("casin", similar), "casino");
  EXPECT_EQ(nearest("casingss", similar), "casings");
}

TEST(TextNearest, FindsNothingFarAway) {
  EXPECT_EQ(nearest("gravity", names), std::nullopt);
  EXPECT_EQ(nearest("", names), std::nullopt);
  EXPECT_EQ(nearest(std::string(100'000, 'm'), names), std::nullopt);
  EXPECT_EQ(nearest("kind", {}), std::nullopt);
}

TEST(TextNumberParse, TakesDecimalNumbers) {
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

TEST(TextNumberParse, RefusesOtherWords) {
  for (const char* word :
       {"",    "-",    ".",   "e5",  "1_000", "0x10",  "1,5", "1e",  "1e+", "--1",  "+-1", "1 ", " 1",
        "1 2", "true", "yes", "0o7", "1:30",  "1.2.3", "1f",  "1d0", "one", "nano", "-in", "+"}) {
    EXPECT_EQ(parse_number(word).error, NumberError::not_a_number) << word;
  }
}

TEST(TextNumberParse, TellsInfinityAndNan) {
  for (const char* word :
       {".inf", "-.inf", "+.Inf", ".INF", ".nan", ".NaN", "inf", "-inf", "nan", "Infinity"}) {
    EXPECT_EQ(parse_number(word).error, NumberError::not_finite) << word;
  }
}

TEST(TextNumberParse, TellsWhatNoDoubleHolds) {
  for (const char* word : {"1e400", "-1e400", "1e-400"}) {
    EXPECT_EQ(parse_number(word).error, NumberError::does_not_fit) << word;
  }
}

}  // namespace
}  // namespace rubsweep::config::yaml
