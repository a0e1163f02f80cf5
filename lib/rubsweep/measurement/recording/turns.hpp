#pragma once

#include <span>
#include <vector>

namespace rubsweep::recording {

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

}  // namespace rubsweep::recording
