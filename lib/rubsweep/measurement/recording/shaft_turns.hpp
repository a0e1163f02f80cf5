#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "rubsweep/measurement/recording/channels.hpp"
#include "rubsweep/measurement/recording/instrument.hpp"
#include "rubsweep/measurement/recording/sample_clock.hpp"
#include "rubsweep/measurement/recording/turn_marks.hpp"

namespace rubsweep::recording {

/// How far a mark may stand off its true instant, in samples: 1 where the edge falls between two samples,
/// which then say no more than that; a fifth where one sample stands on the edge; 0 where two do, for then
/// the straight line through them is the edge.
double mark_resolution(std::span<const double> signal, Mark mark, double threshold);

/// Farthest that a smooth curve may be from a mark that is known to a resolution, in resolutions: half of
/// one, and a little for the noise of the edge.
inline constexpr double smoothing_bound = 0.52;

/// Instants of marks on a smooth curve of time over turns.
struct SmoothMarks {
  std::vector<double> t_s;
  int degree =
      0;  ///< degree of the polynomial, or of one as flexible as the spline; 0: marks stayed as they were
};

/// Instants of the marks freed of the sampling, which moves each of them by up to half of `resolution_s` to
/// either side. Curves of time over turns are tried from the simplest on: polynomials of degree 1 to 5, then
/// cubic splines of 2, 4, 8, ... equal pieces with four marks or more each. Taken is the one behind the first
/// that is never farther from the marks. Marks stay as they are where there is none, or the resolution is 0.
SmoothMarks smoothed_marks(std::span<const double> marks_s, double resolution_s);

/// Instants between which the shaft made one turn each; steady ones where there is no mark on the shaft.
std::vector<double> steady_turns_s(double from_s, double to_s, double speed_hz);

/// Shaft speed in the middle of every turn, in Hz.
std::vector<double> turn_speeds_hz(std::span<const double> turn_begin_s);

/// Samples of a signal at equal angles of the shaft: `samples_per_revolution` of every turn, the first one at
/// its mark. Time over turns is the polynomial through the four marks about a turn (fewer where there are no
/// more), so that an even change of the speed costs next to nothing. Between its samples, which come every 1
/// / F seconds from `first_s` on, the signal is the polynomial through six of them: of an order p at f
/// revolutions a second it misses 0.005 (2 pi p f / F)^6 of the amplitude or less. NaN where the signal has a
/// gap. The turns lie within the signal.
std::vector<double> at_equal_angles(std::span<const double> signal, double first_s, double sampling_rate_hz,
                                    std::span<const double> turn_begin_s, int samples_per_revolution);

/// Begins of turns of the shaft within the samples.
struct ShaftTurns {
  std::vector<double> begin_s;
  std::vector<double> mark_s{};  ///< the same as they were read, where the mark is known to a reading
  double room_s = 0;             ///< largest distance of a mark from its true instant
  int degree = 0;                ///< degree of the curve through the marks
};

/// Turns by the marks of the keyphasor, or where there is none by the column of the speed or that of the
/// description. Adds what is
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
