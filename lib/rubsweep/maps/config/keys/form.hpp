#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/core/model/range.hpp"

namespace rubsweep::config::keys {

struct Key;

/// Condition for a key: the key `selector` of the same map has one of `words`. If `without_selector` is true,
/// the condition also holds where the selector is left out, because its default is one of the words.
struct Condition {
  std::string selector;
  std::vector<std::string> words;  ///< words of the selector; empty: no condition
  bool without_selector = false;   ///< true: the selector has a default, which is one of the words
};

/// Keys that are given together: all of `required`, and any of `optional`. Such a way excludes the keys of
/// the other ways.
struct Way {
  std::vector<std::string> required, optional;
};

/// Alternative ways to give a quantity. Exactly one is used, or none where `may_be_none` is true.
struct Choice {
  std::vector<Way> ways;
  bool may_be_none = false;
  std::string replaces{};  ///< key that replaces ways in which it is optional, when it is written over them
};

/// Kind of value that may stand at a place.
enum class Kind {
  number,
  integer,
  word,      ///< a word out of `words`
  text,      ///< any scalar, of `least` to `most` bytes
  list,      ///< `least` to `most` values of the form `forms[0]`
  map,       ///< a map with these `keys`
  numbered,  ///< a map from numbers, 0 to `most` - 1, to values of the form `forms[0]`
  any_of     ///< any of `forms`
};

/// Values that are allowed at a place of a configuration.
struct Form {
  Kind kind = Kind::text;
  model::Range range{};                ///< range of a number
  long low = 0, high = 0;              ///< ends of an integer's range, both included
  bool even = false;                   ///< true: an integer must be even
  std::vector<std::string> words{};    ///< words that may stand there
  std::size_t least = 1, most = 4096;  ///< length of a list or a text
  bool different = false;              ///< true: a list has no value twice
  std::vector<Form> forms{};
  std::vector<Key> keys;          // no initialiser: Key is incomplete here
  std::vector<Choice> choices{};  ///< alternatives of a map
};

/// One key of a map.
struct Key {
  std::string name;
  Form form;
  std::string meaning;     ///< noun phrase with further requirements, without unit and range
  std::string fallback{};  ///< default as it is written; empty: see `required`
  /// the key has no default and must be given if its condition holds, unless a choice leaves it out
  bool required = false;
  Condition when{};
  std::string since = "0.1.0";  ///< version that knew it first
};

Form number(const model::Range& range);
Form integer(long low, long high);
Form even_integer(long low, long high);
Form word(std::vector<std::string> words);
Form one_of(std::span<const std::string_view> words);
Form text(std::size_t most = 4096);
Form list_of(Form item, std::size_t least, std::size_t most);
Form map_of(std::vector<Key> keys, std::vector<Choice> choices = {});
Form numbered(Form item, std::size_t count);
Form any_of(std::vector<Form> forms);

/// A key that must be given.
Key must(std::string name, Form form, std::string meaning);
/// A key with this default: as written in a file, or in words in parentheses; empty: no default.
Key may(std::string name, Form form, std::string meaning, std::string fallback = "");
/// Returns the key with the condition `when`.
Key beside(Key key, Condition when);
/// Returns the keys, marked as introduced after version 0.1.0.
std::vector<Key> newer(std::vector<Key> keys);
Key newer_key(Key key);

/// Ways of one key each.
Choice either(std::span<const std::string_view> names);
/// Choice between ways of several keys each. Keys with a default are optional in their way, the others
/// required.
Choice choice_of(const std::vector<std::vector<Key>>& ways);

/// Whether a key of a map belongs to one of the map's choices.
bool is_chosen(const Form& map, std::string_view name);

/// Allowed values in words, as errors say them: "> 0 and <= 1", "one_side or annular", "a list of 1 to 16".
std::string allowed(const Form& form);

/// Unit in the ending of a key, as people write it: "N/m" for stiffness_n_per_m; empty without a unit.
std::string_view unit_of(std::string_view key);

}  // namespace rubsweep::config::keys
