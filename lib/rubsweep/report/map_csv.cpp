#include "rubsweep/report/map_csv.hpp"

#include <fmt/format.h>

#include <vector>

#include "rubsweep/batch/csv_table.hpp"
#include "rubsweep/report/map_columns.hpp"

namespace rubsweep::report {

std::string map_header() {
  std::vector<std::string> names;
  for (const MapColumn& column : map_columns()) names.emplace_back(column.name);
  return batch::csv_row(names);
}

std::string map_line(const sweep::Row& row) {
  std::vector<std::string> cells;
  for (const MapColumn& column : map_columns()) cells.push_back(column.text(row));
  return batch::csv_row(cells);
}

std::string map_comments(const std::string& version, const std::string& digest) {
  return fmt::format(
      "# rubsweep {}\n"
      "# digest {}\n"
      "# units: SI, named in the columns; orders and ratios are pure numbers; forward whirl is positive\n",
      version, digest);
}

}  // namespace rubsweep::report
