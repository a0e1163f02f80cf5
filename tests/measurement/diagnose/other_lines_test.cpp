#include "rubsweep/measurement/diagnose/other_lines.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "rubsweep/measurement/diagnose/simulated_motion.hpp"

namespace rubsweep::diagnose {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

std::vector<Complex> circle(double radius, int turns) {
  std::vector<Complex> z;
  for (int k = 0; k < turns * samples_per_revolution; ++k)
    z.push_back(Complex(3, -1) + std::polar(radius, 2 * pi * k / samples_per_revolution));
  return z;
}

double line(const std::vector<Complex>& z, int order) {
  Complex sum = 0;
  for (std::size_t k = 0; k < z.size(); ++k)
    sum += z[k] * std::polar(1.0, -2 * pi * order * static_cast<double>(k) / samples_per_revolution);
  return std::abs(sum) / static_cast<double>(z.size());
}

TEST(OtherLines, SizeOfACircleIsItsRadiusWhereverItStands) {
  EXPECT_NEAR(size_of(circle(0.7, 3)), 0.7, 1e-12);
}

TEST(OtherLines, StayBelowTheirSharesAndLeaveTheRestAlone) {
  const OtherLines lines;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    RandomStream random(seed, 0, 0);
    std::vector<Complex> z = circle(2, 3);
    add_other_lines(z, lines, 2, random);
    EXPECT_NEAR(line(z, 1), 2, 1e-12);
    EXPECT_NEAR(line(z, 4), 0, 1e-12);
    const std::vector<std::pair<int, double>> most{{-1, lines.backward_1x},
                                                   {2, lines.order_2},
                                                   {-2, lines.order_2},
                                                   {3, lines.order_3},
                                                   {-3, lines.order_3}};
    for (const auto& [order, share] : most) {
      EXPECT_GE(line(z, order), 2 * OtherLines::smallest_share * (1 - 1e-9));
      EXPECT_LE(line(z, order), 2 * share * (1 + 1e-9));
    }
  }
}

TEST(OtherLines, WithoutSharesAreNone) {
  RandomStream random(1, 0, 0);
  std::vector<Complex> z = circle(2, 3);
  add_other_lines(z, {0, 0, 0}, 2, random);
  for (const int order : {-1, 2, -2, 3, -3}) EXPECT_NEAR(line(z, order), 0, 1e-12);
}

}  // namespace
}  // namespace rubsweep::diagnose
