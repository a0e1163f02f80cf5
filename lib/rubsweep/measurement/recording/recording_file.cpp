#include "rubsweep/measurement/recording/recording_file.hpp"

#include <sndfile.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/opened_file.hpp"
#include "rubsweep/maps/batch/table_file.hpp"
#include "rubsweep/maps/config/yaml/base.hpp"
#include "rubsweep/maps/matlab/read_file.hpp"
#include "rubsweep/maps/table/rows.hpp"

namespace rubsweep::recording {
namespace {

using matlab::Variable;
using table::Fault;

/// Changes time stamps to seconds since the first one; stamps without a date may pass midnight.
void count_from_first(std::vector<double>& stamps_s) {
  constexpr double day_s = 86400;
  const double first_s = stamps_s.front();
  double midnights = 0, before_s = 0;
  for (double& t_s : stamps_s) {
    t_s -= first_s;
    if (t_s + midnights * day_s < before_s - day_s / 2) ++midnights;
    t_s += midnights * day_s;
    before_s = t_s;
  }
}

/// Cells of the line that begins with `key` in a LabVIEW header; empty where there is none.
std::vector<std::string_view> labview_line(std::string_view text, char separator, std::string_view key) {
  while (!text.empty()) {
    const auto cells = table::cells_of(table::take_line(text), separator);
    if (cells.front() == key) return cells;
    if (cells.front() == "X_Value") break;
  }
  return {};
}

/// Reads units and sampling rate from the header of a LabVIEW measurement. Throws Fault for a file that is
/// not a single table.
void read_labview_head(std::string_view text, const table::Layout& layout, Channels& table) {
  std::size_t sections = 0, line = 0;
  for (std::string_view rest = text; !rest.empty();) {
    ++line;
    if (table::take_line(rest).starts_with("X_Value") && ++sections > 1)
      throw Fault{line, 1, "begins another segment of LabVIEW", "one segment in a file"};
  }
  const auto said = [&](std::string_view key) { return labview_line(text, layout.separator, key); };
  if (const auto columns = said("X_Columns"); columns.size() > 1 && columns[1] == "Multi")
    throw Fault{1, 1, "has times of its own for each signal, X_Columns Multi", "X_Columns One or No"};
  const auto units = said("Y_Unit_Label");
  for (std::size_t i = 1; i < std::min(units.size(), layout.columns.size()); ++i)
    for (Channel& channel : table.channels)
      if (channel.name == layout.columns[i].heading.name && channel.unit.empty()) channel.unit = units[i];
  if (const auto steps = said("Delta_X"); steps.size() > 1) {
    std::string step(steps[1]);
    std::ranges::replace(step, ',', '.');
    const double step_s = table::number_in(step, {}).value_or(0);
    if (step_s > 0) table.sampling_rate_hz = 1 / step_s;
  }
}

Channels read_text(std::string_view text) {
  const table::Layout layout = table::layout_of(text);
  table::Rows rows(text, layout);
  Channels table;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < layout.columns.size(); ++i) {
    const table::Column& column = layout.columns[i];
    const std::string name =
        column.heading.name.empty() ? "column " + std::to_string(i + 1) : column.heading.name;
    if (column.is_text) {
      table.left_out.push_back({name, column.text_line > 0
                                          ? "holds text, as in line " + std::to_string(column.text_line)
                                          : "holds text"});
      continue;
    }
    places.push_back(i);
    table.channels.push_back({name, column.heading.unit, {}});
    if (column.heading.unit.empty()) table.channels.back().unit = unit_in_ending(name);
  }
  bool stamps = false;
  while (rows.next()) {
    if (table.line.empty()) stamps = rows.begins_with_stamp();
    table.line.push_back(rows.line());
    for (std::size_t i = 0; i < places.size(); ++i) {
      double value = NAN;
      if (places[i] < rows.cells().size())
        value = places[i] == 0 && stamps ? rows.time_stamp() : rows.number(places[i]);
      table.channels[i].values.push_back(value);
    }
  }
  if (table.line.size() < 2) throw Fault{table.line.front(), 1, "is the only row of numbers", "two or more"};
  if (stamps) {
    count_from_first(table.channels.front().values);
    table.channels.front().unit = std::string("s");
  }
  if (text.starts_with("LabVIEW Measurement")) read_labview_head(text, layout, table);
  return table;
}

/// Largest number of channels in a matrix; a picture has more.
constexpr std::size_t most_channels = 256;

std::string why_left_out(const Variable& variable, bool in_structure) {
  if (variable.kind == Variable::Kind::structure) return in_structure ? "is a structure in a structure" : "";
  if (variable.kind == Variable::Kind::other) return "holds no numbers";
  if (variable.complex) return "is complex";
  if (variable.dims.size() != 2) return "has " + std::to_string(variable.dims.size()) + " dimensions";
  if (std::min(variable.dims[0], variable.dims[1]) > most_channels)
    return "is " + std::to_string(variable.dims[0]) + " x " + std::to_string(variable.dims[1]) +
           ", more than " + std::to_string(most_channels) + " signals";
  return "";
}

void add_variable(Channels& table, Variable& variable, const std::string& name, bool in_structure) {
  if (std::string why = why_left_out(variable, in_structure); !why.empty()) {
    table.left_out.push_back({name, std::move(why)});
    return;
  }
  for (Variable& field : variable.fields) add_variable(table, field, name + '.' + field.name, true);
  if (variable.kind != Variable::Kind::numbers) return;
  const std::size_t rows = variable.dims[0], columns = variable.dims[1];
  if (rows == 0 || columns == 0) return;
  if (rows == 1 || columns == 1) {
    table.channels.push_back({name, unit_in_ending(name), std::move(variable.values)});
    return;
  }
  const bool along_rows = columns > rows;
  for (std::size_t i = 0; i < std::min(rows, columns); ++i) {
    std::vector<double> values;
    for (std::size_t k = 0; k < std::max(rows, columns); ++k)
      values.push_back(variable.values[along_rows ? k * rows + i : i * rows + k]);
    const std::string one = name + '_' + std::to_string(i + 1);
    table.channels.push_back({one, unit_in_ending(one), std::move(values)});
  }
}

struct Close {
  void operator()(SNDFILE* file) const { sf_close(file); }
};

constexpr sf_count_t frames_at_once = 4096;

/// File size according to the header of a RIFF file; empty where the header leaves it open, as streams do.
std::optional<std::uintmax_t> said_bytes(const std::filesystem::path& file) {
  std::array<unsigned char, 8> head{};
  std::ifstream stream(file, std::ios::binary);
  if (!stream.read(reinterpret_cast<char*>(head.data()), head.size()) || head[0] != 'R' || head[3] != 'F')
    return std::nullopt;
  constexpr std::uintmax_t open = 0x7fffffff;
  const std::uintmax_t size =
      head[4] + 256u * head[5] + 65536u * head[6] + 16777216u * static_cast<std::uintmax_t>(head[7]);
  if (size == 0 || size >= open) return std::nullopt;
  return size + head.size();
}

}  // namespace

Channels read_delimited_text(std::string_view bytes, const std::string& name) {
  try {
    return read_text(table::utf8_of(bytes));
  } catch (const Fault& fault) {
    throw ConfigError(name + ':' + std::to_string(fault.line) + ':' + std::to_string(fault.column) + ": " +
                      fault.wrong + ", allowed: " + fault.allowed);
  }
}

Channels read_matlab_file(std::string_view bytes, const std::string& name) {
  Channels table;
  try {
    auto variables = matlab::read_variables(bytes, [](const Variable& variable) {
      return variable.is_real_matrix() && why_left_out(variable, false).empty();
    });
    for (Variable& variable : variables) add_variable(table, variable, variable.name, false);
  } catch (const matlab::FileError& error) {
    throw ConfigError(name + ": " + error.wrong + ", allowed: " + error.allowed);
  }
  std::size_t longest = 2;
  for (const Channel& channel : table.channels) longest = std::max(longest, channel.values.size());
  std::erase_if(table.channels, [&](const Channel& channel) {
    const std::size_t count = channel.values.size();
    if (count < longest)
      table.left_out.push_back(
          {channel.name, "has " + std::to_string(count) + " of " + std::to_string(longest) + " numbers"});
    return count < longest;
  });
  if (table.channels.empty())
    throw ConfigError(name + ": holds no signal" + table.left_out_text() +
                      ", allowed: real numeric vectors or matrices, or structures of them");
  return table;
}

Channels read_recording_file(const std::filesystem::path& file, std::string_view bytes) {
  const bool sound = bytes.starts_with("RIFF") || bytes.starts_with("RIFX") || bytes.starts_with("RF64");
  if (sound) return read_sound_file(file);
  // MATLAB's own HDF5 files begin with a text instead of the HDF5 signature.
  if (bytes.starts_with("\x89HDF"))
    throw ConfigError(file.string() +
                      ": is HDF5 without MATLAB's head, allowed: a MATLAB file of version 4, 5 or 7.3, which "
                      "Octave writes with save -v7");
  if (bytes.starts_with("TDSm"))
    throw ConfigError(file.string() +
                      ": is a file of LabVIEW's TDMS, allowed: its signals as a table of text, "
                      "which LabVIEW, DIAdem and nptdms export");
  // Version 4 has no such text; only the file ending tells it.
  if (bytes.starts_with("MATLAB ") || file.extension() == ".mat")
    return read_matlab_file(bytes, file.string());
  batch::check_table_text(bytes, file);  // a table written by one of our programs may be a recording, too
  return read_delimited_text(bytes, file.string());
}

ReadRecording read_recording(const std::filesystem::path& file,
                             const std::filesystem::path& instrument_file) {
  const std::string description = config::yaml::read_config_bytes(instrument_file);
  Instrument instrument = config::recording::read_instrument_text(description, instrument_file.string());
  const std::string bytes = batch::read_input(file);
  Recording recording = make_recording(read_recording_file(file, bytes), instrument, file.string());
  return {std::move(recording), std::move(instrument), description + bytes};
}

Channels read_sound_file(const std::filesystem::path& file) {
  const std::string name = file.string();
  SF_INFO info{};
  const std::unique_ptr<SNDFILE, Close> open(sf_open(name.c_str(), SFM_READ, &info));
  if (!open) throw ConfigError(name + ": is damaged, " + sf_strerror(nullptr) + ", allowed: a WAV file");
  const auto said = said_bytes(file);
  if (const std::uintmax_t there = std::filesystem::file_size(file); said && there < *said)
    throw ConfigError(name + ": breaks off after " + std::to_string(there) + " of " + std::to_string(*said) +
                      " bytes, allowed: a whole WAV file");
  Channels table;
  table.sampling_rate_hz = info.samplerate;
  const auto count = static_cast<std::size_t>(info.channels);
  for (std::size_t i = 0; i < count; ++i)
    table.channels.push_back({"channel " + std::to_string(i + 1), full_scale_unit, {}});
  std::vector<double> frames(static_cast<std::size_t>(frames_at_once) * count);
  sf_count_t read = 0, all = 0;
  while ((read = sf_readf_double(open.get(), frames.data(), frames_at_once)) > 0) {
    all += read;
    for (std::size_t k = 0; k < static_cast<std::size_t>(read) * count; ++k)
      table.channels[k % count].values.push_back(frames[k]);
  }
  if (all < info.frames)
    throw ConfigError(name + ": breaks off after " + std::to_string(all) + " of " +
                      std::to_string(info.frames) + " readings, allowed: a whole WAV file");
  if (all < 2) throw ConfigError(name + ": has " + std::to_string(all) + " readings, allowed: two or more");
  return table;
}

}  // namespace rubsweep::recording
