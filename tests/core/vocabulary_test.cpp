#include "rubsweep/core/vocabulary.hpp"

#include <gtest/gtest.h>

namespace rubsweep::named {

enum class Colour { red, light_blue, green_2 };
constexpr std::string_view to_string(Colour colour) { return enumerator_word(colour); }

namespace {

TEST(Vocabulary, IsTheNameOfTheEnumerator) {
  EXPECT_EQ(to_string(Colour::red), "red");
  EXPECT_EQ(to_string(Colour::light_blue), "light_blue");
  EXPECT_EQ(to_string(Colour::green_2), "green_2");
}

TEST(Vocabulary, IsEmptyForOtherNumbers) {
  for (const int number : {-1, 3, 31, 32, 1000}) EXPECT_EQ(to_string(static_cast<Colour>(number)), "");
}

TEST(Vocabulary, MakesTheWordsOfAFile) {
  constexpr auto words = words_of<Colour>();
  ASSERT_EQ(words.texts.size(), 3U);
  EXPECT_EQ(words.texts[1], "light_blue");
  EXPECT_EQ(words.values[2], Colour::green_2);
}

}  // namespace
}  // namespace rubsweep::named
