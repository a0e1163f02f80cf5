#include "rubsweep/core/response/lyapunov_exponent.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <vector>

#include "core/response/companion_growth.hpp"
#include "rubsweep/core/error.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::response {
namespace {

std::vector<double> contributions(const Growth& turn, std::vector<double>& section, int turns) {
  std::vector<double> all;
  for (int k = 0; k < turns; ++k) all.push_back(turn(section).value());
  return all;
}

/// Section after some turns, without a kick.
std::vector<double> late_section(proof::SceneMap& map, int turns) {
  std::vector<double> section{0.5, -0.2, 0, 0, 0.1, -1.2, 0, 0};
  for (int k = 0; k < turns; ++k) EXPECT_TRUE(map(section));
  return section;
}

TEST(LyapunovExponentGrowth, TangentOfAStableOrbitDecaysByItsMultiplier) {
  // The tangential motion along a wall at 90 degrees decays by zeta omega0 T per turn.
  const test::OneSideRotor rotor;
  integrate::exact::modes::ModeCache modes;
  proof::SceneMap map(test::cell_of(rotor).scene, {}, modes);
  auto section = late_section(map, 500);
  const auto exponent = exponent_of(contributions(tangent_growth(map), section, 400));
  EXPECT_NEAR(exponent.per_revolution,
              -2 * std::numbers::pi * rotor.damping_ratio * rotor.natural_frequency_hz / rotor.speed_hz,
              1e-6);
}

TEST(LyapunovExponentGrowth, TangentAndCompanionTellTheSameExponent) {
  test::OneSideRotor rotor;  // an irregular cell at the edge of a resonance tongue
  rotor.speed_hz = 69;
  rotor.whirl_ratio = 0.97;
  integrate::exact::modes::ModeCache modes;
  proof::SceneMap map(test::cell_of(rotor).scene, {}, modes);
  const auto start = late_section(map, 100);
  auto a = start, b = start;
  const auto tangent = exponent_of(contributions(tangent_growth(map), a, 600));
  const auto companion = exponent_of(contributions(test::companion_growth(std::ref(map), b), b, 600));
  EXPECT_EQ(a, b);
  EXPECT_NEAR(tangent.per_revolution, companion.per_revolution, 1e-3 + 0.2 * tangent.error_bar);
}

/// Turns without a closed form use differences for the tangent vector.
TEST(LyapunovExponentGrowth, OfTurnsByTheAdaptiveSolver) {
  integrate::run::SolverOptions adaptive;
  adaptive.method = integrate::run::Method::adaptive;
  adaptive.relative_tolerance = 1e-10;
  integrate::exact::modes::ModeCache modes;
  const auto scene = test::cell_of({}).scene;
  proof::SceneMap exact(scene, {}, modes), by_steps(scene, adaptive, modes);
  const auto start = late_section(exact, 20);
  auto a = start, b = start;
  const auto from_exact = contributions(tangent_growth(exact), a, 10);
  const auto from_steps = contributions(tangent_growth(by_steps), b, 10);
  for (std::size_t k = 0; k < from_exact.size(); ++k) EXPECT_NEAR(from_exact[k], from_steps[k], 2e-3) << k;
}

TEST(LyapunovExponentGrowth, EndsWhereTheTurnFails) {
  integrate::run::SolverOptions solver;
  solver.max_steps_per_revolution = 1;
  integrate::exact::modes::ModeCache modes;
  proof::SceneMap map(test::cell_of({}).scene, solver, modes);
  std::vector<double> section(8);
  EXPECT_FALSE(tangent_growth(map)(section));
  EXPECT_FALSE(test::companion_growth(std::ref(map), section)(section));
}

TEST(LyapunovExponentGrowthFirstDisturbance, HasTheSeparationAndAShareOfEveryCoordinate) {
  for (std::size_t states = 1; states <= 24; ++states) {
    const Eigen::VectorXd away = first_disturbance(states);
    EXPECT_GT(away.cwiseAbs().minCoeff(), 0.1 * separation / std::sqrt(static_cast<double>(states)));
    EXPECT_NEAR(away.norm(), separation, 1e-15);
  }
}

TEST(LyapunovExponentGrowthCompanion, IsPulledBackAlongTheLineToTheBase) {
  const std::vector<double> base{1, 2};
  test::Companion companion(base);
  companion.state()[0] = 1 + 3e-3;
  companion.state()[1] = 2 - 4e-3;
  EXPECT_NEAR(companion.pull_back(base), std::log(5e-3 / separation), 1e-9);
  EXPECT_NEAR(companion.state()[0], 1 + 0.6 * separation, 1e-15);
  EXPECT_NEAR(companion.state()[1], 2 - 0.8 * separation, 1e-15);
}

TEST(LyapunovExponentGrowthCompanion, StartsAnewWhenItFallsOntoTheBase) {
  const std::vector<double> base{1, 2};
  test::Companion companion(base);
  companion.state()[0] = 1;
  companion.state()[1] = 2;
  EXPECT_NEAR(companion.pull_back(base), std::log(1e-10), 1e-9);
  EXPECT_NEAR(std::hypot(companion.state()[0] - 1, companion.state()[1] - 2), separation, 1e-12);
}

constexpr double pi = std::numbers::pi;

/// Expects the exponent within its error bar, which must be smaller than `largest_bar`.
void expect_exponent(const proof::SectionMap& map, const std::vector<double>& state, int iterations,
                     double expected, double largest_bar) {
  const auto exponent = test::largest_exponent(map, state, iterations);
  ASSERT_TRUE(exponent);
  EXPECT_NEAR(exponent->per_revolution, expected, exponent->error_bar + 1e-9);
  EXPECT_LT(exponent->error_bar, largest_bar);
}

bool henon(double a, double b, std::span<double> s) {
  const double x = s[0];
  s[0] = 1 - a * x * x + s[1];
  s[1] = b * x;
  return true;
}

/// The angle is stored as a point on the unit circle, so that distances are continuous at 2 pi.
double angle(std::span<const double> point) { return std::atan2(point[1], point[0]); }
void set_angle(std::span<double> point, double phi) {
  point[0] = std::cos(phi);
  point[1] = std::sin(phi);
}

TEST(LyapunovExponentLargest, OfTheLogisticMapIsLnTwo) {
  const proof::SectionMap map = [](std::span<double> s) {
    s[0] = 4 * s[0] * (1 - s[0]);
    return true;
  };
  expect_exponent(map, {0.3}, 20000, std::numbers::ln2, 0.02);
}

TEST(LyapunovExponentLargest, OfHenonsMap) {
  // J. C. Sprott, Chaos and Time-Series Analysis (2003): 0.41922 for a = 1.4, b = 0.3.
  expect_exponent([](std::span<double> s) { return henon(1.4, 0.3, s); }, {0.1, 0.2}, 50000, 0.41922, 0.01);
}

TEST(LyapunovExponentLargest, OfArnoldsCatMap) {
  const proof::SectionMap map = [](std::span<double> s) {
    const double x = angle(s.first(2)), y = angle(s.last(2));
    set_angle(s.first(2), 2 * x + y);
    set_angle(s.last(2), x + y);
    return true;
  };
  expect_exponent(map, {std::cos(0.4), std::sin(0.4), std::cos(1.0), std::sin(1.0)}, 1000,
                  std::log((3 + std::sqrt(5)) / 2), 1e-6);
}

TEST(LyapunovExponentLargest, OfARotationIsZero) {
  const proof::SectionMap map = [](std::span<double> s) {
    const std::complex<double> z = std::complex<double>(s[0], s[1]) * std::polar(1.0, std::numbers::phi);
    s[0] = z.real();
    s[1] = z.imag();
    return true;
  };
  const auto exponent = test::largest_exponent(map, {0.6, 0.8}, 1000);
  EXPECT_NEAR(exponent.value().per_revolution, 0, 1e-10);
  EXPECT_LT(exponent->error_bar, 1e-10);
}

TEST(LyapunovExponentLargest, OfATorusThatStretchesUnevenlyIsZeroWithinAShortBar) {
  // Contributions of up to +-ln 9; the circle attracts.
  const proof::SectionMap map = [](std::span<double> s) {
    const double phi = angle(s), radius = std::hypot(s[0], s[1]);
    set_angle(s, phi + 2 * pi * 0.381 + 0.8 * std::sin(phi));
    for (double& x : s) x *= 1 + 0.5 * (radius - 1);
    return true;
  };
  expect_exponent(map, {0.6, 0.9}, 640, 0, 2e-3);
  expect_exponent(map, {0.6, 0.9}, 6400, 0, 2e-6);
}

TEST(LyapunovExponentLargest, OfAContractionIsItsSlowestRate) {
  const proof::SectionMap map = [](std::span<double> s) {
    s[0] *= 0.5;
    s[1] *= -0.9;
    s[2] *= 0.1;
    return true;
  };
  expect_exponent(map, {1, 1, 1}, 200, std::log(0.9), 1e-6);
}

TEST(LyapunovExponentLargest, OfAFixedPointIsItsLargestMultiplier) {
  // Henon's fixed point x = 1 - a x^2 + b x, with the multipliers -a x +- sqrt(a^2 x^2 + b).
  const double a = 0.2, b = 0.3;
  const double x = (-(1 - b) + std::sqrt((1 - b) * (1 - b) + 4 * a)) / (2 * a);
  const double multiplier = a * x + std::sqrt(a * a * x * x + b);
  expect_exponent([=](std::span<double> s) { return henon(a, b, s); }, {x, b * x}, 400, std::log(multiplier),
                  1e-6);
}

TEST(LyapunovExponentLargest, OfAPeriodTwoOrbitIsHalfThatOfItsSecondIterate) {
  // Henon's orbit of period two: x1 + x2 = (1 - b) / a, x1 x2 = ((1 - b)^2 - a) / a^2. The product of the two
  // Jacobians has the trace 4 a^2 x1 x2 + 2 b and the determinant b^2.
  const double a = 0.9, b = 0.3;
  const double half_trace = 2 * ((1 - b) * (1 - b) - a) + b;
  const double root = half_trace * half_trace - b * b;
  // The multipliers are real here; at a = 0.6 they are complex with modulus b.
  ASSERT_GT(root, 0);
  const double multiplier = std::abs(half_trace) + std::sqrt(root);
  const auto map = [=](double at) { return [=](std::span<double> s) { return henon(at, b, s); }; };
  std::vector<double> state{0.1, 0.1};
  for (int k = 0; k < 2000; ++k) henon(a, b, state);
  expect_exponent(map(a), state, 2000, std::log(multiplier) / 2, 1e-4);

  state = {0.1, 0.1};
  for (int k = 0; k < 2000; ++k) henon(0.6, b, state);
  expect_exponent(map(0.6), state, 2000, std::log(b) / 2, 5e-3);
}

TEST(LyapunovExponentLargest, NoiseBelowTheSeparationDoesNotTurnAContractionIntoChaos) {
  unsigned long bits = 1;
  const proof::SectionMap map = [&bits](std::span<double> s) {
    for (double& x : s) {
      bits = bits * 6364136223846793005UL + 1442695040888963407UL;
      x = 0.8 * x + 1e-7 * (static_cast<double>(bits >> 11) * 0x1p-53 - 0.5);
    }
    return true;
  };
  expect_exponent(map, {0.1, 0.2}, 2000, std::log(0.8), 0.01);
}

TEST(LyapunovExponentLargest, IsEmptyWhenTheMapFails) {
  int calls = 0;
  const proof::SectionMap map = [&calls](std::span<double>) { return ++calls < 100; };
  EXPECT_FALSE(test::largest_exponent(map, {1}, 60));
  calls = 0;
  EXPECT_TRUE(test::largest_exponent(map, {1}, 45));
}

TEST(LyapunovExponentOf, IsTheMeanOfEightBlocksWithTheirStudentInterval) {
  // Blocks of 10 with the values 1 ... 8, after a first fifth that must not count: mean 4.5, variance 6.
  std::vector<double> contributions(20, 1e6);
  for (int k = 0; k < 80; ++k) contributions.push_back(1 + k / 10);
  const motion::Exponent exponent = exponent_of(contributions);
  EXPECT_NEAR(exponent.per_revolution, 4.5, 1e-14);
  EXPECT_NEAR(exponent.error_bar, 3.499483 * std::sqrt(6.0 / 8), 1e-6);
}

TEST(LyapunovExponentOf, WeighsTheMiddleOfABlock) {
  // Whole waves per block average out exactly; a fraction that a rectangular window would keep almost does.
  for (const double waves : {2.0, 7.0, 4.37}) {
    std::vector<double> contributions;
    for (int k = 0; k < 800; ++k) contributions.push_back(0.25 + std::sin(2 * pi * waves * k / 80));
    EXPECT_NEAR(exponent_of(contributions).per_revolution, 0.25, 2e-3) << waves;
    EXPECT_LT(exponent_of(contributions).error_bar, 5e-3) << waves;
  }
}

TEST(LyapunovExponentOf, RefusesFewerThanFortyContributions) {
  EXPECT_NO_THROW(exponent_of(std::vector<double>(40)));
  EXPECT_THROW(exponent_of(std::vector<double>(39)), SolverError);
}

/// Mean of an oscillation that never repeats: smooth weights find it within 1e-6, equal weights only within
/// 1e-3.
TEST(LyapunovExponentBumpMean, ConvergesFastOnQuasiPeriodicContributions) {
  std::vector<double> contributions;
  double sum = 0;
  for (int k = 0; k < 400; ++k) {
    contributions.push_back(0.3 + std::cos(2.39996322972865332 * k + 0.2));
    sum += contributions.back();
  }
  EXPECT_NEAR(bump_mean(contributions), 0.3, 1e-6);
  EXPECT_GT(std::abs(sum / 400 - 0.3), 1e-4);
  EXPECT_EQ(bump_mean({}), 0);
  EXPECT_NEAR(bump_mean(std::vector<double>(7, 1.5)), 1.5, 1e-15);
}

TEST(LyapunovExponent, HasClosedFormsForOneAndTwoDegreesOfFreedom) {
  EXPECT_NEAR(student_quantile(1), std::tan(std::numbers::pi * 0.495), 1e-11);
  EXPECT_NEAR(student_quantile(2), 0.99 / std::sqrt(2 * 0.995 * 0.005), 1e-13);
}

TEST(LyapunovExponent, IsThatOfPrintedTables) {
  EXPECT_NEAR(student_quantile(6), 3.7074, 5e-5);
  EXPECT_NEAR(student_quantile(7), 3.4995, 5e-5);
  EXPECT_NEAR(student_quantile(30), 2.7500, 5e-5);
}

}  // namespace

}  // namespace rubsweep::response
