#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "rubsweep/core/vocabulary.hpp"

namespace rubsweep::config::yaml {

/// Words of the file for the values of an enumeration. Reader and printer share one table.
template <class Enum, std::size_t count = std::dynamic_extent>
struct Words {
  std::array<std::string_view, count> texts;
  std::array<Enum, count> values;
};

/// The same for an enumeration whose table is known at run time only.
template <class Enum>
struct Words<Enum, std::dynamic_extent> {
  std::vector<std::string_view> texts;
  std::vector<Enum> values;
};

/// The words that `to_string` has for every value of an enumeration.
template <class Enum>
constexpr auto words_of() {
  constexpr auto word = [](Enum value) { return to_string(value); };
  constexpr auto& values = enumerators_of<Enum, word>;
  Words<Enum, values.size()> words{{}, values};
  std::ranges::transform(values, words.texts.begin(), word);
  return words;
}

}  // namespace rubsweep::config::yaml
