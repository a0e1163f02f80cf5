#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/maps/batch/csv_table.hpp"
#include "rubsweep/measurement/fit/measured_data.hpp"

namespace rubsweep::fit {

/// Rows of numbers from a table. A table in the programs' own form is read as strictly as by the other
/// readers. A foreign table (table/layout.hpp) must have corresponding names and units: "Time [ms]" is t_s,
/// "Speed (rpm)" is speed_hz, "sensor_0 [um]" is sensor_0_m.
class MeasuredTable {
 public:
  /// Opens a table that has the column `needed`. Throws the IoError of the programs' own reader where neither
  /// form has this column, and ConfigError with file:line:column for a cell of a foreign table that is not a
  /// number.
  MeasuredTable(const std::filesystem::path& file, std::string_view needed);

  const std::filesystem::path& path() const { return path_; }
  const std::vector<std::string>& header() const { return own_ ? own_->header() : header_; }
  std::size_t column(std::string_view name) const;
  bool next();
  double number(std::size_t column) const;
  batch::CsvReader::RowPosition place() const;

 private:
  bool read_of_somebody(std::string_view needed);

  std::filesystem::path path_;
  std::optional<batch::CsvReader> own_;
  std::vector<std::string> header_;
  std::vector<std::vector<double>> rows_;
  std::vector<std::size_t> lines_;
  std::size_t row_ = 0;  ///< line number from 1; 0: before the first row
};

/// Ramp of a shaft with these speeds at 4 or more ascending instants. Where rows are whole turns apart, as in
/// rubscope's tables, the ramp is computed from the instants, because they are known better than the speeds.
/// The degree of the fitted polynomial is chosen from the data. If its speed is a straight line within 2e-4,
/// the ramp has a constant rate; otherwise its speeds at the rows are the knots. Speeds that deviate from the
/// polynomial by more than 2 % of their change are taken from row to row.
Ramp measured_ramp(const std::vector<double>& t_s, const std::vector<double>& speed_hz);

}  // namespace rubsweep::fit
