#include "rubsweep/core/scene/quiet_motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <random>

#include "rubsweep/core/structure/assembly.hpp"

namespace rubsweep::scene {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

/// A structure without any symmetry: a full stiffness matrix, and damping with a gyroscopic part.
structure::LinearSystem full_system(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto any = [&] {
    return Eigen::MatrixXd(Eigen::MatrixXd::NullaryExpr(4, 4, [&] { return uniform(random); }));
  };
  const Eigen::MatrixXd a = any(), b = any();
  structure::LinearSystem system;
  system.mass = a * a.transpose() + Eigen::MatrixXd::Identity(4, 4);
  system.stiffness = b * b.transpose() + 3 * Eigen::MatrixXd::Identity(4, 4);
  system.damping = 0.3 * any();
  system.points = {{any().topRows(2)}, {any().topRows(2)}};
  return system;
}

TEST(QuietMotion, IsTheClosedFormOfTheJeffcottRotor) {
  std::mt19937_64 random(1);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  for (int trial = 0; trial < 2000; ++trial) {
    const model::JeffcottRotor rotor{uniform(0.1, 10), uniform(5, 200), uniform(0.005, 1.5)};
    const double s = uniform(0.05, 8), w = s * 2 * pi * rotor.natural_frequency_hz, e = uniform(1e-6, 1e-2);
    const auto system = structure::assemble_jeffcott(rotor, {}).system;
    const QuietMotion motion =
        quiet_motion(system, w, e * w * w * system.unbalance_kg, Eigen::Vector2d::Zero());
    // z = A e^{i (w t + psi)}, so x = Re z has the phasor A e^{i psi} and y = Im z has -i A e^{i psi}.
    const double zeta = rotor.damping_ratio;
    const double a = e * s * s / std::hypot(1 - s * s, 2 * zeta * s);
    const Complex whirl = std::polar(a, -std::atan2(2 * zeta * s, 1 - s * s));
    EXPECT_LE(std::abs(motion.amplitude(0) - whirl), 1e-12 * a) << "s = " << s << ", zeta = " << zeta;
    EXPECT_LE(std::abs(motion.amplitude(1) - Complex(0, -1) * whirl), 1e-12 * a);
    EXPECT_EQ(motion.mean, Eigen::Vector2d::Zero());
  }
}

TEST(QuietMotion, SolvesTheEquationsOfMotion) {
  for (unsigned seed = 1; seed < 20; ++seed) {
    const auto system = full_system(seed);
    const double w = 0.2 * seed;
    const Eigen::Vector4cd harmonic(Complex(1, 2), -0.5, Complex(0, 3), 0.7);
    const Eigen::Vector4d constant(0.3, -2, 0, 1);
    const QuietMotion motion = quiet_motion(system, w, harmonic, constant);
    for (const double phase : {0.0, 0.7, 2.1, 5.5}) {
      const Eigen::VectorXd q = motion.displacement(phase), rate = w * motion.velocity(phase);
      const Eigen::VectorXd acceleration = -w * w * (q - motion.mean);
      const Eigen::VectorXd force = constant + (harmonic * std::polar(1.0, phase)).real();
      const Eigen::VectorXd residual =
          system.mass * acceleration + system.damping * rate + system.stiffness * q - force;
      EXPECT_LE(residual.norm(), 1e-11 * (force.norm() + q.norm()));
    }
  }
}

TEST(QuietMotion, VelocityIsTheDifferenceQuotientOfTheDisplacement) {
  QuietMotion motion;
  motion.mean = Eigen::Vector2d(0.5, -3);
  motion.amplitude = Eigen::Vector2cd(Complex(1, 2), Complex(-0.3, 0.1));
  const double h = 1e-5;
  for (const double phase : {0.0, 1.0, 4.0}) {
    const Eigen::VectorXd quotient =
        (motion.displacement(phase + h) - motion.displacement(phase - h)) / (2 * h);
    EXPECT_LE((motion.velocity(phase) - quotient).norm(), 1e-9);
  }
}

TEST(QuietMotion, AnUndampedPartAtItsOwnFrequencyRestsUnlessDriven) {
  // The second mass is undamped and at resonance. Without a force it rests; with one it has no steady motion.
  structure::LinearSystem system;
  system.mass = Eigen::Matrix2d::Identity();
  system.damping = Eigen::Vector2d(0.1, 0).asDiagonal();
  system.stiffness = Eigen::Vector2d(9, 4).asDiagonal();
  Eigen::VectorXcd force(2);
  force << 1, 0;
  const QuietMotion motion = quiet_motion(system, 2, force, Eigen::VectorXd::Zero(2));
  EXPECT_LT(std::abs(motion.amplitude(0) - 1.0 / std::complex<double>(5, 0.2)), 1e-15);
  EXPECT_EQ(motion.amplitude(1), 0.0);
  force(1) = 1e-9;
  EXPECT_FALSE(quiet_motion(system, 2, force, Eigen::VectorXd::Zero(2)).amplitude.allFinite());
}

TEST(QuietMotion, IsNotFiniteAtAnUndampedResonance) {
  const model::JeffcottRotor rotor{0.8, 30, 0};
  const auto system = structure::assemble_jeffcott(rotor, {}).system;
  const double w = 2 * pi * 30;
  const Eigen::VectorXcd force = w * w * system.unbalance_kg;
  EXPECT_FALSE(quiet_motion(system, w, force, Eigen::Vector2d::Zero()).amplitude.allFinite());
}

TEST(QuietMotionPenetration, IsTheLargestOfTheSampledMotion) {
  const auto system = full_system(5);
  const QuietMotion motion = quiet_motion(system, 1.3, Eigen::Vector4cd(1, Complex(0, 1), 0.3, -2),
                                          Eigen::Vector4d(0.1, 0.2, -0.3, 0.4));
  Contact contact;
  const Eigen::Vector2d normal(std::cos(0.4), std::sin(0.4));
  contact.wall = contact::FlatWall{normal};
  contact.clearance_m = 0.25;
  for (const bool moving_casing : {false, true}) {
    if (moving_casing) contact.casing_point = 1;
    double largest = -1e9, smallest = 1e9;
    for (int i = 0; i < 20'000; ++i) {
      const Eigen::VectorXd q = motion.displacement(2 * pi * i / 20'000);
      Eigen::Vector2d d = system.points[0].map * q;
      if (moving_casing) d -= system.points[1].map * q;
      const double p = d.dot(normal) - 0.25;
      largest = std::max(largest, p);
      smallest = std::min(smallest, p);
    }
    const auto [mean, amplitude] = quiet_penetration(motion, system, contact);
    EXPECT_NEAR(mean + amplitude, largest, 1e-7);
    EXPECT_NEAR(mean - amplitude, smallest, 1e-7);
    EXPECT_GT(amplitude, 0.01);
  }
}

/// An annular stop around a point that moves freely in the plane; its coordinates are q itself.
struct InsideAnnularStop {
  structure::LinearSystem structure;
  Contact contact;

  InsideAnnularStop() {
    structure.points = {{Eigen::MatrixXd::Identity(2, 2)}};
    contact.wall = contact::AnnularWall{};
    contact.clearance_m = 2;
  }

  /// Largest penetration |d| - clearance over one turn.
  double largest_sampled(const QuietMotion& motion) const {
    double largest = -1e9;
    for (int i = 0; i < 20'000; ++i) {
      const Eigen::Vector2d d = motion.displacement(2 * pi * i / 20'000) + contact::offset(contact.wall);
      largest = std::max(largest, d.norm() - contact.clearance_m);
    }
    return largest;
  }
};

TEST(QuietMotionPenetration, OfACircleInAnAnnularStopIsTheLargestOfTheSampledMotion) {
  InsideAnnularStop in;
  for (const double turn : {1.0, -1.0}) {
    const QuietMotion circle{Eigen::Vector2d(0.3, 0.2), Eigen::Vector2cd(0.7, Complex(0, -0.7 * turn))};
    for (const Eigen::Vector2d& offset : {Eigen::Vector2d(0, 0), Eigen::Vector2d(-0.1, 0.6)}) {
      in.contact.wall = contact::AnnularWall{offset};
      const auto [mean, amplitude] = quiet_penetration(circle, in.structure, in.contact);
      EXPECT_NEAR(amplitude, 0.7, 1e-15);
      EXPECT_NEAR(mean + amplitude, in.largest_sampled(circle), 1e-7);
    }
  }
}

TEST(QuietMotionPenetration, OfAnEllipseInAnAnnularStopIsExactAboutTheCentreAndABoundElsewhere) {
  InsideAnnularStop in;
  QuietMotion ellipse{Eigen::Vector2d(0, 0), Eigen::Vector2cd(Complex(0.5, 0.2), Complex(-0.1, 0.4))};
  const auto [mean, amplitude] = quiet_penetration(ellipse, in.structure, in.contact);
  EXPECT_EQ(mean, -2);
  EXPECT_NEAR(mean + amplitude, in.largest_sampled(ellipse), 1e-7);
  for (int i = 0; i < 12; ++i) {
    in.contact.wall = contact::AnnularWall{{std::cos(i * pi / 6), std::sin(i * pi / 6)}};
    const auto bound = quiet_penetration(ellipse, in.structure, in.contact);
    EXPECT_GE(bound.mean + bound.amplitude, in.largest_sampled(ellipse));
  }
}

TEST(QuietMotionNearestWall, IsTheNormalOrTheDirectionOfTheMeanOffset) {
  InsideAnnularStop in;
  QuietMotion motion{Eigen::Vector2d(0, 0), Eigen::Vector2cd(0, 0)};
  EXPECT_EQ(nearest_wall(motion, in.structure, in.contact), Eigen::Vector2d(0, 1));
  in.contact.wall = contact::AnnularWall{{3, 0}};
  EXPECT_EQ(nearest_wall(motion, in.structure, in.contact), Eigen::Vector2d(1, 0));
  motion.mean = Eigen::Vector2d(0, -4);
  EXPECT_LE((nearest_wall(motion, in.structure, in.contact) - Eigen::Vector2d(0.6, -0.8)).norm(), 1e-15);
  in.contact.wall = contact::FlatWall{{-1, 0}};
  EXPECT_EQ(nearest_wall(motion, in.structure, in.contact), Eigen::Vector2d(-1, 0));
}

TEST(QuietMotionRelativeMap, IsRotorMinusCasing) {
  const auto system = full_system(2);
  Contact contact;
  EXPECT_EQ(relative_map(system, contact), system.points[0].map);
  contact.casing_point = 1;
  EXPECT_EQ(relative_map(system, contact), system.points[0].map - system.points[1].map);
}

using Complex = std::complex<double>;
using std::numbers::pi;

TEST(QuietMotionTwoOrders, OneOrderHasItsAmplitude) {
  const TopOfMotion first = largest_value(std::polar(3.0, 0.7), 0);
  EXPECT_NEAR(first.value, 3, 1e-15);
  EXPECT_NEAR(first.phase_rad, 2 * pi - 0.7, 1e-14);
  const TopOfMotion second = largest_value(0, std::polar(2.0, -1.0));
  EXPECT_NEAR(second.value, 2, 1e-15);
  EXPECT_NEAR(second.phase_rad, 0.5, 1e-14);  // the first of two maxima
  EXPECT_EQ(largest_value(0, 0).value, 0);
}

/// cos x + a cos 2x with a > 1/4 has the minimum -a - 1/(8a) at cos x = -1/(4a).
TEST(QuietMotionTwoOrders, TheLeastValueOfTwoCosinesIsKnown) {
  for (const double a : {0.3, 0.5, 2.0}) {
    const TopOfMotion top = largest_value(-1, -a);
    EXPECT_NEAR(top.value, a + 1 / (8 * a), 1e-14);
    EXPECT_NEAR(std::cos(top.phase_rad), -1 / (4 * a), 1e-13);
  }
}

/// Forward circles at 1X and 2X: |r1 e^{i x} + r2 e^{2 i x + i d}| = r1 + r2 where both vectors are parallel.
TEST(QuietMotionTwoOrders, TwoCirclesReachTheSumOfTheirRadii) {
  const double r1 = 0.8, r2 = 0.5, d = 1.1;
  const Complex i(0, 1), turned = std::polar(r2, d);
  const TopOfMotion top = largest_distance({r1, -i * r1}, {turned, -i * turned});
  EXPECT_NEAR(top.value, r1 + r2, 1e-14);
  EXPECT_NEAR(std::cos(top.phase_rad + d), 1, 1e-14);
}

/// No value on a fine grid exceeds the maximum, and the maximum is reached.
TEST(QuietMotionTwoOrders, NothingIsAboveTheTop) {
  for (int seed = 0; seed < 40; ++seed) {
    const auto number = [&](int k) { return std::polar(1 + std::sin(seed + 3.0 * k), 1.7 * seed * k + k); };
    const Eigen::Vector2cd first(number(1), number(2)), second(number(3), number(4));
    const auto place = [&](double x) {
      return Eigen::Vector2d((first * std::polar(1.0, x) + second * std::polar(1.0, 2 * x)).real());
    };
    double far = 0, high = -1e9;
    for (int k = 0; k < 20000; ++k) {
      const Eigen::Vector2d z = place(2 * pi * k / 20000);
      far = std::max(far, z.norm());
      high = std::max(high, z.x());
    }
    const TopOfMotion farthest = largest_distance(first, second),
                      highest = largest_value(first(0), second(0));
    EXPECT_LE(far, farthest.value * (1 + 1e-14));
    EXPECT_NEAR(far, farthest.value, 1e-6 * far);
    EXPECT_NEAR(place(farthest.phase_rad).norm(), farthest.value, 1e-13 * far);
    EXPECT_LE(high, highest.value + 1e-13);
    EXPECT_NEAR(place(highest.phase_rad).x(), highest.value, 1e-13);
  }
}

TEST(QuietMotionTwoOrders, NumbersThatAreNotFiniteReachEverywhere) {
  const double none = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(largest_value(none, 1).value, inf);
  EXPECT_EQ(largest_distance({1, inf}, {0, 1}).value, inf);
}

}  // namespace

}  // namespace rubsweep::scene
