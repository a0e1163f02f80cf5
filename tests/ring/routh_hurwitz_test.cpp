#include "ring/routh_hurwitz.hpp"

#include <gtest/gtest.h>

#include "ring/multiprecision.hpp"
#include "ring/random_system.hpp"
#include "rubsweep/ring/assembly.hpp"

namespace rubsweep::ring {
namespace {

TEST(RouthHurwitz, CountsKnownRoots) {
  // (s - 1)(s - 2)(s + 3) and (s + 1)(s^2 - 2 s + 5)
  EXPECT_EQ(routh_hurwitz_sign_changes<double>({1, 0, -7, 6}), std::nullopt);  // a zero in the first column
  EXPECT_EQ(routh_hurwitz_sign_changes<double>({1, 1.5, -6, -2.5}).value(), 1);
  EXPECT_EQ(routh_hurwitz_sign_changes<double>({1, -1, 3, 5}).value(), 2);
  EXPECT_EQ(routh_hurwitz_sign_changes<double>({1, 6, 11, 6}).value(), 0);
  EXPECT_EQ(routh_hurwitz_sign_changes<double>({1, 0, 4}), std::nullopt);  // neutral
}

TEST(RouthHurwitzCharacteristicPolynomial, OfACompanionMatrixIsItsPolynomial) {
  const std::vector<double> matrix{0, 1, 0, 0, 0, 1, -6, -11, -6};
  EXPECT_EQ(characteristic_polynomial(matrix, 3), (std::vector<double>{1, 6, 11, 6}));
}

TEST(RouthHurwitzCharacteristicPolynomial, OfOneRadialLoadIsThePapers) {
  // Eq. (2) of the paper: A s^4 + B s^3 + C s^2 + D s + E.
  System system = spring_masses({0}, 0.1);
  system.loads[0].motion = Motion::radial;
  const double w = 30, n = 2, n2 = n * n, m = 742, r = 100, k = 1e6, mu = 0.1;
  const double own = system.ring.modal_stiffness_n_per_m * n2 * 9, eta = surface_ratio(system.ring);
  const double a = m * (n2 + 1) * m * (n2 + 1) + m * (n2 + 1) * n2 * r;
  const double b = eta * mu * r * 2 * m * n2 * (n2 + 1) * w;
  const double c = own * (2 * m * (n2 + 1) + n2 * r) + m * n2 * w * w * (n2 + 1) * (n2 + 1) * (2 * m - r) +
                   m * (n2 + 1) * n2 * k;
  const double d = eta * (k - r * w * w) * mu * 2 * m * n2 * (n2 + 1) * w;
  const double e = (own - m * n2 * w * w * (n2 + 1)) * (own + n2 * k - n2 * w * w * (m * (n2 + 1) + r));
  const Eigen::VectorXcd values = eigenvalues(normal_form(system), w);
  for (const std::complex<double>& s : values) {
    const std::complex<double> terms[] = {a * s * s * s * s, b * s * s * s, c * s * s, d * s, e};
    std::complex<double> sum = 0;
    double size = 0;
    for (const auto& term : terms) {
      sum += term;
      size += std::abs(term);
    }
    EXPECT_LT(std::abs(sum), 1e-13 * size);
  }
}

TEST(RouthHurwitz, SignChangesAreTheUnstableEigenvaluesOf10000RandomSystems) {
  RandomSystems random(5, 3);
  int in_doubt = 0, unstable = 0;
  for (int i = 0; i < 10000; ++i) {
    const System system = random.next();
    const double speed = random.between(0, 3) * critical_speed(system.ring);
    const NormalForm form = normal_form(system);
    const Eigen::VectorXcd values = eigenvalues(form, speed);
    const int expected = signature(form, values).unstable_eigenvalues();
    unstable += expected > 0 ? 1 : 0;
    int changes = routh_hurwitz_with_long_double(system, speed);
    if (changes != expected) {  // a root close to the axis, or more digits needed than long double has
      ++in_doubt;
      changes = routh_hurwitz_with_50_digits(system, speed);
    }
    ASSERT_EQ(changes, expected) << "system " << i;
  }
  RecordProperty("with_50_digits", in_doubt);
  EXPECT_GT(unstable, 1000);
  EXPECT_LT(unstable, 9999);
}

}  // namespace
}  // namespace rubsweep::ring
