#include "rubsweep/maps/config/keys/fields.hpp"

#include <fmt/format.h>

#include <utility>

namespace rubsweep::config::keys {

std::string shortest(double number) { return fmt::format("{}", number); }

std::vector<Key> joined(std::vector<std::vector<Key>> parts) {
  std::vector<Key> keys;
  for (std::vector<Key>& part : parts) {
    for (Key& key : part) keys.push_back(std::move(key));
  }
  return keys;
}

}  // namespace rubsweep::config::keys
