#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rubsweep/recording/keyphasor.hpp"

namespace rubsweep::recording {

/// A displacement probe.
struct Probe {
  std::string column;    ///< name of its column
  double angle_deg = 0;  ///< direction in which it looks at the shaft, from +x towards +y
  std::optional<double>
      gain_mv_per_um{};  ///< not 0; of a column in volts; negative: away from the probe is less
};

struct Keyphasor {
  std::string column;
  Mark mark = Mark::dark;
  std::optional<double> threshold{};  ///< in the column's unit; empty: middle_threshold
  double hysteresis = 0;              ///< in the column's unit, >= 0
};

/// All that has to be known of a recording beside its numbers. Times come from the column `time` or from the
/// sampling rate, turns from the keyphasor or from the speed: one of each.
struct Instrument {
  std::optional<std::string> time{};
  std::optional<double> sampling_rate_hz{};  ///< > 0
  std::vector<Probe> probes{};               ///< one, or two that look in different directions
  std::optional<Keyphasor> keyphasor{};
  std::optional<double> from_s{}, to_s{};  ///< stretch that is looked at, on the clock of the recording
  std::optional<double> speed_hz{};        ///< > 0
};

}  // namespace rubsweep::recording
