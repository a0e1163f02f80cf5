#include "rubsweep/maps/config/yaml/alternatives.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>

#include "rubsweep/maps/config/yaml/text.hpp"

namespace rubsweep::config::yaml {
namespace {

using keys::Choice;
using keys::Way;

bool needs(const Way& way, std::string_view key) { return std::ranges::count(way.required, key) > 0; }

bool holds(const Way& way, std::string_view key) {
  return needs(way, key) || std::ranges::count(way.optional, key) > 0;
}

/// Whether `of` holds for any of the choice's ways.
bool any_way(const Choice& choice, auto&& of) { return std::ranges::any_of(choice.ways, of); }

bool exclude_each_other(const Choice& choice, std::string_view a, std::string_view b) {
  const auto stands = [&](const Way& way, std::string_view key) {
    return key == choice.replaces ? needs(way, key) : holds(way, key);
  };
  return any_way(choice, [&](const Way& way) { return holds(way, a); }) &&
         any_way(choice, [&](const Way& way) { return holds(way, b); }) &&
         !any_way(choice, [&](const Way& way) { return stands(way, a) && stands(way, b); });
}

/// Whether a key was used together with `gone` and is of no use together with `written`.
bool goes_with(const Choice& choice, std::string_view key, std::string_view gone, std::string_view written) {
  return any_way(choice, [&](const Way& way) { return holds(way, key) && holds(way, gone); }) &&
         (any_way(choice, [&](const Way& way) { return holds(way, written) && !holds(way, key); }) ||
          !any_way(choice, [&](const Way& way) { return needs(way, key); }));
}

void drop_other_ways(const Choice& choice, std::string_view written, Node& map) {
  struct Dropped {
    std::string key;
    int override_index;
  };
  const auto drop_if = [&](auto&& is_of_no_use) {
    std::vector<Dropped> dropped;
    for (std::size_t i = map.keys.size(); i-- > 0;) {
      if (map.keys[i].text == written || !is_of_no_use(i)) continue;
      dropped.push_back({map.keys[i].text, map.keys[i].place.override_index});
      drop_entry(map, i);
    }
    return dropped;
  };
  const std::vector<Dropped> excluded =
      drop_if([&](std::size_t i) { return exclude_each_other(choice, written, map.keys[i].text); });
  // A key stays if another override than that of the removed key wrote it, since it was then written for
  // something else.
  drop_if([&](std::size_t i) {
    const int from = map.keys[i].place.override_index;
    return std::ranges::any_of(excluded, [&](const Dropped& gone) {
      return (from < 0 || from == gone.override_index) &&
             goes_with(choice, map.keys[i].text, gone.key, written);
    });
  });
}

}  // namespace

Alternatives::Alternatives(const keys::Form& root) { gather(root); }

void Alternatives::gather(const keys::Form& form) {
  if (form.kind == keys::Kind::map) {
    Kind& kind = kinds_.emplace_back();
    for (const keys::Key& key : form.keys) kind.keys.push_back(key.name);
    kind.choices = form.choices;
  }
  for (const keys::Form& inner : form.forms) gather(inner);
  for (const keys::Key& key : form.keys) gather(key.form);
}

void Alternatives::drop(Node& map, std::string_view written) const {
  std::vector<const Kind*> likely;
  std::ptrdiff_t most = 0;
  for (const Kind& kind : kinds_) {
    const auto is_known = [&](std::string_view key) { return std::ranges::count(kind.keys, key) > 0; };
    if (!is_known(written)) continue;
    const std::ptrdiff_t known = 1 + std::ranges::count_if(map.keys, is_known, &Node::Key::text);
    if (known > most) likely.clear();
    most = std::max(most, known);
    if (known == most) likely.push_back(&kind);
  }
  for (const Kind* kind : likely)
    for (const Choice& choice : kind->choices) drop_other_ways(choice, written, map);
}

void drop_entry(Node& map, std::size_t index) {
  map.keys.erase(map.keys.begin() + static_cast<std::ptrdiff_t>(index));
  map.items.erase(map.items.begin() + static_cast<std::ptrdiff_t>(index));
}

void refuse_repeated_keys(const Node& map, std::string_view path, Diagnostics& diagnostics) {
  std::map<std::string_view, SourcePosition> first;
  for (const Node::Key& key : map.keys) {
    const auto [entry, is_new] = first.emplace(key.text, key.place);
    if (is_new) continue;
    const bool in_file = key.place.override_index < 0;
    const std::string first_line = in_file ? fmt::format(", first at line {}", entry->second.line) : "";
    diagnostics.add(key.place, child_path(path, key.text), "given again" + first_line, "each key once");
  }
}

void drop_repeated_keys(Node& map) {
  for (std::size_t i = map.keys.size(); i-- > 0;) {
    const auto is_equal = [&](const Node::Key& key) { return key.text == map.keys[i].text; };
    const auto end = map.keys.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::any_of(map.keys.begin(), end, is_equal)) drop_entry(map, i);
  }
}

}  // namespace rubsweep::config::yaml
