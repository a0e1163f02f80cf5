#include "rubsweep/core/numerics/polynomial_root.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace rubsweep::numerics {
namespace {

double value(const std::vector<double>& c, double x) {
  double sum = 0;
  for (std::size_t k = c.size(); k-- > 0;) sum = sum * x + c[k];
  return sum;
}

std::vector<double> times(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> c(a.size() + b.size() - 1, 0.0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) c[i + j] += a[i] * b[j];
  }
  return c;
}

TEST(PolynomialRootFirstRise, OfSimplePolynomials) {
  EXPECT_NEAR(*first_rise_of(std::vector{-0.25, 1.0}, 0), 0.25, 1e-16);
  EXPECT_FALSE(first_rise_of(std::vector{0.25, -1.0}, 0));                   // falls
  EXPECT_FALSE(first_rise_of(std::vector{-1.0, 0.5}, 0));                    // no zero in the interval
  EXPECT_NEAR(*first_rise_of(std::vector{0.06, -0.5, 1.0}, 0), 0.3, 1e-15);  // falls at 0.2, rises at 0.3
  EXPECT_NEAR(*first_rise_of(std::vector{-0.06, 0.5, -1.0}, 0), 0.2, 1e-15);
  EXPECT_FALSE(first_rise_of(std::vector{-1.0}, 0));
}

TEST(PolynomialRootFirstRise, AStartAtZeroIsNoRise) {
  for (const double noise : {-1e-16, 0.0, 1e-16}) {
    EXPECT_FALSE(first_rise_of(std::vector{noise, -1.0, 0.5}, 1e-15));
    EXPECT_NEAR(*first_rise_of(std::vector{noise, -1.0, 2.0}, 1e-15), 0.5, 1e-15);
  }
}

/// Polynomials with as many terms as a step, with one root: rising, or curved in one direction with a part
/// that falls at the beginning or at the end.
TEST(PolynomialRootFirstRise, OfWhatRisesOrBendsOneWay) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> part(0, 1), place(0.05, 0.95);
  for (int trial = 0; trial < 300; ++trial) {
    for (const double bend : {-1.0, 0.0, 1.0}) {
      const double root = place(random);
      // (x - root) times a square, with constant slope, or with a slope that becomes zero beyond the other
      // end.
      std::vector<double> c = times({-root, 1.0}, {bend < 0 ? 1.2 : bend > 0 ? 0.2 : 1.0, bend});
      c.resize(24);
      for (std::size_t k = 3; k < c.size(); ++k) c[k] = 1e-3 * part(random) * std::pow(0.3, double(k));
      const double known = *first_rise_of(c, 0);
      EXPECT_LT(value(c, known - 1e-14), 0);
      EXPECT_GT(value(c, known + 1e-14), 0);
      EXPECT_NEAR(known, root, 1e-3);
    }
  }
}

TEST(PolynomialRootFirstRise, TellsAGrazeFromATouch) {
  // -(x - 1/3)^2 + excess: two roots at a distance of sqrt(excess) from 1/3, or none.
  const double third = 1.0 / 3;
  for (const double excess : {1e-6, 1e-9, 1e-12}) {
    const auto rise = first_rise_of(std::vector{excess - third * third, 2 * third, -1.0}, 0);
    ASSERT_TRUE(rise) << excess;
    EXPECT_NEAR(*rise, third - std::sqrt(excess), 1e-9) << excess;
    EXPECT_FALSE(first_rise_of(std::vector{-excess - third * third, 2 * third, -1.0}, 0)) << excess;
  }
}

/// Products of random factors with known roots, including double roots and close pairs.
TEST(PolynomialRootFirstRise, OfRandomProductsIsTheirFirstRisingRoot) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> root(-0.6, 1.6), width(0.7, 1.5);
  int rises = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    std::vector<double> c{1.0}, roots;
    for (int i = 0; i < 6; ++i) {
      roots.push_back(root(random));
      c = times(c, {-roots.back(), 1});
    }
    // Further factors without real roots, up to degree 18.
    while (c.size() < 19) {
      const double centre = root(random), apart = width(random);
      c = times(c,
                {1 + centre * centre / (apart * apart), -2 * centre / (apart * apart), 1 / (apart * apart)});
    }
    std::ranges::sort(roots);
    // p > 0 beyond the last root and its sign changes at every root, so it rises at the last, third last, ...
    std::optional<double> expected;
    for (std::size_t i = 1; i < roots.size(); i += 2) {
      if (!expected && roots[i] > 0 && roots[i] <= 1) expected = roots[i];
    }
    const auto found = first_rise_of(c, 0);
    ASSERT_EQ(found.has_value(), expected.has_value()) << trial;
    if (expected) {
      // The position of close roots is less accurate than the zero of the polynomial.
      EXPECT_NEAR(*found, *expected, 1e-4) << trial;
      double size = 0;
      for (const double term : c) size += std::abs(term);
      EXPECT_NEAR(value(c, *found), 0, 1e-15 * size) << trial;
      ++rises;
    }
  }
  EXPECT_GT(rises, 500);
}

/// However close the next root is, until rounding hides the rise, the residual at the root found is only
/// rounding.
TEST(PolynomialRootFirstRise, IsARootToRoundingBesideAnother) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> place(0.1, 0.9), width(0.7, 1.5);
  for (int trial = 0; trial < 400; ++trial) {
    const double root = place(random), apart = std::pow(10, -1 - trial % 5);
    std::vector<double> c = times({-root, 1}, {root + apart, -1});
    while (c.size() < 24) {
      const double centre = place(random), wide = width(random);
      c = times(c, {wide * wide + centre * centre, -2 * centre, 1});
    }
    const auto found = first_rise_of(c, 0);
    ASSERT_TRUE(found) << trial;
    long double sum = 0, size = 0;
    for (std::size_t k = c.size(); k-- > 0;) {
      sum = sum * *found + c[k];
      size = size * *found + std::abs(c[k]);
    }
    EXPECT_LE(std::abs(sum), 3e-16L * size) << trial;
  }
}

/// No rise that a thousand sampled points show is missed.
TEST(PolynomialRootFirstRise, IsNotPassedOverInRandomPolynomials) {
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  constexpr int points = 1000;
  int rises = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    std::vector<double> c;
    for (int k = 0; k <= 24; ++k) c.push_back(normal(random) * std::pow(2.5, k) / std::tgamma(k + 1.0));
    c[0] -= trial % 3;
    const auto found = first_rise_of(c, 0);
    const double until = found ? *found : 1;
    bool was_below = c[0] < 0;
    for (int i = 1; i <= points; ++i) {
      const double x = double(i) / points;
      if (x > until - 1e-9) break;
      const bool below = value(c, x) < -1e-14;
      ASSERT_FALSE(was_below && value(c, x) > 1e-14) << trial << " at " << x;
      was_below = was_below || below;
    }
    if (found) {
      EXPECT_NEAR(value(c, *found), 0, 1e-12) << trial;
      EXPECT_LT(value(c, std::max(0.0, *found - 1e-6)), 1e-13) << trial;
      ++rises;
    }
    EXPECT_FALSE(clearly_negative(c) && found);
  }
  EXPECT_GT(rises, 300);
}

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

TEST(PolynomialRootQuarticThrough, ReproducesThePolynomial) {
  const Polynomial p{{0.3, -2, 1.5, 0.7, -0.4}};
  const Quartic q = p.bernstein();
  for (double x = 0; x <= 1; x += 0.01) EXPECT_NEAR(evaluate(q, x), p(x), 1e-14);
}

TEST(PolynomialRootBernstein, AgreesWithFineSampling) {
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

TEST(PolynomialRootBernstein, SeesAGrazeThatEndsDisagreeOn) {
  // -(x - 0.37)^2 + h: negative at both ends, positive only within sqrt(h) of 0.37.
  const auto graze = [](double h) { return Polynomial{{h - 0.37 * 0.37, 0.74, -1, 0, 0}}; };
  const auto rise = bernstein_root(graze(1e-10).bernstein());
  ASSERT_TRUE(rise);
  EXPECT_NEAR(*rise, 0.37 - 1e-5, 1e-9);
  EXPECT_FALSE(bernstein_root(graze(-1e-10).bernstein()));
}

TEST(PolynomialRootBernstein, StartingAboveZeroMustFallFirst) {
  EXPECT_FALSE(bernstein_root(Polynomial{{0.1, 1, 0, 0, 0}}.bernstein()));
  EXPECT_FALSE(bernstein_root(Polynomial{{0, 1, 0, 0, 0}}.bernstein()));
  EXPECT_FALSE(bernstein_root(Polynomial{{0.1, -1, 0, 0, 0}}.bernstein()));
  // 0.02 - 0.3 x + x^2 falls at 0.1 and rises at 0.2.
  const auto rise = bernstein_root(Polynomial{{0.02, -0.3, 1, 0, 0}}.bernstein());
  ASSERT_TRUE(rise);
  EXPECT_NEAR(*rise, 0.2, 1e-10);
}

TEST(PolynomialRootBernstein, TakesTheFirstOfTwo) {
  // (x - 0.2)(x - 0.4)(x - 0.6) rises at 0.2 and 0.6.
  const auto rise = bernstein_root(Polynomial{{-0.048, 0.44, -1.2, 1, 0}}.bernstein());
  ASSERT_TRUE(rise);
  EXPECT_NEAR(*rise, 0.2, 1e-10);
}

TEST(PolynomialRootClearlyBelowZero, NeverHidesARiseOfTheCubic) {
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
