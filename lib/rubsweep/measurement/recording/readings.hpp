#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "rubsweep/measurement/recording/channels.hpp"
#include "rubsweep/measurement/recording/sample_clock.hpp"

namespace rubsweep::recording {

inline constexpr int fewest_turns = 4;  ///< Fewest whole turns that are evaluated.

/// Readings of a probe, in m, m/s or m/s^2 as it measured them.
struct ProbeSignal {
  std::string column;
  double angle_deg = 0;
  std::vector<double> values{};
};

/// Readings of all probes, which measure one quantity of one part.
struct Readings {
  table::Quantity quantity = table::Quantity::length;
  Place place = Place::shaft;
  std::vector<ProbeSignal> probes{};

  /// Number of integrations over time that make displacements of the readings: 0, 1 or 2.
  int integrations() const;
  /// Readings of every probe from an instant up to another; empty: from the first one, up to the last one.
  std::vector<std::vector<double>> stretch(const SampleClock& clock, std::optional<double> from_s = {},
                                           std::optional<double> to_s = {}) const;
};

/// Readings of the probes in a description, with outliers replaced. Adds the faults of every probe to the
/// findings. Throws ConfigError, `name` of the file first, for a missing column, an unknown unit, probes of
/// different quantities or parts, and for rest or run-out of others than displacement.
Readings readings_of(const Channels& channels, const Instrument& instrument, const std::string& name,
                     std::vector<std::string>& findings);

/// Adds the faults over these turns that show when probes are compared. A stretch in which a probe is stuck
/// becomes NaN if enough turns are left.
void look_for_faults(Readings& readings, const SampleClock& clock, std::span<const double> turn_begin_s,
                     std::vector<std::string>& findings);

}  // namespace rubsweep::recording
