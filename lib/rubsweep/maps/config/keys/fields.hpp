#pragma once

#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/maps/config/keys/form.hpp"

namespace rubsweep::config::keys {

/// Meaning of a field of a struct, and in words what happens without it where no default says so.
struct Meaning {
  std::string_view name, meaning, without = "";
};

/// Number as short as it can be written without another meaning.
std::string shortest(double number);

/// A key for each number that the struct's own list names: ranges and defaults are those of the struct, and
/// only meanings are said here. Throws std::logic_error where a field has no meaning, or a meaning no field.
template <class Struct>
std::vector<Key> fields_of(const std::vector<Meaning>& meanings) {
  std::vector<Key> keys;
  const Struct defaults{};
  const auto add = [&](std::string_view name, const auto& field, const model::Range& range) {
    for (const Meaning& one : meanings) {
      if (one.name != name) continue;
      Key key = may(std::string(name), number(range), std::string(one.meaning), std::string(one.without));
      if constexpr (std::is_same_v<std::decay_t<decltype(field)>, double>) {
        key.required = std::isnan(field);
        if (!key.required && key.fallback.empty()) key.fallback = shortest(field);
      }
      keys.push_back(std::move(key));
    }
  };
  std::size_t fields = 0;
  Struct::visit_fields(defaults, [&](std::string_view name, const auto& field, const model::Range& range) {
    add(name, field, range);
    ++fields;
  });
  if (keys.size() != fields || keys.size() != meanings.size())
    throw std::logic_error("fields and meanings of a section differ beside " +
                           std::string(meanings.empty() ? "" : meanings[0].name));
  return keys;
}

/// The keys of several parts, one behind the other.
std::vector<Key> joined(std::vector<std::vector<Key>> parts);

}  // namespace rubsweep::config::keys
