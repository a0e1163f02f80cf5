#include "rubsweep/measurement/recording/run_out.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "rubsweep/core/error.hpp"

namespace rubsweep::recording {
namespace {

using Complex = std::complex<double>;

constexpr int samples_of_a_turn = 32;

/// A gap, run-out of order 1 with a scratch of order 3, and a vibration of order 1.
std::vector<Complex> slow_motion(int turns, Complex vibration) {
  std::vector<Complex> z;
  for (int k = 0; k < turns * samples_of_a_turn; ++k) {
    const double angle = 2 * std::numbers::pi * k / samples_of_a_turn;
    z.push_back(Complex(3, 4) + (Complex(0.5, 0.1) + vibration) * std::polar(1.0, angle) +
                0.2 * std::polar(1.0, -3 * angle));
  }
  return z;
}

TEST(RunOut, IsSubtractedAsWaveformOrVector) {
  for (const bool vector : {false, true}) {
    auto z = slow_motion(3, {1, 0});
    subtract_run_out(z, run_out_of(slow_motion(5, 0), samples_of_a_turn, vector));
    for (std::size_t k = 0; k < z.size(); ++k) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(k) / samples_of_a_turn;
      const Complex left =
          Complex(3, 4) + std::polar(1.0, angle) + (vector ? 0.2 : 0) * std::polar(1.0, -3 * angle);
      EXPECT_LT(std::abs(z[k] - left), 1e-12);
    }
  }
}

TEST(RunOut, GapsAreLeftOut) {
  auto slow = slow_motion(3, 0);
  slow[samples_of_a_turn + 1] = NAN;
  const auto with = run_out_of(slow, samples_of_a_turn, false),
             without = run_out_of(slow_motion(1, 0), samples_of_a_turn, false);
  for (std::size_t k = 0; k < with.size(); ++k) EXPECT_LT(std::abs(with[k] - without[k]), 1e-12);
  slow = std::vector<Complex>(samples_of_a_turn, NAN);
  EXPECT_THROW(run_out_of(slow, samples_of_a_turn, false), ConfigError);
}

}  // namespace
}  // namespace rubsweep::recording
