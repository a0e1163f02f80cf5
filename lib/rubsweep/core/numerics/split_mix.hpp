#pragma once

#include <cstdint>

namespace rubsweep::numerics {

/// Increment of the state of SplitMix64 for each number.
inline constexpr std::uint64_t split_mix_increment = 0x9e3779b97f4a7c15U;

/// Number of SplitMix64 (Steele, Lea, Flood 2014) that follows a state; each of its bits depends on the whole
/// state.
constexpr std::uint64_t split_mix(std::uint64_t state) {
  state += split_mix_increment;
  state = (state ^ (state >> 30U)) * 0xbf58476d1ce4e5b9U;
  state = (state ^ (state >> 27U)) * 0x94d049bb133111ebU;
  return state ^ (state >> 31U);
}

}  // namespace rubsweep::numerics
