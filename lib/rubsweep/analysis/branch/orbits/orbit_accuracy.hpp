#pragma once

namespace rubsweep::branch::orbits {

/// Largest relative tolerance of a stepper that follows an orbit, and samples of it in a turn.
inline constexpr double tolerance_of_orbits = 1e-11;
inline constexpr int samples_per_turn = 128;

}  // namespace rubsweep::branch::orbits
