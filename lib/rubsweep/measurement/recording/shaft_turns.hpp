#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "rubsweep/measurement/recording/channels.hpp"
#include "rubsweep/measurement/recording/instrument.hpp"
#include "rubsweep/measurement/recording/sample_clock.hpp"

namespace rubsweep::recording {

/// Begins of turns of the shaft within the samples.
struct ShaftTurns {
  std::vector<double> begin_s;
  std::vector<double> mark_s{};  ///< the same as they were read, where the mark is known to a reading
  double room_s = 0;             ///< largest distance of a mark from its true instant
  int degree = 0;                ///< of the curve through the marks
};

/// Turns by the marks of the keyphasor, or by the speed of the description where there is none. Adds what is
/// wrong with the marks to `findings`. Throws ConfigError, `name` of the file first.
ShaftTurns turns_of(const Channels& channels, const Instrument& instrument, const SampleClock& clock,
                    const std::string& name, std::vector<std::string>& findings);

/// How far the angles of a recording may be off the truth, because its marks are known to a reading and not
/// better: the shaft's angle at each begin of a turn may be anything from `low_turns` to `high_turns` above
/// what it is taken for, by a polynomial of `degree` over the recording, which is as flexible as the curve
/// through the marks. Empty: angles are right.
struct AngleDoubt {
  std::vector<double> low_turns{}, high_turns{};  ///< <= 0 and >= 0
  int degree = 0;
};

/// Doubt about the angles of so many turns without marks: the speed may wander so that they are off by a
/// tenth of a turn.
AngleDoubt doubt_without_marks(std::size_t turns);

/// Doubt about the angles at the begins of turns, which are some of all in a row.
AngleDoubt angle_doubt_of(std::span<const double> turn_begin_s, const ShaftTurns& all);

}  // namespace rubsweep::recording
