#include "rubsweep/maps/config/yaml/section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "rubsweep/maps/config/yaml/alternatives.hpp"
#include "rubsweep/maps/config/yaml/text.hpp"

namespace rubsweep::config::yaml {

Section::Section(const Value& value, std::string_view allowed)
    : value_(value), problems_before_(value.diagnostics.count()) {
  const Node::Kind kind = value.node.kind;
  if (kind == Node::Kind::map) {
    refuse_repeated_keys(value.node, value.path, value.diagnostics);
  } else {
    yaml::refuse(value,
                 kind == Node::Kind::scalar ? describe(value.node) + " is not a map" : describe(value.node),
                 allowed);
  }
}

std::string Section::path_of(std::string_view name) const { return child_path(value_.path, name); }

std::optional<Value> Section::find(std::string_view name) {
  if (std::find(known_.begin(), known_.end(), name) == known_.end()) known_.push_back(name);
  const Node* node = lookup(name);
  if (node == nullptr) return std::nullopt;
  return Value{*node, path_of(name), value_.diagnostics};
}

std::optional<Value> Section::require(std::string_view name, std::string_view allowed) {
  auto value = find(name);
  if (!value && is_map()) value_.diagnostics.add(value_.node.place, path_of(name), "missing", allowed);
  return value;
}

void Section::require_exactly_one(std::span<const std::string_view> names) {
  if (!is_map()) return;
  const std::string allowed = "exactly one of " + describe(names);
  std::vector<std::string_view> given;
  for (const std::string_view name : names) {
    if (lookup(name) != nullptr) given.push_back(name);
  }
  if (given.empty()) yaml::refuse(value_, "one key is missing", allowed);
  if (given.size() < 2) return;
  std::stable_sort(given.begin(), given.end(), [this](std::string_view a, std::string_view b) {
    return lookup(a)->place < lookup(b)->place;
  });
  const std::string_view last = given.back();
  given.pop_back();
  std::string others;
  for (const std::string_view name : given) {
    others += fmt::format("{}{} ({})", others.empty() ? "" : ", ", name,
                          value_.diagnostics.describe(lookup(name)->place));
  }
  value_.diagnostics.add(lookup(last)->place, path_of(last), "given beside " + others, allowed);
}

void Section::field(std::string_view name, double& target, const model::Range& range) {
  const auto value = std::isnan(target) ? require(name, model::describe(range)) : find(name);
  if (!value) return;
  if (const auto number = read_number(*value, range)) target = *number;
}

void Section::field(std::string_view name, std::optional<double>& target, const model::Range& range) {
  if (const auto value = find(name)) target = read_number(*value, range);
}

void Section::field(std::string_view name, std::optional<int>& target, const model::IntegerOr& range) {
  const auto value = find(name);
  if (!value) return;
  if (value->node.kind == Node::Kind::scalar && value->node.text == range.word) {
    target.reset();
  } else if (const auto number = read_integer(*value, range)) {
    target = static_cast<int>(*number);
  }
}

void Section::field(std::string_view name, std::vector<double>& target, const model::NumberOrList& range) {
  const auto value = find(name);
  if (!value) return;
  if (value->node.kind == Node::Kind::list) {
    target = read_number_list(*value, range, range.most);
  } else if (const auto number = read_number(*value, range)) {
    target = {*number};
  }
}

std::optional<std::size_t> Section::require_kind(std::string_view name,
                                                 std::span<const std::string_view> kinds) {
  const auto value = require(name, describe(kinds));
  return value ? read_word(*value, kinds) : std::nullopt;
}

void Section::refuse_unknown_keys() {
  if (!std::exchange(refuses_unknown_, false)) return;
  std::set<std::string_view> unknown;
  for (const Node::Key& key : value_.node.keys) {
    if (std::find(known_.begin(), known_.end(), key.text) != known_.end()) continue;
    if (!unknown.insert(key.text).second) continue;
    const auto meant = nearest(key.text, known_);
    std::string hint = meant ? fmt::format(" (did you mean '{}'?)", *meant) : "";
    if (const auto blank = find_foreign_blank(key.text))
      hint = fmt::format(" with {}{}", describe_character(std::string_view(key.text).substr(*blank)), hint);
    value_.diagnostics.add(key.place, path_of(key.text), "unknown key" + hint, describe(known_));
  }
}

void Section::refuse_together(std::string_view name, std::initializer_list<std::string_view> involved,
                              std::string_view wrong, std::string_view allowed) const {
  SourcePosition place = value_.node.place;
  for (const std::string_view other : involved) {
    if (const Node* node = lookup(other)) place = std::max(place, node->place);
  }
  value_.diagnostics.add(place, path_of(name), wrong, allowed);
}

}  // namespace rubsweep::config::yaml
