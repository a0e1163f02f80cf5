#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

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

}  // namespace rubsweep::scope
