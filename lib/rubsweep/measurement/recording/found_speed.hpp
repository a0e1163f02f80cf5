#pragma once

#include <optional>
#include <string>
#include <vector>

namespace rubsweep::recording {

/// Largest relative error allowed for the speed in a description.
inline constexpr double most_speed_error = 0.02;

/// Speed of a shaft without a mark, estimated from the probes.
struct FoundSpeed {
  double speed_hz = 0, uncertainty_hz = 0;  ///< the uncertainty is a standard one
  double largest_hz = 0;                    ///< frequency of the largest line within 40 % of the given speed
};

/// Finds the largest line within most_speed_error of a given speed and within 40 % of it. The readings of
/// each probe are shifted down by the given speed, smoothed over four turns, and their lines resolved. Empty
/// where no line exceeds ten times the noise, or with fewer than 12 turns. speed_hz is 0 where the largest
/// line is farther off than most_speed_error.
std::optional<FoundSpeed> speed_near(const std::vector<std::vector<double>>& probes, double sampling_rate_hz,
                                     double given_hz);

/// Speed to use, and findings about it. The found speed replaces the given one if it changes the shaft angle
/// over `turns` by a thousandth of a turn and differs by three standard uncertainties.
double speed_to_take(double given_hz, const std::optional<FoundSpeed>& found, double turns,
                     std::vector<std::string>& findings);

}  // namespace rubsweep::recording
