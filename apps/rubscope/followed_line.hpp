#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rubsweep/measurement/recording/channels.hpp"
#include "rubsweep/measurement/recording/recording.hpp"

namespace rubsweep::apps {

/// Follows the line of a shaft through short-time spectra, from near sweep.from_hz (within a quarter of it)
/// to near sweep.to_hz: of all paths whose steps are at most four times those of an even sweep, the one with
/// the largest product of powers. The phase of the line along that path then gives the angles; near a
/// resonance they turn with the phase of the vibration. `probes` are readings on one clock from `first_s` on,
/// which takes the mark's place; the probe with the largest line decides. Empty where no line stands out of
/// the noise along the path.
std::optional<recording::FollowedTurns> follow_line(const std::vector<std::vector<double>>& probes,
                                                    double first_s, double sampling_rate_hz,
                                                    const recording::Sweep& sweep);

/// Turns by the line in the probes of a recording whose description has a sweep. Throws ConfigError, `name`
/// of the file first, where there is none.
recording::FollowedTurns followed_turns(const recording::Channels& channels,
                                        const recording::Instrument& instrument, const std::string& name);

}  // namespace rubsweep::apps
