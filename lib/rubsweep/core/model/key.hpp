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

/// Integers, or a word in place of them.
struct IntegerOr : IntegerRange {
  std::string_view word;
};

/// A number, or a list of at most so many.
struct NumberOrList : Range {
  std::size_t most;
};

/// Allowed values of a key of a configuration (one of these, a Range or Words), and what a person is told of
/// it. The struct that holds the value lists its keys; reader, printer, schema and list of keys go by that
/// list.
template <class Allowed>
struct Key : Allowed {
  std::string_view meaning;  ///< a noun and what is needed besides, without unit and range
  std::string_view
      without;  ///< default in words of the file or, in parentheses, of people; empty: the member's
  std::string_view since;  ///< version that knew it first
};

template <class Allowed>
constexpr Key<Allowed> key(const Allowed& allowed, std::string_view meaning, std::string_view without = "",
                           std::string_view since = "0.1.0") {
  return {allowed, meaning, without, since};
}

/// Meant as `without` of an integer or a word that must be given all the same.
inline constexpr std::string_view needed = "needed";

/// A key that the version after 0.1.0 was the first to know.
template <class Allowed>
constexpr Key<Allowed> newer_key(const Allowed& allowed, std::string_view meaning,
                                 std::string_view without = "") {
  return {allowed, meaning, without, "0.2.0"};
}

/// Name of the first key of a struct that makes its own list.
template <class Struct>
constexpr std::string_view name_of() {
  std::string_view first;
  const Struct any{};
  Struct::visit_fields(any, [&](std::string_view name, const auto&, const auto&) {
    if (first.empty()) first = name;
  });
  return first;
}

/// Visitor that hands every key on to the `field` of a section, a printer or a table.
auto fields_into(auto& keys) {
  return [&keys](std::string_view name, auto& field, const auto& key) { keys.field(name, field, key); };
}

}  // namespace rubsweep::model
