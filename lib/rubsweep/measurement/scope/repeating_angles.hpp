#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include "rubsweep/measurement/recording/recording.hpp"

namespace rubsweep::scope {

/// The last whole periods of so many samples.
std::span<const std::complex<double>> whole_periods(std::span<const std::complex<double>> samples,
                                                    std::size_t period);

/// Mean of whole periods.
std::vector<std::complex<double>> mean_period(std::span<const std::complex<double>> samples,
                                              std::size_t period);

/// Lines A_k of a period with samples at equal angles, z = sum over k of A_k e^{2 pi i k j / N}, for k from
/// -last to last; last < N / 2.
std::vector<std::complex<double>> lines_of_period(std::span<const std::complex<double>> period, int last);

/// A motion, given by `samples_per_revolution` samples of every turn, at the angles at which it repeats best
/// after `period` turns; `samples` hold two periods or more. The shift of the angles is a polynomial over the
/// recording, within what `doubt` allows but for a constant: angles count from the mean of the marks.
///
/// A shift s, in turns, of a motion P adds P' s to it. By least squares each period has its own s, and a
/// polynomial of `doubt.degree` (or of as many numbers as there are periods) through them is the next
/// correction, until it is small. Only lines of |order| <= `most_order` count for P'.
std::vector<std::complex<double>> at_repeating_angles(std::span<const std::complex<double>> samples,
                                                      int samples_per_revolution, int period,
                                                      double most_order, const recording::AngleDoubt& doubt);

/// A motion whose lines at multiples of 1 / period keep their mean over the recording.
struct Levelled {
  std::vector<std::complex<double>> samples{};
  double modulation_m = 0;  ///< root mean square of what was taken away, without the drift of the centre
  double refused_m = 0;     ///< the same of what stays, being more than a line or the motion may vary by
};

/// Slow modulation that goes.
struct SlowModulation {
  int period = 1;                ///< whose lines are looked at, in turns
  double most_order = 0;         ///< largest order of these lines
  double most_modulation = 0.1;  ///< share of the motion
  std::ptrdiff_t repeats = 1;    ///< variation that comes again after so many periods stays
  bool in_phase = false;         ///< the amplitude alone: the line does not turn against the shaft
};

/// Takes the slow modulation of the lines of a period away: of a machine whose load, temperature or speed
/// wanders. `samples` hold `samples_per_revolution` of every turn. The amplitude of a line, from one period
/// to the next, is a straight line and cosines that are slower than a cycle in sixteen periods; what is in
/// phase with its mean, a cubic polynomial and a cycle in eight. What varies by more than twice
/// `most_modulation` of its line is no modulation of it and stays, and all stays where more than
/// `most_modulation` of the motion would go. The centre's drift goes likewise, up to half of the motion.
Levelled without_slow_modulation(std::span<const std::complex<double>> samples, int samples_per_revolution,
                                 const SlowModulation& slow);

}  // namespace rubsweep::scope
