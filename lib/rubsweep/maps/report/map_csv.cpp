#include "rubsweep/maps/report/map_csv.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "rubsweep/maps/batch/csv_table.hpp"
#include "rubsweep/maps/report/map_columns.hpp"
#include "rubsweep/maps/report/study_columns.hpp"

namespace rubsweep::report {

std::string map_header(const sweep::Study& study) {
  std::vector<std::string> names;
  for (const MapColumn& column : map_columns()) names.emplace_back(column.name);
  for (std::string& name : sweep::key_names(study.grid)) names.push_back(std::move(name));
  for (const StudyColumn& column : study_columns(study)) names.emplace_back(column.name);
  return batch::csv_row(names);
}

std::string map_line(const sweep::Row& row, const sweep::Study& study) {
  std::vector<std::string> cells;
  for (const MapColumn& column : map_columns()) cells.push_back(column.text(row));
  for (const double value : row.key_values) cells.push_back(batch::csv_number(value));
  for (const StudyColumn& column : study_columns(study)) cells.push_back(column.text(row));
  return batch::csv_row(cells);
}

std::string map_comments(const sweep::Study& study) {
  const std::vector<std::string> keys = sweep::key_names(study.grid);
  return fmt::format(
      "# units: SI, named in the columns; orders and ratios are pure numbers; forward whirl is positive\n"
      "{}",
      keys.empty() ? "" : fmt::format("# keys {}\n", batch::csv_row(keys)));
}

}  // namespace rubsweep::report
