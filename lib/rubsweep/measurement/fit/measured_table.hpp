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

/// Numbers of a table row by row: one of the programs' own, read as strictly as they are everywhere, or one
/// of somebody else (table/layout.hpp) whose names and units say the same: "Time [ms]" is t_s, "Speed (rpm)"
/// speed_hz, "sensor_0 [um]" sensor_0_m.
class MeasuredTable {
 public:
  /// Table that has the column called `needed`. Throws IoError, of the program's own reader, where there is
  /// none in either way, ConfigError with file:line:column for a number of somebody else that is none.
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
  std::size_t row_ = 0;  ///< line number from 1; 0: before the first one
};

/// Ramp of a shaft with these speeds at ascending instants, 4 or more. Where rows are whole turns apart, as
/// those of rubscope are, their instants tell it, which are better known than speeds. A polynomial goes
/// through them, of a degree that the data ask for: where it is a straight line of speeds to
/// two ten-thousandths, the ramp is even, else its speeds at the rows are knots. Speeds that are off the
/// polynomial by more than 2 % of their change are followed from row to row.
Ramp measured_ramp(const std::vector<double>& t_s, const std::vector<double>& speed_hz);

}  // namespace rubsweep::fit
