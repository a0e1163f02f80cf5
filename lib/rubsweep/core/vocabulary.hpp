#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace rubsweep {

/// All enumerators of `Enum`, in their order. They count from 0 without gaps. `word_of` (a constexpr function
/// of one enumerator that returns a std::string_view) has a word for each of them and an empty one for any
/// other number. Where `word_of` is a switch without a default, the compiler rejects a forgotten enumerator,
/// so that this list is always complete.
template <class Enum, auto word_of>
inline constexpr auto enumerators_of = [] {
  constexpr std::size_t count = [] {
    std::size_t found = 0;
    while (!word_of(static_cast<Enum>(found)).empty()) ++found;
    return found;
  }();
  std::array<Enum, count> enumerators{};
  for (std::size_t i = 0; i < count; ++i) enumerators[i] = static_cast<Enum>(i);
  return enumerators;
}();

/// Words that stand for the values of an enumeration in files. Reader and printer share one table.
template <class Enum, std::size_t count>
struct Words {
  std::array<std::string_view, count> texts;
  std::array<Enum, count> values;
};

/// Words of all values of an enumeration, by its function `to_string`.
template <class Enum>
constexpr auto words_of() {
  constexpr auto word = [](Enum value) { return to_string(value); };
  constexpr auto& values = enumerators_of<Enum, word>;
  Words<Enum, values.size()> words{{}, values};
  std::ranges::transform(values, words.texts.begin(), word);
  return words;
}

inline constexpr Words<bool, 2> off_or_on{{"off", "on"}, {false, true}};

}  // namespace rubsweep
