#include "rubsweep/ring/assembly.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "ring/energies.hpp"
#include "ring/multiprecision.hpp"
#include "ring/random_system.hpp"
#include "ring/support.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/numerics/assignment.hpp"

// Compares the assembled matrices entry by entry with the paper's appendices (including the errata of
// results/ring_findings.txt), and both with an independent assembly from energies.
namespace rubsweep::ring {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double deg = std::numbers::pi / 180;

/// Matrices M, G + R, K and vector F at one speed.
struct Equations {
  MatrixXd mass, damping, stiffness;
  VectorXd force;
};

Equations zero(Eigen::Index size) {
  const MatrixXd none = MatrixXd::Zero(size, size);
  return {none, none, none, VectorXd::Zero(size)};
}

Equations library(const System& system, double speed) {
  const Matrices m = assemble(system);
  return {m.mass, speed * m.rotation, m.stiffness - speed * speed * m.softening,
          m.force + speed * speed * m.centrifugal};
}

void expect_equal(const Equations& found, const Equations& expected, double tolerance) {
  const auto compare = [&](const MatrixXd& a, const MatrixXd& b, const char* name) {
    const double scale = b.cwiseAbs().maxCoeff();
    for (Eigen::Index i = 0; i < b.rows(); ++i) {
      for (Eigen::Index j = 0; j < b.cols(); ++j) {
        EXPECT_NEAR(a(i, j), b(i, j), tolerance * scale) << name << " " << i << " " << j;
      }
    }
  };
  compare(found.mass, expected.mass, "M");
  compare(found.damping, expected.damping, "G + R");
  compare(found.stiffness, expected.stiffness, "K");
  compare(found.force, expected.force, "F");
}

/// Data of the machine, used by both assemblies.
struct Machine {
  RingSection ring{};
  RingGeometry ring_geometry{};
  int n = 2;
  double friction = 0.3, preload = 0;
  std::vector<BeamGeometry> beams;
  std::vector<double> angles_deg, inclinations_deg;
};

Machine machine(int n, const std::vector<double>& angles_deg, const std::vector<double>& inclinations_deg) {
  Machine m;
  m.n = n;
  m.ring_geometry = {1.2, 0.05, 0.3, 7800, 2.1e11};
  const auto& g = m.ring_geometry;
  m.ring = {static_cast<long double>(g.density_kg_per_m3) * g.width_m * g.thickness_m,
            static_cast<long double>(g.youngs_modulus_pa) * g.width_m * g.thickness_m * g.thickness_m *
                g.thickness_m / 12,
            g.radius_m, g.thickness_m};
  m.angles_deg = angles_deg;
  m.inclinations_deg = inclinations_deg;
  for (std::size_t j = 0; j < angles_deg.size(); ++j) {
    m.beams.push_back({7800, 0.02 + 0.01 * static_cast<double>(j), 4e-4, 2.1e11});
  }
  return m;
}

System system_of(const Machine& m) {
  System system{.ring = ring(m.ring_geometry, m.n),
                .loads = {},
                .friction_coefficient = m.friction,
                .preload_n = m.preload};
  for (std::size_t j = 0; j < m.beams.size(); ++j) {
    Load load = beam(m.beams[j], m.ring_geometry.radius_m);
    load.angle_deg = m.angles_deg[j];
    load.inclination_deg = m.inclinations_deg[j];
    system.loads.push_back(load);
  }
  return system;
}

/// Coordinate 2 + j of the reduced system: the beam's bending v (the paper's choice) or the tip's tangential
/// deflection q.
enum class Coordinate { flexure, tangential };

/// Contact by a Lagrange multiplier N: tip forces x = N nu - mu N tau, ring forces from the work of N and mu
/// N. The multiplier follows from the constraint u_s + u cos a - v sin a = 0.
Equations from_energies(const Machine& m, double speed, Coordinate coordinate) {
  const auto count = static_cast<Eigen::Index>(m.beams.size());
  Equations e = zero(2 + count);
  const Unconstrained own = ring_energies(m.ring, m.n, speed);
  e.mass.topLeftCorner<2, 2>() += own.mass;
  e.damping.topLeftCorner<2, 2>() += own.rotation;
  e.stiffness.topLeftCorner<2, 2>() += own.stiffness;
  for (Eigen::Index j = 0; j < count; ++j) {
    const auto index = static_cast<std::size_t>(j);
    const Unconstrained load = beam_energies(m.beams[index], m.ring_geometry.radius_m, speed);
    const double phi = m.angles_deg[index] * deg, alpha = m.inclinations_deg[index] * deg, n = m.n;
    const Eigen::RowVector2d normal(-std::cos(alpha), std::sin(alpha)),
        tangent(std::sin(alpha), std::cos(alpha));
    // Rows over (A, B, own coordinate): radial displacement of the ring, and displacement of its surface.
    Eigen::RowVector3d radial(-n * std::sin(n * phi), n * std::cos(n * phi), 0);
    Eigen::RowVector3d slope(-n * n * std::cos(n * phi), -n * n * std::sin(n * phi), 0);
    Eigen::RowVector3d centre(std::cos(n * phi), std::sin(n * phi), 0);
    const double half = m.ring_geometry.thickness_m / (2 * m.ring_geometry.radius_m);
    const Eigen::RowVector3d surface = centre * (1 - half) - half * slope;
    // Tip displacements from the constraint and the own coordinate.
    Eigen::Matrix2d conditions;
    conditions.row(0) = normal;
    conditions.row(1) = coordinate == Coordinate::flexure ? Eigen::RowVector2d(0, 1) : tangent;
    Eigen::Matrix<double, 2, 3> given;
    given.row(0) = radial;
    given.row(1) = Eigen::RowVector3d(0, 0, 1);
    const Eigen::Matrix<double, 2, 3> tip = conditions.inverse() * given;
    // Virtual work of a friction force on the ring and, with opposite sign, on the tip.
    const Eigen::Vector3d rub = (surface - tangent * tip).transpose();
    const Eigen::Matrix<double, 3, 2> reach = tip.transpose() - m.friction * rub * normal;
    const Eigen::Vector3i at(0, 1, static_cast<int>(2 + j));
    const auto add = [&](MatrixXd& target, const MatrixXd& part) {
      const Eigen::Matrix3d reduced = reach * part * tip;
      for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) target(at(r), at(c)) += reduced(r, c);
      }
    };
    add(e.mass, load.mass);
    add(e.damping, load.rotation);
    add(e.stiffness, load.stiffness);
    const Eigen::Vector3d force = reach * (load.force - m.preload * normal.transpose());
    for (int r = 0; r < 3; ++r) e.force(at(r)) += force(r);
  }
  return e;
}

/// Equations of the ring alone, which both appendices contain, with zeros for the loads.
Equations ring_alone(const System& system, double speed) {
  Equations e = zero(2 + static_cast<Eigen::Index>(system.loads.size()));
  const double n = system.ring.nodal_diameters, big = system.ring.modal_mass_kg * (n * n + 1);
  e.mass.topLeftCorner<2, 2>().diagonal().setConstant(big);
  e.damping(0, 1) = -2 * big * n * speed;
  e.damping(1, 0) = 2 * big * n * speed;
  e.stiffness.topLeftCorner<2, 2>().diagonal().setConstant(
      system.ring.modal_stiffness_n_per_m * n * n * (n * n - 1) * (n * n - 1) - big * n * n * speed * speed);
  return e;
}

/// Appendix A as printed, with the errata for M13, M23, K13, K23, K33.
Equations appendix_a(const System& system, double speed) {
  const auto count = static_cast<Eigen::Index>(system.loads.size());
  Equations e = ring_alone(system, speed);
  const double n = system.ring.nodal_diameters, mu = system.friction_coefficient;
  const double eta = 1 + system.ring.thickness_ratio / 2 * (n * n - 1), w2 = speed * speed;
  for (Eigen::Index j = 0; j < count; ++j) {
    const Load& load = system.loads[static_cast<std::size_t>(j)];
    const double a = load.inclination_deg * deg, ca = std::cos(a), sa = std::sin(a), ta = std::tan(a);
    const double s = std::sin(n * load.angle_deg * deg), c = std::cos(n * load.angle_deg * deg);
    const double mr = load.radial_mass_kg, mt = load.flexural_mass_kg, ms = mt - load.rotary_mass_kg;
    const double kr = load.radial_stiffness_n_per_m - mr * w2,
                 kt = load.tangential_stiffness_n_per_m - ms * w2;
    const double g = 2 * mr / std::numbers::pi;  // rho S R / pi
    const double ec = eta * c - n * s * ta, es = eta * s + n * c * ta, one = ca + sa * ta;
    const Eigen::Index q = 2 + j;
    const auto block = [&](MatrixXd& target, double r, double rt) {
      target(0, 0) += r * n * n * s * s / (ca * ca) + mu * r * ec * n * s;
      target(0, 1) += -r * n * n * s * c / (ca * ca) - mu * r * ec * n * c;
      target(1, 0) += -r * n * n * s * c / (ca * ca) + mu * r * es * n * s;
      target(1, 1) += r * n * n * c * c / (ca * ca) - mu * r * es * n * c;
      target(0, q) += r * n * s * ta / ca + mu * ec * (r - rt) * sa;
      target(1, q) += -r * n * c * ta / ca + mu * es * (r - rt) * sa;
      target(q, 0) += r * (ta / ca - mu * one) * n * s;
      target(q, 1) += -r * (ta / ca - mu * one) * n * c;
      target(q, q) += rt + r * ta * ta - mu * one * (r - rt) * sa;
    };
    block(e.mass, mr, mt);
    block(e.stiffness, kr, kt);
    MatrixXd& d = e.damping;
    d(0, q) += -2 * g * speed * n * s / ca - 2 * mu * g * speed * one * ec;
    d(1, q) += 2 * g * speed * n * c / ca - 2 * mu * g * speed * one * es;
    d(q, 0) += 2 * g * speed * n * s / ca + 2 * mu * g * speed * n * s * ta * one;
    d(q, 1) += -2 * g * speed * n * c / ca - 2 * mu * g * speed * n * c * ta * one;
    d(q, q) += 2 * mu * g * speed * one * one;
    d(0, 0) += -2 * mu * g * speed * n * s * ta * ec;
    d(0, 1) += 2 * mu * g * speed * n * c * ta * ec;
    d(1, 0) += -2 * mu * g * speed * n * s * ta * es;
    d(1, 1) += 2 * mu * g * speed * n * c * ta * es;
    // A centrifugal force along the beam causes a normal force with its cosine; the paper omits the cosine in
    // the friction terms of F.
    const double pull = load.centrifugal_mass_kg * system.ring.radius_m.value() * w2;
    e.force(0) += pull * n * s / ca + mu * ec * pull * ca;
    e.force(1) += -pull * n * c / ca + mu * es * pull * ca;
    e.force(q) += pull * ta - mu * one * pull * ca;
  }
  return e;
}

/// Appendix B as printed.
Equations appendix_b(const System& system, double speed) {
  const auto count = static_cast<Eigen::Index>(system.loads.size());
  Equations e = ring_alone(system, speed);
  const double n = system.ring.nodal_diameters, mu = system.friction_coefficient;
  const double eta = 1 + system.ring.thickness_ratio / 2 * (n * n - 1), w2 = speed * speed;
  for (Eigen::Index j = 0; j < count; ++j) {
    const Load& load = system.loads[static_cast<std::size_t>(j)];
    const double s = std::sin(n * load.angle_deg * deg), c = std::cos(n * load.angle_deg * deg),
                 m = load.radial_mass_kg;
    const Eigen::Index q = 2 + j;
    const auto block = [&](MatrixXd& target, double r, double own) {
      target(0, 0) += r * n * n * s * s + mu * eta * r * n * s * c;
      target(0, 1) += -r * n * n * s * c - mu * eta * r * n * c * c;
      target(1, 0) += -r * n * n * s * c + mu * eta * r * n * s * s;
      target(1, 1) += r * n * n * c * c - mu * eta * r * n * s * c;
      target(q, 0) += -mu * r * n * s;
      target(q, 1) += mu * r * n * c;
      target(q, q) += own;
    };
    block(e.mass, m, m);
    block(e.stiffness, load.radial_stiffness_n_per_m - m * w2, load.tangential_stiffness_n_per_m - m * w2);
    e.damping(0, q) += -2 * m * speed * n * s - 2 * mu * m * speed * c * eta;
    e.damping(1, q) += 2 * m * speed * n * c - 2 * mu * m * speed * s * eta;
    e.damping(q, 0) += 2 * m * speed * n * s;
    e.damping(q, 1) += -2 * m * speed * n * c;
    e.damping(q, q) += 2 * mu * m * speed;
    const double press = m * system.ring.radius_m.value() * w2 + system.preload_n;
    e.force(0) += press * n * s + mu * eta * press * c;
    e.force(1) += -press * n * c + mu * eta * press * s;
    e.force(q) += -mu * press;
  }
  return e;
}

/// The same equations in other coordinates Y, where X = map Y.
Equations in_coordinates(const Equations& e, const MatrixXd& map) {
  return {map.transpose() * e.mass * map, map.transpose() * e.damping * map,
          map.transpose() * e.stiffness * map, map.transpose() * e.force};
}

/// Maps (A, B, q) to (A, B, v): v = u_s sin a + q cos a.
MatrixXd flexure_from_tangential(const System& system) {
  const auto size = static_cast<Eigen::Index>(2 + system.loads.size());
  MatrixXd map = MatrixXd::Identity(size, size);
  for (Eigen::Index j = 0; j + 2 < size; ++j) {
    const Load& load = system.loads[static_cast<std::size_t>(j)];
    const double n = system.ring.nodal_diameters, phi = n * load.angle_deg * deg,
                 a = load.inclination_deg * deg;
    map(2 + j, 0) = -n * std::sin(phi) * std::sin(a);
    map(2 + j, 1) = n * std::cos(phi) * std::sin(a);
    map(2 + j, 2 + j) = std::cos(a);
  }
  return map;
}

class AssemblyBeams : public testing::TestWithParam<int> {};

TEST_P(AssemblyBeams, AppendixAIsWhatTheEnergiesGive) {
  const Machine m = machine(GetParam(), {17, 140, -75}, {12, 0, -50});
  for (const double speed : {0.0, 7.3, 61.0}) {
    expect_equal(appendix_a(system_of(m), speed), from_energies(m, speed, Coordinate::flexure), 1e-12);
  }
}

TEST_P(AssemblyBeams, LibraryIsWhatTheEnergiesGive) {
  Machine m = machine(GetParam(), {17, 140, -75, 200}, {12, 0, -50, 90});
  m.preload = 3000;
  for (const double speed : {0.0, 7.3, 61.0}) {
    expect_equal(library(system_of(m), speed), from_energies(m, speed, Coordinate::tangential), 1e-12);
  }
}

TEST_P(AssemblyBeams, LibraryIsAppendixAInAnotherCoordinate) {
  const Machine m = machine(GetParam(), {17, 140, -75}, {12, 0, -50});
  const System system = system_of(m);
  expect_equal(library(system, 31), in_coordinates(appendix_a(system, 31), flexure_from_tangential(system)),
               1e-12);
}

INSTANTIATE_TEST_SUITE_P(NodalDiameters, AssemblyBeams, testing::Values(2, 3, 7, 12));

TEST(AssemblySpringMasses, LibraryIsAppendixB) {
  System system = spring_masses({60, 87, 200}, 0.2);
  system.preload_n = 500;
  system.loads[1] = at(87, spring_mass(150, 2e6, 3e5));
  for (const double speed : {0.0, 20.0, 110.0}) {
    expect_equal(library(system, speed), appendix_b(system, speed), 1e-13);
  }
}

TEST(AssemblySpringMasses, TipEquationsAreWhatTheEnergiesGive) {
  const Load load = spring_mass(100, 1e6, 2e6);
  const Unconstrained tip = spring_mass_energies(100, 1e6, 2e6, 1.5, 40);
  Eigen::Matrix2d expected;
  expected << 0, -2 * load.gyroscopic_mass_kg * 40, 2 * load.gyroscopic_mass_kg * 40, 0;
  EXPECT_TRUE(tip.rotation.isApprox(expected, 1e-13));
  expected << 1e6 - 100 * 1600, 0, 0, 2e6 - 100 * 1600;
  EXPECT_TRUE(tip.stiffness.isApprox(expected, 1e-13));
  EXPECT_TRUE(tip.force.isApprox(Eigen::Vector2d(load.centrifugal_mass_kg * 1.5 * 1600, 0), 1e-13));
}

TEST(AssemblyReducedLoads, RadialAloneIsEquation1) {
  System system = spring_masses({0}, 0.2);
  system.loads[0].motion = Motion::radial;
  const Equations e = library(system, 30);
  const double n = 2, mu = 0.2, eta = surface_ratio(system.ring), a = amplitude_mass_kg(system.ring);
  const double own = system.ring.modal_stiffness_n_per_m * n * n * 9 - a * n * n * 900, k = 1e6 - 100 * 900.0;
  Equations expected = zero(2);
  expected.mass << a, -mu * eta * 100 * n, 0, a + 100 * n * n;
  expected.damping << 0, -2 * a * n * 30, 2 * a * n * 30, 0;
  expected.stiffness << own, -mu * eta * k * n, 0, own + k * n * n;
  // The forces are those of the paper, but with N_U and R exchanged; see the errata.
  expected.force << mu * eta * 100 * 900, -100 * 900 * n;
  expect_equal(e, expected, 1e-13);
}

TEST(AssemblyReducedLoads, TangentialAloneDoesNotFeelTheRing) {
  System system = spring_masses({25}, 0.2);
  system.loads[0].motion = Motion::tangential;
  const Equations e = library(system, 30);
  EXPECT_EQ(e.mass(2, 0), 0);
  EXPECT_EQ(e.damping(2, 1), 0);
  EXPECT_EQ(e.stiffness(2, 0), 0);
  EXPECT_DOUBLE_EQ(e.damping(2, 2), 2 * 0.2 * 100 * 30);
  EXPECT_DOUBLE_EQ(e.stiffness(2, 2), 1e6 - 100 * 900.0);
}

TEST(AssemblyBeam, PrintedMassesDetermineTheRotaryMass) {
  // Fig. 17b: J_b / m_r and k_t / k_r both equal (I / S) pi^2 / (4 R^2).
  const Load load = beam(185.66, 100, 1.175e7, 1e6);
  EXPECT_NEAR(load.rotary_mass_kg / 185.66, 1e6 / 1.175e7, 1e-4);
  const Load same = beam(BeamGeometry{7800, 0.02, 3e-4, 2.1e11}, 1.3);
  const Load again = beam(same.radial_mass_kg, same.flexural_mass_kg, 1, 1);
  EXPECT_NEAR(again.rotary_mass_kg, 7800 * 3e-4 * std::numbers::pi * std::numbers::pi / (8 * 1.3), 1e-10);
}

TEST(AssemblyStaticLoad, OfAStiffRingIsTheCentrifugalForceAndThePreload) {
  System system = spring_masses({60, 200}, 0.1);
  system.ring.modal_stiffness_n_per_m *= 1e9;
  system.ring.radius_m = 1.5;
  system.preload_n = 700;
  const StaticLoad load = static_load(system, 30);
  ASSERT_EQ(load.normal_n.size(), 2U);
  EXPECT_NEAR(load.normal_n[0], 100 * 1.5 * 900 + 700, 1e-3);
  EXPECT_NEAR(load.slip_m_per_s[1], 30 * 1.5, 1e-6);
  EXPECT_TRUE(load.valid());
}

TEST(AssemblyStaticLoad, BalancesTheRingWithoutFriction) {
  // At the load the ring yields outwards by u = -N n^2 / (a n^2 (Omega_c^2 - Omega^2)), and the load needs
  // the stiffness k_r - m Omega^2 for it.
  System system = spring_masses({0}, 0);
  system.preload_n = 1000;
  const double speed = 10, ring = amplitude_mass_kg(system.ring) * (17.2 * 17.2 - speed * speed);
  const double own = 1e6 - 100 * speed * speed, pressing = 1000 + 100 * speed * speed;
  EXPECT_NEAR(static_load(system, speed).normal_n[0], pressing * ring / (ring + own), 1e-6 * pressing);
}

TEST(AssemblyStaticLoad, ALoadLiftsOffBetweenOmegaCAndOmegaC2) {
  System system = spring_masses({0}, 0.1);
  EXPECT_TRUE(static_load(system, 100 * rpm).valid());
  EXPECT_FALSE(static_load(system, 200 * rpm).valid());
  EXPECT_LT(static_load(system, 200 * rpm).normal_n[0], 0);
  EXPECT_TRUE(static_load(system, 300 * rpm).valid());
}

TEST(AssemblyStaticLoad, NothingSlipsAtRest) { EXPECT_FALSE(static_load(spring_masses({0}), 0).valid()); }

using Complex = std::complex<double>;

/// Largest distance between matched roots, divided by the largest root.
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

TEST(AssemblyEigenvalues, OfThePapersSystemsHave15Digits) {
  for (const std::vector<double>& angles : {std::vector<double>{60}, {60, 87}, {60, 100, 180}}) {
    for (const double speed : {137.0, 300.0, 611.0, 1400.0}) {
      const System system = spring_masses(angles);
      EXPECT_LT(
          distance(eigenvalues(normal_form(system), speed * rpm), roots_with_50_digits(system, speed * rpm)),
          2e-14);
    }
  }
}

TEST(AssemblyEigenvalues, OfRandomSystemsAgreeWith50Digits) {
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

TEST(AssemblyEigenvalues, OfTheBareRingAreItsWaves) {
  for (const int n : {2, 3, 5, 12}) {
    System system{.ring = paper_ring(), .loads = {spring_mass(1, 0, 1)}, .friction_coefficient = 0};
    system.loads[0].motion = Motion::tangential;
    system.ring.nodal_diameters = n;
    const double critical = critical_speed(system.ring);
    for (const double speed : {0.0, 0.4 * critical, critical, 1.7 * critical}) {
      const double own2 = 1 - speed * speed;  // frequency of the load alone: s^2 + 1 - speed^2 = 0
      const Complex load = std::sqrt(Complex(-own2));
      const double forward = n * std::abs(critical - speed), backward = n * (critical + speed);
      // Where the forward wave stands still, it has a double root at zero.
      EXPECT_LT(distance(eigenvalues(normal_form(system), speed),
                         {{0, forward}, {0, -forward}, {0, backward}, {0, -backward}, load, -load}),
                1e-13)
          << n << " " << speed;
    }
  }
}

TEST(AssemblyEigenvalues, OfEqualLoadsThatDoNotKnowEachOtherRepeat) {
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
  // Above the divergence speed three equal real roots grow.
  EXPECT_EQ(signature(normal_form(system), 110.0), (Signature{3, 3, 0}));
}

TEST(AssemblyEigenvalues, OfOppositeLoadsContainTheTangentialCase) {
  const double speed = 45;
  const Eigen::VectorXcd values = eigenvalues(normal_form(spring_masses({60, 240})), speed);
  const Complex expected(-0.1 * speed, std::sqrt(1e4 - 1.01 * speed * speed));
  EXPECT_LT((values.array() - expected).abs().minCoeff(), 1e-12 * size_of(values));
}

TEST(AssemblyEigenvalues, AtRestWithoutFrictionAreNeutralAndFrequenciesOfTheParts) {
  System system = spring_masses({0}, 0);
  const double a = amplitude_mass_kg(system.ring), own = std::sqrt((a * 34.4 * 34.4 + 4e6) / (a + 400));
  EXPECT_LT(distance(eigenvalues(normal_form(system), 0),
                     {{0, 34.4}, {0, -34.4}, {0, own}, {0, -own}, {0, 100}, {0, -100}}),
            1e-14);
}

TEST(AssemblyEigenvalues, WithoutFrictionMirrorAtBothAxes) {
  RandomSystems random(2, 3);
  for (int i = 0; i < 50; ++i) {
    System system = random.next();
    system.friction_coefficient = 0;
    const Eigen::VectorXcd values =
        eigenvalues(normal_form(system), random.between(0, 2) * critical_speed(system.ring));
    EXPECT_LT(distance(values, list(-values)),
              1e-7);  // double roots are accurate to the square root of rounding
  }
}

TEST(AssemblyEigenvalues, DoNotDependOnWhereTheLoadsAreTogether) {
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

TEST(AssemblyEigenvalues, PassThroughAnInclinationOf90Degrees) {
  System system = spring_masses({60}, 0.1);
  system.loads[0] = at(60, beam(185.66, 100, 1.175e7, 1e6));
  const auto values_at = [&](double inclination_deg) {
    system.loads[0].inclination_deg = inclination_deg;
    return eigenvalues(normal_form(system), 40);
  };
  // The dependence on the angle is linear on this scale, without a singularity.
  const Eigen::VectorXcd below = values_at(90 - 1e-5), there = values_at(90);
  EXPECT_LT(distance(below, list(there)), 1e-6);
  system.loads[0].inclination_deg = 90;
  EXPECT_LT(distance(there, roots_with_50_digits(system, 40)), 2e-14);
}

TEST(AssemblySpectrum, SlopesAreTheDerivatives) {
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

TEST(AssemblyNormalForm, RefusesAMovingLoadWithoutMass) {
  System system{.ring = paper_ring(), .loads = {spring_mass(0, 1e6, 1e6)}, .friction_coefficient = 0.1};
  EXPECT_THROW(normal_form(system), ConfigError);
  system.loads[0].motion = Motion::radial;
  EXPECT_NO_THROW(normal_form(system));
}

TEST(AssemblyNormalForm, RefusesFrictionThatCancelsTheInertia) {
  System system{.ring = paper_ring(), .loads = {at(0, beam(300, 140, 1e7, 1e6))}, .friction_coefficient = 0};
  system.loads[0].inclination_deg = 45;
  const auto determinant = [&](double friction) {
    system.friction_coefficient = friction;
    return assemble(system).mass.determinant();
  };
  // det M is linear in the friction coefficient for a load at 0 degrees.
  const double at_zero = determinant(0), slope = determinant(1) - at_zero;
  system.friction_coefficient = -at_zero / slope;
  ASSERT_GT(system.friction_coefficient, 0);
  EXPECT_THROW(normal_form(system), ConfigError);
}

}  // namespace

}  // namespace rubsweep::ring
