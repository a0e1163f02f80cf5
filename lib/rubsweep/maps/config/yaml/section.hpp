#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/core/vocabulary.hpp"
#include "rubsweep/maps/config/yaml/value.hpp"

namespace rubsweep::config::yaml {

/// One map of a configuration. Remembers which keys were looked for, so that all others can be refused.
class Section {
 public:
  /// Refuses repeated keys, and a value that is not a map: such a section finds no key and requires none.
  /// `allowed` describes the possible content in words.
  explicit Section(const Value& value, std::string_view allowed = "a map");
  ~Section() { refuse_unknown_keys(); }
  Section(const Section&) = delete;
  Section& operator=(const Section&) = delete;

  /// False where the value is not a map; problems of its contents then need not be reported.
  bool is_map() const { return value_.node.kind == Node::Kind::map; }

  /// First value under this key, or empty. Makes the key a known one.
  std::optional<Value> find(std::string_view name);

  /// Whether the key is given. Does not make the key a known one.
  bool holds(std::string_view name) const { return lookup(name) != nullptr; }

  /// Like find, but a missing key is a problem.
  std::optional<Value> require(std::string_view name, std::string_view allowed);

  /// Adds a problem unless exactly one of these keys is given. If several are given, the problem names the
  /// place of each. Does not make them known.
  void require_exactly_one(std::span<const std::string_view> names);
  void require_exactly_one(std::initializer_list<std::string_view> names) {
    require_exactly_one(std::span(names.begin(), names.size()));
  }

  /// Reads a number. It is required where `target` is NaN (model::required) before the call.
  void field(std::string_view name, double& target, const model::Range& range);
  void field(std::string_view name, std::optional<double>& target, const model::Range& range);

  template <std::signed_integral Integer>
  void field(std::string_view name, Integer& target, const IntegerRange& range) {
    if (const auto value = find(name)) {
      if (const auto number = read_integer(*value, range)) target = static_cast<Integer>(*number);
    }
  }

  /// Reads an integer that may be required by its key.
  template <std::signed_integral Integer>
  void field(std::string_view name, Integer& target, const model::Key<IntegerRange>& key) {
    const IntegerRange& range = key;
    if (key.without != model::needed || require(name, describe(range))) field(name, target, range);
  }

  template <class Enum, std::size_t count>
  void field(std::string_view name, Enum& target, const Words<Enum, count>& words) {
    if (const auto value = find(name)) {
      if (const auto index = read_word(*value, words.texts)) target = words.values[*index];
    }
  }

  /// Reads an integer, or the word that stands for "none".
  void field(std::string_view name, std::optional<int>& target, const model::IntegerOr& range);
  void field(std::string_view name, std::vector<double>& target, const model::NumberOrList& range);
  void field(std::string_view name, std::array<double, 2>& target, const model::Key<model::NumberPair>& key) {
    const auto value = key.without == model::needed ? require(name, "a list of 2 numbers") : find(name);
    if (value) read_numbers(*value, target);
  }

  /// Reads a map that must be given; `visit` reads its keys.
  template <class Visit>
  void map(std::string_view name, std::string_view /*meaning*/, Visit&& visit) {
    const auto value = require(name, "a map");
    if (!value) return;
    Section inner(*value);
    visit(inner);
  }

  /// Reads keys that are allowed only if `holds` is true: only with certain words of another key.
  template <class Visit>
  void beside(std::string_view, const std::vector<std::string>&, bool holds, Visit&& visit) {
    if (holds) visit();
  }

  /// Index of the given word in `kinds`; the key must be given.
  std::optional<std::size_t> require_kind(std::string_view name, std::span<const std::string_view> kinds);

  /// Refuses every key that was never looked for, as the end of a section does unless all keys are allowed.
  void refuse_unknown_keys();
  void allow_unknown_keys() { refuses_unknown_ = false; }

  /// Reports a problem that several keys cause together. It is reported under `name`, at the place of the
  /// last of the keys `involved`.
  void refuse_together(std::string_view name, std::initializer_list<std::string_view> involved,
                       std::string_view wrong, std::string_view allowed) const;
  void refuse(std::string_view name, std::string_view wrong, std::string_view allowed) const {
    refuse_together(name, {name}, wrong, allowed);
  }

  /// True as long as the value is a map in which nothing was refused. Only then can its fields be checked
  /// together.
  bool is_sound() const { return is_map() && value_.diagnostics.count() == problems_before_; }

 private:
  const Node* lookup(std::string_view name) const { return entry(value_.node, name); }
  std::string path_of(std::string_view name) const;

  Value value_;
  std::size_t problems_before_;
  std::vector<std::string_view> known_;
  bool refuses_unknown_ = true;
};

/// Reads every field that the struct's own list names.
template <class Struct>
void read_fields(Section& section, Struct& target) {
  Struct::visit_fields(target, model::fields_into(section));
}

/// Reads a map that has the fields of the struct's own list and no other keys.
template <class Struct>
void read_map(const Value& value, Struct& target, std::string_view allowed = "a map") {
  Section section(value, allowed);
  read_fields(section, target);
}

}  // namespace rubsweep::config::yaml
