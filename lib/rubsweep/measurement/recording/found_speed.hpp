#pragma once

#include <optional>
#include <string>
#include <vector>

namespace rubsweep::recording {

/// Most by which the speed that a description says may be off, relative to it.
inline constexpr double most_speed_error = 0.02;

/// Speed of a shaft without a mark, from what probes read.
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

/// The speed to take, and what is to be said of it: the found one where it would move the shaft's angle by a
/// thousandth of a turn over `turns`, and by three of its uncertainties.
double speed_to_take(double given_hz, const std::optional<FoundSpeed>& found, double turns,
                     std::vector<std::string>& findings);

}  // namespace rubsweep::recording
