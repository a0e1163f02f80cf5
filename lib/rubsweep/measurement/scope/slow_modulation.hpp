#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace rubsweep::scope {

/// A motion whose lines at multiples of 1 / period keep their mean over the recording.
struct Levelled {
  std::vector<std::complex<double>> samples{};
  double modulation_m = 0;  ///< root mean square of what was taken away, without the drift of the centre
  double refused_m = 0;     ///< the same of what stays, being more than a line or the motion may vary by
};

/// Takes the slow modulation of the lines of a period away: of a machine whose load, temperature or speed
/// wanders. `samples` hold `samples_per_revolution` of every turn; lines of |order| up to `most_order` count.
/// The amplitude of a line, from one period to the next, is a straight line and cosines that are slower than
/// a cycle in sixteen periods. What varies by more than twice `most_modulation` of its line is no modulation
/// of it and stays, and all stays where more than `most_modulation` of the motion would go. The centre's
/// drift goes likewise, up to half of the motion.
Levelled without_slow_modulation(std::span<const std::complex<double>> samples, int samples_per_revolution,
                                 int period, double most_order, double most_modulation,
                                 std::size_t repeats = 1);

}  // namespace rubsweep::scope
