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

/// Possible distance of a mark from its true instant, in samples. It is 1 where the edge falls between two
/// samples, and 1/5 where one sample lies on the edge. It is 0 where two samples lie on the edge, because the
/// straight line through them is the edge.
double mark_resolution(std::span<const double> signal, Mark mark, double threshold);

/// Largest allowed distance between a smooth curve and a mark, in units of the mark's resolution: one half,
/// and a little more for the noise of the edge.
inline constexpr double smoothing_bound = 0.52;

/// Instants of the marks on a smooth curve of time over turns.
struct SmoothMarks {
  std::vector<double> t_s;
  int degree = 0;  ///< degree of the polynomial, or of a polynomial as flexible as the spline; 0: unchanged
};

/// Removes the sampling errors of marks, which are up to half of `resolution_s`. Curves of time over turns
/// are tried in ascending order of flexibility: polynomials of degree 1 to 5, then cubic splines of 2, 4, 8,
/// ... equal pieces with at least four marks each. The curve after the first one that stays within the bounds
/// is used. Marks stay unchanged where no curve stays within the bounds, or where the resolution is 0.
SmoothMarks smoothed_marks(std::span<const double> marks_s, double resolution_s);

/// Beginnings of turns at a constant speed, and the end of the last one, for a shaft without a mark.
std::vector<double> steady_turns_s(double from_s, double to_s, double speed_hz);

/// Shaft speed in the middle of every turn, in Hz.
std::vector<double> turn_speeds_hz(std::span<const double> turn_begin_s);

/// Samples of a signal at equal shaft angles: `samples_per_revolution` per turn, the first one at the mark.
/// The shaft angle is interpolated by a polynomial through the four marks about a turn (fewer where there are
/// no more), which follows an even change of speed. The signal, with a reading every 1 / F seconds from
/// `first_s` on, is interpolated by a polynomial through six readings. At order p and f revolutions per
/// second its error is at most 0.005 (2 pi p f / F)^6 of the amplitude. NaN where the signal has a gap. The
/// turns must lie within the signal.
std::vector<double> at_equal_angles(std::span<const double> signal, double first_s, double sampling_rate_hz,
                                    std::span<const double> turn_begin_s, int samples_per_revolution);

/// Beginnings of the shaft's turns within the samples.
struct ShaftTurns {
  std::vector<double> begin_s;
  std::vector<double> mark_s{};  ///< marks before smoothing, where each is known to within one reading only
  double room_s = 0;             ///< largest distance of a mark from its true instant
  int degree = 0;                ///< degree of the curve through the marks
};

/// Turns from the marks of the keyphasor or, without a keyphasor, from the column of speeds or the constant
/// speed of the description. Adds the faults of the marks to `findings`. Throws ConfigError, `name` of the
/// file first.
ShaftTurns turns_of(const Channels& channels, const Instrument& instrument, const SampleClock& clock,
                    const std::string& name, std::vector<std::string>& findings);

/// Possible errors of a recording's shaft angles where its marks are known to within one reading only. At the
/// beginning of each turn the true angle may differ by `low_turns` to `high_turns` from the assumed one. The
/// error is a polynomial of `degree` over the recording, as flexible as the curve through the marks. Empty:
/// the angles are exact.
struct AngleDoubt {
  std::vector<double> low_turns{}, high_turns{};  ///< low <= 0, high >= 0
  int degree = 0;
};

/// Possible errors of the angles of these turns without marks: the speed may wander, so that angles are off
/// by a tenth of a turn, or by `least_turns` where that is more.
AngleDoubt doubt_without_marks(std::size_t turns, double least_turns = 0);

/// Possible errors of the angles at the beginnings of these turns, which are a continuous part of all turns.
AngleDoubt angle_doubt_of(std::span<const double> turn_begin_s, const ShaftTurns& all);

}  // namespace rubsweep::recording
