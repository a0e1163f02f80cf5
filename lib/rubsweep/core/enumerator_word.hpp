#pragma once

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

}  // namespace rubsweep
