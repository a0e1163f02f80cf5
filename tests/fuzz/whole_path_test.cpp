// Tests the fuzz target's configurations without libFuzzer, the same ones in every run, so that every build
// and every sanitizer covers them. Environment variables: RUBSWEEP_FUZZ_PRINT=1 prints them,
// RUBSWEEP_FUZZ_SEEDS=FROM:TO chooses others.
#include "fuzz/whole_path.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "fuzz/random_config.hpp"

namespace rubsweep::fuzz {
namespace {

std::vector<std::uint8_t> bytes_of(unsigned seed) {
  std::mt19937_64 random(seed);
  std::vector<std::uint8_t> bytes(400);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random() >> 56);
  return bytes;
}

/// The first seed, and the seed after the last.
std::pair<unsigned, unsigned> seeds() {
  std::pair<unsigned, unsigned> range{0, 100};
  if (const char* text = std::getenv("RUBSWEEP_FUZZ_SEEDS"))
    std::sscanf(text, "%u:%u", &range.first, &range.second);
  return range;
}

TEST(WholePath, EveryConfigurationEndsInARowOrARefusal) {
  std::map<Ending, unsigned> endings;
  const auto [first, last] = seeds();
  for (unsigned seed = first; seed < last; ++seed) {
    const std::vector<std::uint8_t> bytes = bytes_of(seed);
    ByteSource source(bytes);
    const std::string text = random_config(source);
    if (std::getenv("RUBSWEEP_FUZZ_PRINT") != nullptr)
      std::fprintf(stderr, "# seed %u\n%s", seed, text.c_str());
    try {
      ++endings[check_whole_path(text)];
    } catch (const std::exception& error) {
      ADD_FAILURE() << "seed " << seed << ": " << error.what() << "\n" << text;
    }
  }
  // The generator must not degenerate: both results must occur.
  if (last - first < 100) return;
  EXPECT_GT(endings[Ending::evaluated], (last - first) / 8);
  EXPECT_GT(endings[Ending::refused], (last - first) / 20);
}

TEST(WholePath, WithoutBytesItIsAnOrdinaryMachine) {
  ByteSource none({});
  EXPECT_EQ(check_whole_path(random_config(none)), Ending::evaluated);
}

}  // namespace
}  // namespace rubsweep::fuzz
