#pragma once

/// \file
/// A recording of shaft motion by an instrument, combined with the data of its probes, and judged.
/// read_recording_file reads text tables, MATLAB and WAV files. read_instrument_text reads the YAML that
/// names columns, angles and units. make_recording samples whole turns at equal angles, in metres, as x + iy
/// of two probes. scope::judge tells how the motion repeats and lists its lines, each with its uncertainty,
/// and the noise limit. ConfigError names file, line and column.
///
/// ```cpp
/// using namespace rubsweep;
/// std::string table = "t_s,x [um],mark\n";
/// for (int k = 0; k < 40000; ++k)
///   table += std::to_string(k * 1e-4) + ',' +
///            std::to_string(20 * std::sin(2 * std::numbers::pi * 25 * 1e-4 * k)) + ',' +
///            (k % 400 < 8 ? "1" : "0") + '\n';
/// const auto instrument = config::recording::read_instrument_text(
///     "probes: [{column: x, angle_deg: 0}]\nkeyphasor: {column: mark, threshold: 0.5}\ntime: t_s",
///     "mine.yaml");
/// const auto channels = recording::read_delimited_text(table, "mine.csv");
/// const auto measured = recording::make_recording(channels, instrument, "mine.csv");
/// const auto verdict = scope::judge(measured);
/// std::printf("%s at %g Hz\n", std::string(to_string(verdict.motion)).c_str(), measured.mean_speed_hz());
/// ```

#include "rubsweep/measurement/recording/instrument.hpp"
#include "rubsweep/measurement/recording/recording.hpp"
#include "rubsweep/measurement/recording/recording_file.hpp"
#include "rubsweep/measurement/scope/verdict.hpp"
