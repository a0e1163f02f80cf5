#include "rubsweep/measurement/recording/recording_file.hpp"

#include <fmt/format.h>
#include <sndfile.h>

#include <algorithm>
#include <array>
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
#include "rubsweep/maps/table/head.hpp"
#include "rubsweep/maps/table/rows.hpp"
#include "rubsweep/measurement/recording/tdms_file.hpp"
#include "rubsweep/measurement/recording/universal_file.hpp"

namespace rubsweep::recording {
namespace {

using matlab::Variable;
/// Largest number of channels in one matrix; larger matrices are pictures.
constexpr std::size_t most_channels = 256;

std::string why_left_out(const Variable& variable) {
  if (variable.kind == Variable::Kind::structure)
    return variable.fields.empty() ? "is empty, or lies deeper than 8 structures" : "";
  if (variable.kind == Variable::Kind::other) return "holds no numbers";
  if (variable.complex) return "is complex";
  if (variable.dims.size() != 2) return "has " + std::to_string(variable.dims.size()) + " dimensions";
  if (std::min(variable.dims[0], variable.dims[1]) > most_channels)
    return "is " + std::to_string(variable.dims[0]) + " x " + std::to_string(variable.dims[1]) +
           ", more than " + std::to_string(most_channels) + " signals";
  return "";
}

void add_variable(Channels& table, Variable& variable, const std::string& name) {
  if (std::string why = why_left_out(variable); !why.empty()) {
    table.left_out.push_back({name, std::move(why)});
    return;
  }
  for (Variable& field : variable.fields) {
    const bool counted = field.name.starts_with('(') || field.name.starts_with('{');
    add_variable(table, field, name + (counted ? "" : ".") + field.name);
  }
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

/// Sampling rate in a single number beside the signals, recognised by its name; empty where two such numbers
/// differ.
std::optional<double> rate_of_settings(const Channels& table) {
  std::optional<double> said;
  for (const Channel& channel : table.channels) {
    if (channel.values.size() != 1) continue;
    const std::string_view name = channel.name;
    const std::size_t dot = name.rfind('.');
    const auto rate = table::rate_of(dot == std::string_view::npos ? name : name.substr(dot + 1),
                                     fmt::format("{}", channel.values.front()));
    if (rate && said && *rate != *said) return std::nullopt;
    if (rate) said = rate;
  }
  return said;
}

struct Close {
  void operator()(SNDFILE* file) const { sf_close(file); }
};

constexpr sf_count_t frames_at_once = 4096;

/// File size according to the header of a RIFF file; empty where the header gives none, as in streams.
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

/// A name in UTF-8 without control characters, whatever bytes a damaged file has in its place.
std::string name_in(const std::string& bytes) { return table::utf8_of(table::printable(bytes)); }

}  // namespace

Channels read_matlab_file(std::string_view bytes, const std::string& name) {
  Channels table;
  try {
    auto variables = matlab::read_variables(bytes, [](const Variable& variable) {
      return variable.is_real_matrix() && why_left_out(variable).empty();
    });
    for (Variable& variable : variables) add_variable(table, variable, variable.name);
  } catch (const matlab::FileError& error) {
    throw ConfigError(name + ": " + error.wrong + ", allowed: " + error.allowed);
  }
  std::size_t longest = 2;
  for (const Channel& channel : table.channels) longest = std::max(longest, channel.values.size());
  table.sampling_rate_hz = rate_of_settings(table);
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

namespace {

Channels read_any(const std::filesystem::path& file, std::string_view bytes) {
  const bool sound = bytes.starts_with("RIFF") || bytes.starts_with("RIFX") || bytes.starts_with("RF64");
  if (sound) return read_sound_file(file);
  // MATLAB's own HDF5 files begin with a text instead of the HDF5 signature.
  if (bytes.starts_with("\x89HDF"))
    throw ConfigError(file.string() +
                      ": is HDF5 without MATLAB's head, allowed: a MATLAB file of version 4, 5 or 7.3, which "
                      "Octave writes with save -v7");
  if (bytes.starts_with("TDSm")) return read_tdms_file(bytes, file.string());
  if (is_universal_file(bytes)) return read_universal_file(bytes, file.string());
  // Files of version 4 have no signature at their begin; only the ending of their name shows the format.
  if (bytes.starts_with("MATLAB ") || file.extension() == ".mat")
    return read_matlab_file(bytes, file.string());
  batch::check_table_text(bytes, file);  // a table written by one of these programs may also be a recording
  return read_delimited_text(bytes, file.string());
}

}  // namespace

Channels read_recording_file(const std::filesystem::path& file, std::string_view bytes) {
  Channels table = read_any(file, bytes);
  for (Channel& channel : table.channels) {
    channel.name = name_in(channel.name);
    channel.unit = name_in(channel.unit);
  }
  for (Channels::LeftOut& one : table.left_out) one.name = name_in(one.name);
  return table;
}

ReadRecording read_recording(const std::filesystem::path& file, const std::filesystem::path& instrument_file,
                             FindTurns turns_of_sweep) {
  const std::string description = config::yaml::read_config_bytes(instrument_file);
  Instrument instrument = config::recording::read_instrument_text(description, instrument_file.string());
  const std::string bytes = batch::read_input(file);
  const Channels channels = read_recording_file(file, bytes);
  std::optional<FollowedTurns> followed;
  if (instrument.sweep && turns_of_sweep) followed = turns_of_sweep(channels, instrument, file.string());
  Recording recording = make_recording(channels, instrument, file.string(), followed ? &*followed : nullptr);
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
