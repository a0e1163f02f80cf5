#pragma once

#include <optional>
#include <string_view>

#include "rubsweep/maps/table/cell.hpp"

namespace rubsweep::table {

/// Seconds since midnight, or since 1970 where there is a date before a blank or T. Dates are year-month-day,
/// day.month.year, day-month-year with the month in letters, year/month/day, or month/day/year (the month is
/// the second number if the first one is above 12). AM or PM may follow, and a zone such as Z, UTC or +01:00,
/// which is taken into account. Empty where the cell is no time stamp.
std::optional<double> time_stamp_in(std::string_view cell, const NumberStyle& style);

}  // namespace rubsweep::table
