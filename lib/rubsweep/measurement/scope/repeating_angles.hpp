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

}  // namespace rubsweep::scope
