#pragma once

#include <optional>
#include <string>
#include <vector>

namespace rubsweep::recording {

inline constexpr double most_speed_error = 0.02;  ///< Largest relative error of the given speed.

/// Speed of a shaft without a mark, estimated from the probes.
struct FoundSpeed {
  double speed_hz = 0, uncertainty_hz = 0;  ///< standard
  double largest_hz = 0;      ///< frequency of the largest line within two fifths of the given speed
  bool by_harmonics = false;  ///< true: found from the lines of order 2 and 3
};

/// Speed of the largest line within most_speed_error of a given speed, and of the largest line within two
/// fifths of it. The readings of each probe are shifted down by the given speed and smoothed over four turns,
/// and their lines are resolved. Where no line is near enough, the lines of order 2 and 3 give the speed if
/// they agree; a single one may come from another machine. Empty where no line exceeds the noise tenfold, or
/// with fewer than 12 turns. speed_hz is 0 where the line is farther away than most_speed_error.
std::optional<FoundSpeed> speed_near(const std::vector<std::vector<double>>& probes, double sampling_rate_hz,
                                     double given_hz);

/// Speed to use, and findings about it. The found speed replaces the given speed if it changes the shaft
/// angle over `turns` by a thousandth of a turn and differs by three standard uncertainties.
double speed_to_take(double given_hz, const std::optional<FoundSpeed>& found, double turns,
                     std::vector<std::string>& findings);

}  // namespace rubsweep::recording
