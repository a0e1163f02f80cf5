#include "rubsweep/core/numerics/split_mix.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>

namespace rubsweep::numerics {
namespace {

TEST(SplitMix, NumbersAreThoseOfTheReferenceImplementation) {
  // First numbers of Sebastiano Vigna's splitmix64.c (public domain), from the state 1234567.
  std::uint64_t state = 1234567;
  for (const std::uint64_t number :
       std::array<std::uint64_t, 5>{6457827717110365317U, 3203168211198807973U, 9817491932198370423U,
                                    4593380528125082431U, 16408922859458223821U}) {
    EXPECT_EQ(split_mix(state), number);
    state += split_mix_increment;
  }
}

TEST(SplitMix, EveryBitMovesHalfOfTheOthers) {
  constexpr std::uint64_t start = 0x0123456789abcdefU;
  int changed = 0;
  for (int bit = 0; bit < 64; ++bit)
    changed += std::popcount(split_mix(start) ^ split_mix(start ^ (std::uint64_t{1} << bit)));
  // 64 x 64 coin tosses: mean 2048, standard deviation 32.
  EXPECT_NEAR(changed, 2048, 4 * 32);
}

}  // namespace
}  // namespace rubsweep::numerics
