#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <utility>

namespace rubsweep {

/// Name of an enumerator as its enumeration writes it, taken from the compiler's name of this function. Empty
/// for a number that is no enumerator.
template <auto value>
consteval std::string_view enumerator_name() {
  constexpr std::string_view before = "value = ", function = __PRETTY_FUNCTION__;
  constexpr std::size_t begin = function.find(before) + before.size();
  constexpr std::string_view name = function.substr(begin, function.find_first_of(";]", begin) - begin);
  // The compiler writes a number without an enumerator as a cast.
  return name.starts_with('(') ? std::string_view{} : name.substr(name.rfind(':') + 1);
}

/// Word of an enumerator in files: its own name, so that no list can miss one. Enumerators count from 0
/// without gaps, and there are at most 32.
template <class Enum>
constexpr std::string_view enumerator_word(Enum value) {
  constexpr auto words = []<std::size_t... i>(std::index_sequence<i...>) {
    return std::array{enumerator_name<static_cast<Enum>(i)>()...};
  }
  (std::make_index_sequence<33>{});
  static_assert(words.back().empty());
  const auto number = static_cast<std::size_t>(value);
  return number < words.size() ? words[number] : std::string_view{};
}

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

/// The words that `to_string` gives for every value of an enumeration; without such a function, the names of
/// the enumerators.
template <class Enum>
constexpr auto words_of() {
  constexpr auto word = [](Enum value) -> std::string_view {
    if constexpr (requires { to_string(value); })
      return to_string(value);
    else
      return enumerator_word(value);
  };
  constexpr auto& values = enumerators_of<Enum, word>;
  Words<Enum, values.size()> words{{}, values};
  std::ranges::transform(values, words.texts.begin(), word);
  return words;
}

inline constexpr Words<bool, 2> off_or_on{{"off", "on"}, {false, true}};

}  // namespace rubsweep
