#include "rubsweep/core/numerics/bernstein_root.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace rubsweep::numerics {
namespace {

struct Polynomial {
  std::array<double, 5> c{};  // c0 + c1 x + ... + c4 x^4

  double operator()(double x) const { return c[0] + x * (c[1] + x * (c[2] + x * (c[3] + x * c[4]))); }
  double slope(double x) const { return c[1] + x * (2 * c[2] + x * (3 * c[3] + x * 4 * c[4])); }
  Quartic bernstein() const {
    return quartic_through((*this)(0), slope(0), (*this)(0.5), (*this)(1), slope(1));
  }
};

double evaluate(const Quartic& q, double x) {
  const double y = 1 - x;
  return q[0] * y * y * y * y + 4 * q[1] * x * y * y * y + 6 * q[2] * x * x * y * y +
         4 * q[3] * x * x * x * y + q[4] * x * x * x * x;
}

TEST(BernsteinRootQuarticThrough, ReproducesThePolynomial) {
  const Polynomial p{{0.3, -2, 1.5, 0.7, -0.4}};
  const Quartic q = p.bernstein();
  for (double x = 0; x <= 1; x += 0.01) EXPECT_NEAR(evaluate(q, x), p(x), 1e-14);
}

TEST(BernsteinRootFirstRise, AgreesWithFineSampling) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  int found = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    Polynomial p;
    for (double& c : p.c) c = normal(random);
    p.c[0] = -std::abs(p.c[0]);
    std::optional<double> sampled;
    constexpr int points = 20000;
    for (int i = 0; i < points && !sampled; ++i) {
      const double a = double(i) / points, b = double(i + 1) / points;
      if (p(a) < 0 && p(b) >= 0) sampled = b;
    }
    const auto rise = bernstein_root(p.bernstein());
    ASSERT_EQ(rise.has_value(), sampled.has_value()) << trial;
    if (!rise) continue;
    ++found;
    EXPECT_NEAR(*rise, *sampled, 1.0 / points + 1e-12);
    EXPECT_NEAR(p(*rise), 0, 1e-10);
  }
  EXPECT_GT(found, 200);
}

TEST(BernsteinRootFirstRise, SeesAGrazeThatEndsDisagreeOn) {
  // -(x - 0.37)^2 + h: both ends negative, above zero only within sqrt(h) of 0.37.
  const auto graze = [](double h) { return Polynomial{{h - 0.37 * 0.37, 0.74, -1, 0, 0}}; };
  const auto rise = bernstein_root(graze(1e-10).bernstein());
  ASSERT_TRUE(rise);
  EXPECT_NEAR(*rise, 0.37 - 1e-5, 1e-9);
  EXPECT_FALSE(bernstein_root(graze(-1e-10).bernstein()));
}

TEST(BernsteinRootFirstRise, StartingAboveZeroMustFallFirst) {
  EXPECT_FALSE(bernstein_root(Polynomial{{0.1, 1, 0, 0, 0}}.bernstein()));
  EXPECT_FALSE(bernstein_root(Polynomial{{0, 1, 0, 0, 0}}.bernstein()));
  EXPECT_FALSE(bernstein_root(Polynomial{{0.1, -1, 0, 0, 0}}.bernstein()));
  // 0.02 - 0.3 x + x^2 falls at 0.1 and rises at 0.2.
  const auto rise = bernstein_root(Polynomial{{0.02, -0.3, 1, 0, 0}}.bernstein());
  ASSERT_TRUE(rise);
  EXPECT_NEAR(*rise, 0.2, 1e-10);
}

TEST(BernsteinRootFirstRise, TakesTheFirstOfTwo) {
  // (x - 0.2)(x - 0.4)(x - 0.6) rises at 0.2 and 0.6.
  const auto rise = bernstein_root(Polynomial{{-0.048, 0.44, -1.2, 1, 0}}.bernstein());
  ASSERT_TRUE(rise);
  EXPECT_NEAR(*rise, 0.2, 1e-10);
}

TEST(BernsteinRootClearlyBelowZero, NeverHidesARiseOfTheCubic) {
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  int hidden_chances = 0;
  for (int trial = 0; trial < 5000; ++trial) {
    Polynomial p{{normal(random) - 1, normal(random), normal(random), normal(random), 0}};
    if (!clearly_below_zero(p(0), p.slope(0), p(1), p.slope(1))) continue;
    ++hidden_chances;
    for (double x = 0; x <= 1; x += 0.01) ASSERT_LT(p(x), 0);
  }
  EXPECT_GT(hidden_chances, 100);
}

}  // namespace
}  // namespace rubsweep::numerics
