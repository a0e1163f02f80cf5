#include "rubsweep/sweep/row.hpp"

#include <fmt/format.h>

namespace rubsweep::sweep {

std::string motion_name(const Row& row) {
  const std::string_view word = to_string(row.motion_class);
  return row.order.value_or(1) > 1 ? fmt::format("{} 1/{}", word, *row.order) : std::string(word);
}

}  // namespace rubsweep::sweep
