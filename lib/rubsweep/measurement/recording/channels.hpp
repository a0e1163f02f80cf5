#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/maps/table/unit.hpp"
#include "rubsweep/measurement/recording/instrument.hpp"

namespace rubsweep::recording {

/// One column of an instrument's file.
struct Channel {
  std::string name;            ///< name without its unit
  std::string unit;            ///< unit as written, without brackets; empty: none
  std::vector<double> values;  ///< NaN is a gap: an empty cell or a cell with "NaN"
  std::size_t number = 0;      ///< column of a text, counted from 1; 0: the position in the list of channels

  bool is_empty() const {
    return std::ranges::all_of(values, [](double value) { return std::isnan(value); });
  }
};

/// Columns of one file: one or more, all of the same length of at least two values.
struct Channels {
  std::vector<Channel> channels;
  /// line number of every row in a text, counted from 1; empty where the file is no text
  std::vector<std::size_t> line{};
  std::optional<double> sampling_rate_hz{};  ///< rate given by the file; empty: none
  /// Names of columns or variables that are not signals, with the reasons, such as "holds text".
  struct LeftOut {
    std::string name, why;
  };
  std::vector<LeftOut> left_out{};
  std::vector<std::string> notes{};  ///< sentences, without a full stop, about ignored parts of the file

  std::size_t rows() const { return channels.front().values.size(); }
  /// List of the columns that were left out, such as " ('a' holds text, 'b' is complex)"; at most about one
  /// line long.
  std::string left_out_text() const {
    constexpr std::size_t most = 6;
    std::string text;
    for (std::size_t i = 0; i < left_out.size() && i < most; ++i)
      text += (i == 0 ? "'" : ", '") + left_out[i].name + "' " + left_out[i].why;
    if (left_out.size() > most) text += " and others";
    return text.empty() ? text : " (" + text + ')';
  }
  /// Place of a row, counted from 0, for messages: "line 7" of a text, "reading 5" of other files.
  std::string place_of(std::size_t row) const {
    return line.empty() ? "reading " + std::to_string(row + 1) : "line " + std::to_string(line[row]);
  }
};

/// Unit of a sound file's readings: shares of the converter's full scale, from -1 to 1.
inline constexpr const char* full_scale_unit = "FS";

/// Unit given by the ending _s or _m of a name, as in the programs' own tables; empty for other names.
inline std::string unit_in_ending(std::string_view name) {
  return name.ends_with("_s") || name.ends_with("_m") ? std::string(1, name.back()) : std::string();
}

/// Seconds per unit of a time column: s (also without a unit), ms, us or µs. Throws ConfigError with the
/// names of file and column for any other unit.
double seconds_per(const std::string& unit, const std::string& column, const std::string& file);

/// Quantity that a probe measures, conversion of its readings to m, m/s or m/s^2, and the value at which they
/// are cut off.
struct Scale {
  table::Quantity quantity = table::Quantity::length;  ///< or velocity, or acceleration
  double si_per_unit = 1;
  std::optional<double> full_scale{};  ///< full scale in the unit of the column
};

/// Scale of a probe's column. Its unit is one of a length, a velocity or an acceleration; V or mV with one of
/// the gains; or FS, shares of a full scale range_v, which needs gain and range_v. `unit` is the column's
/// unless the probe gives another one. Throws ConfigError like seconds_per.
Scale scale_of(const std::string& unit, const Probe& probe, const std::string& file);

}  // namespace rubsweep::recording
