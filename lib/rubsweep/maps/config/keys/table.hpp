#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <concepts>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "rubsweep/core/model/key.hpp"
#include "rubsweep/core/vocabulary.hpp"
#include "rubsweep/maps/config/keys/form.hpp"

namespace rubsweep::config::keys {

/// Form of the values that a key may have, made from its entry in the struct's list of fields.
inline Form form_of(const model::Range& range) { return number(range); }
inline Form form_of(const model::IntegerRange& range) {
  return range.even ? even_integer(range.low, range.high) : integer(range.low, range.high);
}
inline Form form_of(const model::IntegerOr& range) {
  return any_of({word({std::string(range.word)}), integer(range.low, range.high)});
}
inline Form form_of(const model::NumberOrList& range) {
  return any_of({number(range), list_of(number(range), 1, range.most)});
}
inline Form form_of(const model::NumberPair&) { return list_of(number(model::any_finite), 2, 2); }
template <class Enum, std::size_t count>
Form form_of(const Words<Enum, count>& words) {
  return word({words.texts.begin(), words.texts.end()});
}

/// Default value as text; empty where there is no default.
inline std::string written(double value, const model::Range&) { return fmt::format("{}", value); }
inline std::string written(const auto&, const auto&) { return ""; }
inline std::string written(std::signed_integral auto value, const model::IntegerRange&) {
  return std::to_string(value);
}
template <class Enum, std::size_t count>
std::string written(Enum value, const Words<Enum, count>& words) {
  for (std::size_t i = 0; i < count; ++i) {
    if (words.values[i] == value) return std::string(words.texts[i]);
  }
  return "";
}

/// Keys of a map, gathered from the list of fields that reader and printer use. A NaN double has no default.
class Table {
 public:
  template <class Field, class Allowed>
  void field(std::string_view name, const Field& member, const model::Key<Allowed>& key) {
    const Allowed& allowed = key;
    Key& entry = add(name, form_of(allowed), key.meaning, key.since);
    if constexpr (std::same_as<Field, double>) entry.required = member != member;
    if (key.without == model::needed) entry.required = true;
    if (!entry.required) entry.fallback = key.without.empty() ? written(member, allowed) : key.without;
  }

  /// Adds a map that must be given; `visit` is called with the table of its keys.
  template <class Visit>
  void map(std::string_view name, std::string_view meaning, Visit&& visit) {
    Table inner;
    visit(inner);
    add(name, map_of(inner.take()), meaning, "0.1.0").required = true;
  }

  /// Adds keys by `visit` that are allowed only where the key `selector` has one of these words. `selector`
  /// must have a default and must have been added before.
  template <class Visit>
  void beside(std::string_view selector, const std::vector<std::string>& words, bool, Visit&& visit) {
    const std::size_t first = keys_.size();
    const auto by = std::ranges::find(keys_, selector, &Key::name);
    const bool by_default = by != keys_.end() && std::ranges::find(words, by->fallback) != words.end();
    visit();
    for (std::size_t i = first; i < keys_.size(); ++i)
      keys_[i].when = {std::string(selector), words, by_default};
  }

  std::vector<Key> take() { return std::move(keys_); }

 private:
  Key& add(std::string_view name, Form form, std::string_view meaning, std::string_view since) {
    Key key{.name = std::string(name), .form = std::move(form), .meaning = std::string(meaning)};
    key.since = since;
    return keys_.emplace_back(std::move(key));
  }

  std::vector<Key> keys_;
};

/// The keys that `visit` adds to a table.
std::vector<Key> keys_by(auto&& visit) {
  Table table;
  visit(table);
  return table.take();
}

/// The keys that the struct's own lists name.
template <class Struct>
std::vector<Key> keys_of() {
  Table table;
  const Struct defaults{};
  const auto visit = model::fields_into(table);
  if constexpr (requires { Struct::visit_keys(defaults, table); }) {
    Struct::visit_keys(defaults, table);
  } else {
    Struct::visit_fields(defaults, visit);
  }
  if constexpr (requires { Struct::visit_words(defaults, visit); }) Struct::visit_words(defaults, visit);
  return table.take();
}

/// Keys of each alternative of a variant.
template <class Variant>
struct KeysOf;
template <class... Structs>
struct KeysOf<std::variant<Structs...>> {
  std::vector<std::vector<Key>> ways{keys_of<Structs>()...};
};

/// Joins the lists of keys of several parts.
inline std::vector<Key> joined(std::vector<std::vector<Key>> parts) {
  std::vector<Key> keys;
  for (std::vector<Key>& part : parts) std::ranges::move(part, std::back_inserter(keys));
  return keys;
}

}  // namespace rubsweep::config::keys
