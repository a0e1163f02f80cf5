#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/measurement/recording/turn_marks.hpp"

namespace rubsweep::recording {

/// A displacement probe.
struct Probe {
  std::string column;    ///< name of its column
  double angle_deg = 0;  ///< direction in which the probe looks, from +x towards +y
  /// Gain of a column in volts, not 0; negative where a larger gap gives a smaller voltage.
  std::optional<double> gain_mv_per_um{};
  std::optional<std::string> unit{};  ///< replaces the unit in the file, or supplies a missing one
  std::optional<double> rest{};       ///< reading at rest, in the column's unit; given for all probes or none
  std::optional<double>
      range_v{};  ///< > 0: voltage of the converter's full scale, where readings are clipped
};

struct Keyphasor {
  std::string column;
  Mark mark = Mark::dark;
  std::optional<double> threshold{};  ///< threshold in the column's unit; empty: middle_threshold
  double hysteresis = 0;              ///< hysteresis in the column's unit, >= 0
  int pulses_per_turn = 1;  ///< number of marks per turn; the first mark of a recording is the shaft's
};

/// A column of the shaft's speed.
struct SpeedColumn {
  std::string column;
  std::optional<std::string> unit{};  ///< replaces the unit in the file, or supplies a missing one
  double factor = 1;                  ///< speed of the shaft / speed in the column
};

/// Interval at slow speed, in the recording's time, in which the probes see run-out but no vibration.
struct RunOut {
  double from_s = 0, to_s = 0;
  bool vector = false;  ///< subtracts only its 1X, not the whole waveform
};

/// Everything about a recording that its numbers do not contain. Times come from the column `time`, from the
/// sampling rate or, where neither is given, from the file. Turns come from one source: the keyphasor, a
/// constant speed, or a column of speeds.
struct Instrument {
  std::optional<std::string> time{};
  std::optional<double> sampling_rate_hz{};  ///< > 0
  std::vector<Probe> probes{};               ///< one, or two that look in different directions
  std::optional<Keyphasor> keyphasor{};
  std::optional<double> from_s{}, to_s{};  ///< evaluated interval, in the recording's time
  std::optional<double> speed_hz{};        ///< > 0
  std::optional<SpeedColumn> speed{};
  std::optional<RunOut> run_out{};  ///< run-out with a keyphasor
};

}  // namespace rubsweep::recording

namespace rubsweep::config::recording {

/// Reads the description of a recording: probes (a list of one or two, each with column, angle_deg and
/// perhaps gain_mv_per_um, unit, range_v), keyphasor (column, mark, threshold, hysteresis, pulses_per_turn),
/// speed_hz or speed (a column, or column and unit), time (the name of a column) or sampling_rate_hz or
/// neither; from_s, to_s; run_out (from_s, to_s, subtract). `name` stands for the file in messages. Throws
/// ConfigError with every problem.
rubsweep::recording::Instrument read_instrument_text(std::string_view text, const std::string& name);

}  // namespace rubsweep::config::recording
