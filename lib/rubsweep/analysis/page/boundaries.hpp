#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace rubsweep::page {

/// A line across the map, such as the edge of a domain.
struct Boundary {
  std::string family;  ///< name of its family
  std::string kind;    ///< of the event there; may be empty
  std::vector<std::array<double, 2>>
      points;  ///< speed in Hz and unbalance in the unit of the map's second axis
};

/// Reads the lines of boundaries.csv: a header with a column `speed_hz` and one of the unbalance, called
/// `measure` (whirl_ratio or eccentricity_m) or else `unbalance` with or without a unit behind it. Where
/// there are columns `family` and `kind`, consecutive rows that agree in both belong to one line; a row
/// without numbers ends a line; rows are in the order of the line. Other columns are not looked at. Empty
/// where there is no such file, or where it says that it is of a map of another `digest`. Throws IoError,
/// with file:line where the text is at fault.
std::vector<Boundary> read_boundaries(const std::filesystem::path& path, std::string_view measure,
                                      std::string_view digest);

}  // namespace rubsweep::page
