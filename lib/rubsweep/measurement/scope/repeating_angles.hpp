#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include "rubsweep/measurement/recording/recording.hpp"

namespace rubsweep::scope {

/// The last samples that form whole periods.
std::span<const std::complex<double>> whole_periods(std::span<const std::complex<double>> samples,
                                                    std::size_t period);

/// Mean of whole periods.
std::vector<std::complex<double>> mean_period(std::span<const std::complex<double>> samples,
                                              std::size_t period);

/// Lines A_k of a period with N samples at equal angles, z_j = sum over k of A_k e^{2 pi i k j / N}, for k
/// from -last to last; last < N / 2.
std::vector<std::complex<double>> lines_of_period(std::span<const std::complex<double>> period, int last);

/// Resamples a motion, given by `samples_per_revolution` samples per turn, at the angles at which it repeats
/// best after `period` turns; `samples` contains at least two periods. The shift of the angles is a
/// polynomial over the recording within the limits of `doubt`. Its mean is zero: angles are measured from the
/// mean of the marks.
///
/// A shift of s turns adds P' s to a motion P. Each period gets its own s by least squares. A polynomial of
/// `doubt.degree` through these shifts (of lower degree where there are fewer periods) is the next
/// correction, until the correction is small. P' contains only lines with |order| <= `most_order`.
std::vector<std::complex<double>> at_repeating_angles(std::span<const std::complex<double>> samples,
                                                      int samples_per_revolution, int period,
                                                      double most_order, const recording::AngleDoubt& doubt);

/// A motion whose lines at multiples of 1 / period are constant over the recording.
struct Levelled {
  std::vector<std::complex<double>> samples{};
  double modulation_m = 0;  ///< root mean square of the removed modulation, without the drift of the centre
  double refused_m = 0;     ///< root mean square of modulation that was too large to be removed
};

/// Settings for the removal of slow modulation.
struct SlowModulation {
  int period = 1;                ///< period in turns; its lines are corrected
  double most_order = 0;         ///< largest order of these lines
  double most_modulation = 0.1;  ///< largest modulation, as a share of the motion
  std::ptrdiff_t repeats = 1;    ///< variations that repeat after this number of periods stay
  bool in_phase = false;         ///< corrects only the amplitudes of lines, not their drifting phases
};

/// Removes the slow modulation of a period's lines, which a wandering load, temperature or speed causes.
/// `samples` contains `samples_per_revolution` values per turn. From period to period, the modulation of a
/// line is a straight line plus cosines slower than one cycle in sixteen periods. Its component in phase with
/// the mean may be a cubic polynomial plus cosines slower than one cycle in eight periods. A line that varies
/// by more than twice `most_modulation` is not corrected. Nothing is removed if more than `most_modulation`
/// of the motion would be. The drift of the centre is removed likewise, up to half of the motion.
Levelled without_slow_modulation(std::span<const std::complex<double>> samples, int samples_per_revolution,
                                 const SlowModulation& slow);

}  // namespace rubsweep::scope
