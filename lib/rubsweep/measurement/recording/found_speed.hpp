#pragma once

#include <optional>
#include <string>
#include <vector>

namespace rubsweep::recording {

/// Largest relative error allowed for the speed in a description.
inline constexpr double most_speed_error = 0.02;

/// Speed of a shaft without a mark, estimated from the probes.
struct FoundSpeed {
  double speed_hz = 0, uncertainty_hz = 0;  ///< standard
  double largest_hz = 0;      ///< frequency of the largest line within two fifths of the given speed
  bool by_harmonics = false;  ///< true: by the lines of order 2 and 3
};

/// The largest line near a speed, within most_speed_error, and within two fifths of it: of each probe the
/// readings are shifted down by the given speed, smoothed over four turns, and their lines resolved. Where
/// none is near enough, the lines of order 2 and 3 say the speed if they agree: one alone may be another
/// machine's. Empty where there is no line that stands ten times out of the noise, or fewer than 12 turns.
/// speed_hz is 0 where that line is farther off.
std::optional<FoundSpeed> speed_near(const std::vector<std::vector<double>>& probes, double sampling_rate_hz,
                                     double given_hz);

/// Speed to use, and findings about it. The found speed replaces the given one if it changes the shaft angle
/// over `turns` by a thousandth of a turn and differs by three standard uncertainties.
double speed_to_take(double given_hz, const std::optional<FoundSpeed>& found, double turns,
                     std::vector<std::string>& findings);

}  // namespace rubsweep::recording
