#include "rubsweep/ring/eigenvalues.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "ring/multiprecision.hpp"
#include "ring/random_system.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/numerics/assignment.hpp"

namespace rubsweep::ring {
namespace {

using Complex = std::complex<double>;

/// Largest distance of matched roots over the largest root.
double distance(const Eigen::VectorXcd& a, const std::vector<Complex>& b) {
  EXPECT_EQ(a.size(), static_cast<Eigen::Index>(b.size()));
  Eigen::MatrixXd cost(a.size(), a.size());
  for (Eigen::Index i = 0; i < a.size(); ++i) {
    for (Eigen::Index j = 0; j < a.size(); ++j) cost(i, j) = std::abs(a(i) - b[static_cast<std::size_t>(j)]);
  }
  double largest = 0;
  const auto match = numerics::cheapest_assignment(cost);
  for (Eigen::Index i = 0; i < a.size(); ++i)
    largest = std::max(largest, cost(i, match[static_cast<std::size_t>(i)]));
  return largest / size_of(a);
}

std::vector<Complex> list(const Eigen::VectorXcd& values) { return {values.begin(), values.end()}; }

TEST(Eigenvalues, OfThePapersSystemsHave15Digits) {
  for (const std::vector<double>& angles : {std::vector<double>{60}, {60, 87}, {60, 100, 180}}) {
    for (const double speed : {137.0, 300.0, 611.0, 1400.0}) {
      const System system = spring_masses(angles);
      EXPECT_LT(
          distance(eigenvalues(normal_form(system), speed * rpm), roots_with_50_digits(system, speed * rpm)),
          2e-14);
    }
  }
}

TEST(Eigenvalues, OfRandomSystemsAgreeWith50Digits) {
  RandomSystems random(1, 2);
  std::vector<double> errors;
  for (int i = 0; i < 40; ++i) {
    const System system = random.next();
    const double speed = random.between(0, 2) * critical_speed(system.ring);
    errors.push_back(distance(eigenvalues(normal_form(system), speed), roots_with_50_digits(system, speed)));
  }
  std::sort(errors.begin(), errors.end());
  RecordProperty("median", std::to_string(errors[errors.size() / 2] * 1e16));
  RecordProperty("largest", std::to_string(errors.back() * 1e16));
  EXPECT_LT(errors[errors.size() / 2], 1e-14);
  EXPECT_LT(errors.back(), 1e-11);
}

TEST(Eigenvalues, OfTheBareRingAreItsWaves) {
  for (const int n : {2, 3, 5, 12}) {
    System system{.ring = paper_ring(), .loads = {spring_mass(1, 0, 1)}, .friction_coefficient = 0};
    system.loads[0].motion = Motion::tangential;
    system.ring.nodal_diameters = n;
    const double critical = critical_speed(system.ring);
    for (const double speed : {0.0, 0.4 * critical, critical, 1.7 * critical}) {
      const double own2 = 1 - speed * speed;  // of the load: s^2 + 1 - speed^2 = 0
      const Complex load = std::sqrt(Complex(-own2));
      const double forward = n * std::abs(critical - speed), backward = n * (critical + speed);
      // Where the forward wave stands still its root is double at zero.
      EXPECT_LT(distance(eigenvalues(normal_form(system), speed),
                         {{0, forward}, {0, -forward}, {0, backward}, {0, -backward}, load, -load}),
                1e-13)
          << n << " " << speed;
    }
  }
}

TEST(Eigenvalues, OfEqualLoadsThatDoNotKnowEachOtherRepeat) {
  System system = spring_masses({10, 20, 30}, 0.1);
  for (Load& load : system.loads) load.motion = Motion::tangential;
  const double speed = 30, n = 2, critical = critical_speed(system.ring);
  const Complex load(-0.1 * speed, std::sqrt(1e4 - speed * speed - 0.01 * speed * speed));
  std::vector<Complex> expected{{0, n * (speed - critical)},
                                {0, -n * (speed - critical)},
                                {0, n * (speed + critical)},
                                {0, -n * (speed + critical)}};
  for (int j = 0; j < 3; ++j) expected.insert(expected.end(), {load, std::conj(load)});
  EXPECT_LT(distance(eigenvalues(normal_form(system), speed), expected), 1e-13);
  // Above the divergence three equal real roots grow.
  EXPECT_EQ(signature(normal_form(system), 110.0), (Signature{3, 3, 0}));
}

TEST(Eigenvalues, OfOppositeLoadsContainTheTangentialCase) {
  const double speed = 45;
  const Eigen::VectorXcd values = eigenvalues(normal_form(spring_masses({60, 240})), speed);
  const Complex expected(-0.1 * speed, std::sqrt(1e4 - 1.01 * speed * speed));
  EXPECT_LT((values.array() - expected).abs().minCoeff(), 1e-12 * size_of(values));
}

TEST(Eigenvalues, AtRestWithoutFrictionAreNeutralAndFrequenciesOfTheParts) {
  System system = spring_masses({0}, 0);
  const double a = amplitude_mass_kg(system.ring), own = std::sqrt((a * 34.4 * 34.4 + 4e6) / (a + 400));
  EXPECT_LT(distance(eigenvalues(normal_form(system), 0),
                     {{0, 34.4}, {0, -34.4}, {0, own}, {0, -own}, {0, 100}, {0, -100}}),
            1e-14);
}

TEST(Eigenvalues, WithoutFrictionMirrorAtBothAxes) {
  RandomSystems random(2, 3);
  for (int i = 0; i < 50; ++i) {
    System system = random.next();
    system.friction_coefficient = 0;
    const Eigen::VectorXcd values =
        eigenvalues(normal_form(system), random.between(0, 2) * critical_speed(system.ring));
    EXPECT_LT(distance(values, list(-values)),
              1e-7);  // double roots are known to the square root of the rounding
  }
}

TEST(Eigenvalues, DoNotDependOnWhereTheLoadsAreTogether) {
  RandomSystems random(3, 3);
  for (int i = 0; i < 50; ++i) {
    System system = random.next();
    const double speed = 0.7 * critical_speed(system.ring);
    const Eigen::VectorXcd before = eigenvalues(normal_form(system), speed);
    const double turn = random.between(0, 360);
    for (Load& load : system.loads) load.angle_deg += turn;
    EXPECT_LT(distance(before, list(eigenvalues(normal_form(system), speed))), 1e-9);
  }
}

TEST(Eigenvalues, PassThroughAnInclinationOf90Degrees) {
  System system = spring_masses({60}, 0.1);
  system.loads[0] = at(60, beam(185.66, 100, 1.175e7, 1e6));
  const auto values_at = [&](double inclination_deg) {
    system.loads[0].inclination_deg = inclination_deg;
    return eigenvalues(normal_form(system), 40);
  };
  // Linear in the angle on this scale, without a singularity.
  const Eigen::VectorXcd below = values_at(90 - 1e-5), there = values_at(90);
  EXPECT_LT(distance(below, list(there)), 1e-6);
  system.loads[0].inclination_deg = 90;
  EXPECT_LT(distance(there, roots_with_50_digits(system, 40)), 2e-14);
}

TEST(EigenvaluesSpectrum, SlopesAreTheDerivatives) {
  RandomSystems random(4, 3);
  for (int i = 0; i < 30; ++i) {
    const System system = random.next();
    const NormalForm form = normal_form(system);
    const double speed = 0.6 * critical_speed(system.ring), step = 1e-5 * critical_speed(system.ring);
    const Spectrum here = spectrum(form, speed);
    const Eigen::VectorXcd ahead = eigenvalues(form, speed + step), behind = eigenvalues(form, speed - step);
    for (Eigen::Index k = 0; k < here.values.size(); ++k) {
      const auto near = [&](const Eigen::VectorXcd& values, Complex place) {
        return *std::min_element(values.begin(), values.end(), [&](Complex a, Complex b) {
          return std::abs(a - place) < std::abs(b - place);
        });
      };
      const Complex predicted = here.slopes(k) * step;
      const Complex slope =
          (near(ahead, here.values(k) + predicted) - near(behind, here.values(k) - predicted)) / (2 * step);
      EXPECT_LT(std::abs(slope - here.slopes(k)), 1e-4 * (1 + std::abs(slope)));
    }
  }
}

TEST(EigenvaluesNormalForm, RefusesAMovingLoadWithoutMass) {
  System system{.ring = paper_ring(), .loads = {spring_mass(0, 1e6, 1e6)}, .friction_coefficient = 0.1};
  EXPECT_THROW(normal_form(system), ConfigError);
  system.loads[0].motion = Motion::radial;
  EXPECT_NO_THROW(normal_form(system));
}

TEST(EigenvaluesNormalForm, RefusesFrictionThatCancelsTheInertia) {
  System system{.ring = paper_ring(), .loads = {at(0, beam(300, 140, 1e7, 1e6))}, .friction_coefficient = 0};
  system.loads[0].inclination_deg = 45;
  const auto determinant = [&](double friction) {
    system.friction_coefficient = friction;
    return assemble(system).mass.determinant();
  };
  // det M is linear in the friction coefficient of a load at 0 degrees.
  const double at_zero = determinant(0), slope = determinant(1) - at_zero;
  system.friction_coefficient = -at_zero / slope;
  ASSERT_GT(system.friction_coefficient, 0);
  EXPECT_THROW(normal_form(system), ConfigError);
}

}  // namespace
}  // namespace rubsweep::ring
