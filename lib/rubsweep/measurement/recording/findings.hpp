#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "rubsweep/measurement/recording/channels.hpp"
#include "rubsweep/measurement/recording/instrument.hpp"
#include "rubsweep/measurement/recording/probe_faults.hpp"
#include "rubsweep/measurement/recording/turn_marks.hpp"

namespace rubsweep::recording {

/// Adds the faults of a probe's readings: gaps (NaN) with the place of the first one, a constant signal, and
/// clipping. A signal is clipped where it reaches its extreme value by more than the converter's step, and
/// this value occurs five times in a row. It is also clipped where the extreme value is reached ten times and
/// read five times as often as any value in between, or where readings reach `full_scale` with either sign.
void add_findings(const Channel& channel, const Channels& table, std::optional<double> full_scale,
                  std::vector<std::string>& findings);

/// Adds the number of outliers, the place of the first one, and whether they were replaced.
void add_wild_findings(const WildReadings& wild, const Channel& channel, const Channels& table,
                       std::vector<std::string>& findings);

/// Adds the faults of a keyphasor's marks: surplus marks, and missing ones, with the distance of the present
/// marks from the cubics through their neighbours. With several pulses in a turn, it also adds that none of
/// them is known to be the shaft's mark.
void add_mark_findings(const TurnMarks& marks, const Keyphasor& keyphasor,
                       std::vector<std::string>& findings);

/// Adds the faults of the turns: a turn that differs from the turn before by more than 1 % in length, and a
/// sampling rate below twenty readings per turn, at which orders above the tenth may be aliased.
void add_speed_findings(std::span<const double> turn_begin_s, double sampling_rate_hz,
                        std::vector<std::string>& findings);

}  // namespace rubsweep::recording
