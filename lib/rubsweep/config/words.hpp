#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace rubsweep::config {

/// Words of the file for the values of an enumeration. Reader and printer share one table.
template <class Enum, std::size_t count>
struct Words {
  std::array<std::string_view, count> texts;
  std::array<Enum, count> values;
};

}  // namespace rubsweep::config
