#include "rubsweep/core/model/support_table.hpp"

#include <fmt/format.h>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/model/physical_range.hpp"

namespace rubsweep::model {

Range range_of_column(std::size_t column) {
  const char kind = support_coefficients[column].front();
  return kind == 'k'   ? physical::cross_stiffness
         : kind == 'c' ? physical::cross_damping
                       : physical::added_mass_kg;
}

void validate(const SupportTable& table, const std::string& path) {
  const std::size_t points = table.speed_hz.size();
  if (points == 0 || points > SupportTable::most_points)
    throw ConfigError(
        fmt::format("{}speed_hz: has {} numbers, allowed: 1 to {}", path, points, SupportTable::most_points));
  for (std::size_t i = 0; i < points; ++i) {
    const bool rises = i == 0 ? table.speed_hz[0] >= 0 : table.speed_hz[i] > table.speed_hz[i - 1];
    if (!rises || !contains(any_finite, table.speed_hz[i]))
      throw ConfigError(
          fmt::format("{}speed_hz.{}: {} does not rise from 0 or more, allowed: speeds that rise", path, i,
                      table.speed_hz[i]));
  }
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const std::string name = path + std::string(support_coefficients[c]);
    if (table.columns[c].size() != points)
      throw ConfigError(fmt::format("{}: has {} numbers, allowed: {}, as many as there are speeds", name,
                                    table.columns[c].size(), points));
    for (const double value : table.columns[c]) {
      if (!contains(range_of_column(c), value))
        throw ConfigError(fmt::format("{}: {} is out of range, allowed: {}", name, value,
                                      describe(range_of_column(c), value)));
    }
  }
}

}  // namespace rubsweep::model
