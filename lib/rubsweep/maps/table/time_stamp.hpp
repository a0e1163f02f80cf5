#pragma once

#include <optional>
#include <string_view>

#include "rubsweep/maps/table/cell.hpp"

namespace rubsweep::table {

/// Seconds since midnight, or since 1970 where there is a date before a blank or T: year-month-day,
/// day.month.year, day-month-year with the month in letters, year/month/day, or month/day/year, where the
/// month is the second number if the first one is above 12. AM and PM may follow, and a zone: Z, UTC or
/// +01:00, which is counted. Nothing where the cell is no time stamp.
std::optional<double> time_stamp_in(std::string_view cell, const NumberStyle& style);

}  // namespace rubsweep::table
