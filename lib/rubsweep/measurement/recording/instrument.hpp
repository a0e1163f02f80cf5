#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/measurement/recording/turn_marks.hpp"

namespace rubsweep::recording {

/// Part on which a probe stands or at which it looks.
enum class Place {
  shaft,           ///< relative to the casing, as eddy-current probes
  shaft_absolute,  ///< relative to the ground
  casing           ///< casing or bearing, relative to the ground
};

/// Kinds of machines whose casings ISO 20816-3 judges by limits of their own.
enum class MachineGroup { large_rigid, large_flexible, medium_rigid, medium_flexible };

/// A probe of displacement, velocity or acceleration.
struct Probe {
  std::string column;    ///< name of its column
  double angle_deg = 0;  ///< direction in which the probe looks, from +x towards +y
  /// Gain of a column in volts, not 0; negative where a larger gap gives a smaller voltage.
  std::optional<double> gain_mv_per_um{};
  std::optional<std::string> unit{};  ///< replaces the unit in the file, or supplies a missing one
  std::optional<double> rest{};       ///< reading at rest, in the column's unit; given for all probes or none
  std::optional<double>
      range_v{};  ///< > 0: voltage of the converter's full scale, where readings are clipped
  /// Gains of columns in volts whose probes measure velocity or acceleration; one gain at most, not 0.
  std::optional<double> gain_mv_per_mm_per_s{}, gain_mv_per_g{};
  std::optional<Place> on{};  ///< empty: the shaft by displacement, else the casing
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

/// Speeds at the two ends of a run-up or coast-down without a mark, known to a quarter.
struct Sweep {
  double from_hz = 0, to_hz = 0;  ///< > 0
};

/// Interval at slow speed, in the recording's time, in which the probes see run-out but no vibration.
struct RunOut {
  double from_s = 0, to_s = 0;
  bool vector = false;  ///< subtracts only its 1X, not the whole waveform
};

/// All that has to be known of a recording beside its numbers. Times come from the column `time`, from the
/// sampling rate or, where neither is given, from the file; turns from the keyphasor, from the speed, from a
/// column of the speed or by the line of a sweep: one of these.
struct Instrument {
  std::optional<std::string> time{};
  std::optional<double> sampling_rate_hz{};  ///< > 0
  std::vector<Probe> probes{};               ///< one, or two that look in different directions
  std::optional<Keyphasor> keyphasor{};
  std::optional<double> from_s{}, to_s{};  ///< evaluated interval, in the recording's time
  std::optional<double> speed_hz{};        ///< > 0
  std::optional<SpeedColumn> speed{};
  std::optional<Sweep> sweep{};
  std::optional<RunOut> run_out{};  ///< run-out with a keyphasor
  double lowest_order = 0.125;      ///< > 0: lowest order that is kept where readings are integrated
  std::optional<MachineGroup> machine_group{};
  /// Limits between zones A and B, B and C, C and D, rising, in place of those of the standards: velocity rms
  /// of a casing, displacement of a shaft from peak to peak.
  std::optional<std::array<double, 3>> zone_limits_mm_per_s{}, zone_limits_um{};
};

}  // namespace rubsweep::recording

namespace rubsweep::config::recording {

/// Reads what has to be known of a recording: probes (a list of one or two, each with column, angle_deg and
/// perhaps a gain, unit, on, range_v, rest), keyphasor (column, mark, threshold, hysteresis,
/// pulses_per_turn), speed_hz or speed (a column, or column and unit), time (the name of a column) or
/// sampling_rate_hz or none of both; from_s, to_s; run_out (from_s, to_s, subtract); lowest_order,
/// machine_group, zone_limits_mm_per_s, zone_limits_um. `name` stands for the file in messages. Throws
/// ConfigError with every problem.
rubsweep::recording::Instrument read_instrument_text(std::string_view text, const std::string& name);

}  // namespace rubsweep::config::recording
