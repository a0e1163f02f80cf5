#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace rubsweep::page {

/// Which of the equidistant samples of some signals are enough to draw all of them by straight lines: with
/// the samples at the places returned (ascending, the first and the last among them), linear interpolation
/// misses no sample of any signal by more than `tolerance`. `always` lists places that stay in any case,
/// ascending. All signals have the same length, two samples or more. The method is that of Ramer, Douglas
/// and Peucker, with distances along the axis of values.
std::vector<std::size_t> needed_samples(std::span<const std::vector<double>> signals, double tolerance,
                                        std::span<const std::size_t> always);

}  // namespace rubsweep::page
