#include "rubsweep/maps/config/keys/table.hpp"

#include <fmt/format.h>

namespace rubsweep::config::keys {

std::string written(double value, const model::Range&) { return fmt::format("{}", value); }

Key& Table::add(std::string_view name, Form form, std::string_view meaning, std::string_view since) {
  Key& key = keys_.emplace_back();
  key.name = name;
  key.form = std::move(form);
  key.meaning = meaning;
  key.since = since;
  return key;
}

std::vector<Key> joined(std::vector<std::vector<Key>> parts) {
  std::vector<Key> keys;
  for (std::vector<Key>& part : parts) {
    for (Key& key : part) keys.push_back(std::move(key));
  }
  return keys;
}

}  // namespace rubsweep::config::keys
