#include "rubsweep/measurement/recording/integrated.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace rubsweep::recording {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

TEST(Integrated, DividesLinesByPowersOfTheirOrder) {
  constexpr int turns = 12, samples = 64;
  for (const int times : {0, 1, 2}) {
    std::vector<Complex> derivative, displacement;
    for (int k = 0; k < turns * samples; ++k) {
      const double angle = 2 * pi * k / samples;
      Complex sum = 0, left = 0;
      for (const double order : {-3.0, 0.5, 1.0, 7.0}) {
        const Complex line = std::polar(1 + order * order, order * angle + order);
        sum += std::pow(Complex(0, order), times) * line;
        left += line;
      }
      derivative.push_back(sum + (times == 0 ? Complex() : 5.0 + std::polar(2.0, -angle / 12)));
      displacement.push_back(left);
    }
    const auto values = integrated(derivative, turns, {times, 0.125});
    for (std::size_t k = 0; k < values.size(); ++k)
      ASSERT_LT(std::abs(values[k] - displacement[k]), 1e-10) << times << ' ' << k;
  }
}

TEST(Integrated, NoiseFallsWithTheOrder) {
  const Integration velocity{1, 0.2}, acceleration{2, 0.2};
  EXPECT_EQ(Integration{}.noise_at(5), 1);
  EXPECT_EQ(velocity.noise_at(-4), 0.25);
  EXPECT_NEAR(acceleration.noise_at(0.5), 4, 1e-12);
  EXPECT_NEAR(acceleration.noise_at(0), 25, 1e-9);
}

}  // namespace
}  // namespace rubsweep::recording
