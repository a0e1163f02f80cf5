#pragma once

namespace rubsweep::response::testing {

/// Number of turns, and samples per turn, of motions whose spectra are combs.
inline constexpr int comb_turns = 128, comb_samples_per_turn = 64;

}  // namespace rubsweep::response::testing
