#pragma once

#include <cstddef>
#include <string_view>

#include "rubsweep/core/model/range.hpp"

namespace rubsweep::model {

/// Closed interval of allowed integers.
struct IntegerRange {
  long low;
  long high;
  bool even = false;  ///< true: odd numbers are not allowed
};

/// Range of integers, with a word as an alternative.
struct IntegerOr : IntegerRange {
  std::string_view word;
};

/// A number, or a list of at most `most` numbers.
struct NumberOrList : Range {
  std::size_t most;
};

/// A list of two finite numbers, x and y.
struct NumberPair {};

/// Allowed values of a configuration key (one of these structs, a Range or Words) and its description for the
/// user. The struct that holds the value lists its keys; reader, printer, schema and table of keys all use
/// that list.
template <class Allowed>
struct Key : Allowed {
  std::string_view meaning;  ///< a noun with any condition, without unit and range
  std::string_view without;  ///< default as in the file, or in parentheses a description; empty: the member's
  std::string_view since;    ///< first version that knew the key
};

template <class Allowed>
constexpr Key<Allowed> key(const Allowed& allowed, std::string_view meaning, std::string_view without = "",
                           std::string_view since = "0.1.0") {
  return {allowed, meaning, without, since};
}

/// Value of `without` for an integer or a word that has no default.
inline constexpr std::string_view needed = "needed";

/// A key that was introduced with version 0.2.0.
template <class Allowed>
constexpr Key<Allowed> newer_key(const Allowed& allowed, std::string_view meaning,
                                 std::string_view without = "") {
  return {allowed, meaning, without, "0.2.0"};
}

/// Name of the first key of a struct that lists its own keys.
template <class Struct>
constexpr std::string_view name_of() {
  std::string_view first;
  const Struct any{};
  Struct::visit_fields(any, [&](std::string_view name, const auto&, const auto&) {
    if (first.empty()) first = name;
  });
  return first;
}

/// Visitor that passes every key to the function `field` of a section, a printer or a table.
auto fields_into(auto& keys) {
  return [&keys](std::string_view name, auto& field, const auto& key) { keys.field(name, field, key); };
}

}  // namespace rubsweep::model
