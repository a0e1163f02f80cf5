#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <utility>

namespace rubsweep {

/// Name of an enumerator as its enumeration writes it, from what the compiler calls this function; empty for
/// a number that is none of them.
template <auto value>
consteval std::string_view enumerator_name() {
  constexpr std::string_view before = "value = ", function = __PRETTY_FUNCTION__;
  constexpr std::size_t begin = function.find(before) + before.size();
  constexpr std::string_view name = function.substr(begin, function.find_first_of(";]", begin) - begin);
  // A number without a name is written as a cast.
  return name.starts_with('(') ? std::string_view{} : name.substr(name.rfind(':') + 1);
}

/// Word of a file for a value of an enumeration, which is its name there: no list can be short of one.
/// Enumerators count from 0 without gaps, and there are at most 32.
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

/// All enumerators of `Enum`, in their order. They count from 0 without gaps, and `word_of` (a constexpr
/// function of one enumerator that returns a std::string_view) has a word for each of them and none for any
/// other number. Where `word_of` is a switch without a default, the compiler refuses an enumerator that was
/// forgotten there, so that a list made from this one is never short of one.
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

/// Words of a file for the values of an enumeration. Reader and printer share one table.
template <class Enum, std::size_t count>
struct Words {
  std::array<std::string_view, count> texts;
  std::array<Enum, count> values;
};

/// The words that `to_string` has for every value of an enumeration; without such a function the names that
/// these have there.
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
