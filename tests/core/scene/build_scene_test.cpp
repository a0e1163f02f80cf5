#include "rubsweep/core/scene/build_scene.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <random>

#include "core/scene/one_side_machine.hpp"
#include "maps/batch/message_of.hpp"
#include "rubsweep/core/contact/restitution.hpp"
#include "rubsweep/core/error.hpp"
#include "support/one_side_equations.hpp"

namespace rubsweep::scene {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

Complex start_position(const Cell& cell) {
  return {cell.scene.displacement_m(0), cell.scene.displacement_m(1)};
}
Complex start_velocity(const Cell& cell) {
  return {cell.scene.velocity_m_per_s(0), cell.scene.velocity_m_per_s(1)};
}

/// Whirl amplitude of a Jeffcott rotor from the textbook formula.
double whirl_amplitude(const model::JeffcottRotor& rotor, double speed_hz, double eccentricity_m) {
  const double s = speed_hz / rotor.natural_frequency_hz;
  return eccentricity_m * s * s / std::hypot(1 - s * s, 2 * rotor.damping_ratio * s);
}

/// Expects `normal . z` to be larger at the start than at any other instant of the quiet motion.
void expect_smallest_gap_at_start(const Cell& cell) {
  const auto& contact = cell.scene.contacts.front();
  const Eigen::RowVectorXd row =
      contact::first_direction(contact.wall).transpose() * relative_map(cell.scene.structure, contact);
  const double at_start = row.dot(cell.scene.displacement_m);
  for (int i = 0; i < 360; ++i) EXPECT_GE(at_start, row.dot(cell.quiet.displacement(i * pi / 180)) - 1e-17);
}

TEST(BuildSceneCell, KicksLaterByThePhase) {
  model::Machine machine = one_side_machine();
  const Cell plain = build_cell(machine, 75, WhirlRatio{0.4});
  machine.kick->phase_deg = 70;
  const Cell later = build_cell(machine, 75, WhirlRatio{0.4});
  const Eigen::VectorXd wanted = plain.quiet.displacement(70 * pi / 180);
  EXPECT_LT((later.scene.displacement_m - wanted).norm(), 1e-15);
  EXPECT_GT((later.scene.displacement_m - plain.scene.displacement_m).norm(), 1e-4);
  EXPECT_NEAR(later.eccentricity_m, plain.eccentricity_m, 1e-18);
  machine.kick->phase_deg = 0;
  EXPECT_EQ(build_cell(machine, 75, WhirlRatio{0.4}).scene.displacement_m, plain.scene.displacement_m);
}

TEST(BuildSceneCell, IsTheSceneOfTheEquationsWrittenByHand) {
  const test::OneSideRotor rotor;
  const test::OneSideEquations<double> by_hand(rotor);
  const Cell cell = build_cell(one_side_machine(), rotor.speed_hz, WhirlRatio{rotor.whirl_ratio});
  const Scene& scene = cell.scene;
  EXPECT_EQ(cell.start, Start::quiet);
  ASSERT_EQ(scene.structure.coordinates(), 4);
  ASSERT_EQ(scene.contacts.size(), 1u);
  EXPECT_DOUBLE_EQ(scene.speed_rad_per_s, by_hand.omega);
  EXPECT_DOUBLE_EQ(scene.structure.stiffness(1, 1), by_hand.k);
  EXPECT_DOUBLE_EQ(scene.structure.damping(2, 2), by_hand.cc);
  EXPECT_DOUBLE_EQ(scene.contacts[0].stiffness_n_per_m, by_hand.contact_k);
  EXPECT_DOUBLE_EQ(scene.contacts[0].damping_ns_per_m, by_hand.d);
  EXPECT_DOUBLE_EQ(scene.contacts[0].surface_speed_m_per_s, by_hand.surface_speed);
  EXPECT_EQ(scene.contacts[0].clearance_m, by_hand.clearance);
  EXPECT_EQ(scene.length_scale_m, by_hand.clearance);
  for (const double phase : {0.0, 0.4, 2.2, 5.0}) {
    // Force from the hand-written equations, after the kick: accelerations of a rotor at rest at the origin,
    // times the mass.
    test::OneSideState<double> rate;
    by_hand({}, rate, (phase + 20 * pi) / by_hand.omega);
    const Eigen::VectorXd force = (scene.harmonic_n * std::polar(1.0, phase)).real();
    EXPECT_NEAR(force(0), by_hand.m * rate[4], 1e-10 * std::abs(by_hand.force_x_sin));
    EXPECT_NEAR(force(1), by_hand.m * rate[5], 1e-10 * std::abs(by_hand.force_x_sin));
    EXPECT_EQ(force(2), 0);
    EXPECT_EQ(force(3), 0);
  }
  const auto start = by_hand.start();
  for (Eigen::Index i = 0; i < 4; ++i) {
    EXPECT_NEAR(scene.displacement_m(i), start[static_cast<std::size_t>(i)], 1e-15 * by_hand.clearance);
    EXPECT_NEAR(scene.velocity_m_per_s(i), start[static_cast<std::size_t>(i) + 4],
                1e-15 * by_hand.clearance * by_hand.omega);
  }
}

TEST(BuildSceneCell, QuietWhirlIsTheClosedFormAndStartsAtTheStopWhateverItsAngle) {
  std::mt19937_64 random(1);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  for (int trial = 0; trial < 500; ++trial) {
    model::Machine machine = one_side_machine();
    machine.rotor = model::JeffcottRotor{uniform(0.1, 10), uniform(5, 200), uniform(0.005, 1.5)};
    const double angle_deg = trial % 9 == 0 ? 90 : uniform(-720, 720);
    machine.stops[0].geometry = model::OneSideGeometry{angle_deg};
    if (trial % 2 == 0) machine.stops[0].casing.reset();
    const double speed_hz = uniform(1, 500), e = uniform(1e-9, 1e-7);
    const Cell cell = build_cell(machine, speed_hz, Eccentricity{e});
    const double a = whirl_amplitude(std::get<model::JeffcottRotor>(machine.rotor), speed_hz, e),
                 w = 2 * pi * speed_hz;
    const Complex position = std::polar(a, angle_deg * pi / 180);
    EXPECT_LE(std::abs(start_position(cell) - position), 1e-12 * a);
    EXPECT_LE(std::abs(start_velocity(cell) - Complex(0, w) * position), 1e-12 * a * w);
    EXPECT_NEAR(cell.whirl_ratio, a / 1e-3, 1e-12 * a / 1e-3);
    expect_smallest_gap_at_start(cell);
  }
}

TEST(BuildSceneCell, StartsOnTheImaginaryAxisForAStopAbove) {
  const Cell cell = build_cell(one_side_machine(), 75, WhirlRatio{0.4});
  const double a = 0.4e-3, w = 2 * pi * 75;
  EXPECT_LE(std::abs(start_position(cell) - Complex(0, a)), 1e-14 * a);
  EXPECT_LE(std::abs(start_velocity(cell) - Complex(-a * w, 0)), 1e-14 * a * w);
}

TEST(BuildSceneCell, WhirlRatioAndEccentricitySayTheSame) {
  std::mt19937_64 random(2);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  for (int trial = 0; trial < 200; ++trial) {
    model::Machine machine = one_side_machine();
    std::get<model::JeffcottRotor>(machine.rotor).damping_ratio = uniform(0.01, 1);
    machine.gravity_m_per_s2 = trial % 2 == 0 ? 0 : 9.81;
    const double speed_hz = uniform(1, 300), ratio = uniform(0, 0.99);
    const Cell by_ratio = build_cell(machine, speed_hz, WhirlRatio{ratio});
    EXPECT_EQ(by_ratio.whirl_ratio, ratio);
    const Cell by_eccentricity = build_cell(machine, speed_hz, Eccentricity{by_ratio.eccentricity_m});
    EXPECT_EQ(by_eccentricity.eccentricity_m, by_ratio.eccentricity_m);
    EXPECT_NEAR(by_eccentricity.whirl_ratio, ratio, 1e-15);
    EXPECT_LE((by_eccentricity.scene.harmonic_n - by_ratio.scene.harmonic_n).norm(),
              1e-14 * by_ratio.scene.harmonic_n.norm());
  }
}

TEST(BuildSceneCell, GravityShiftsTheMeanAndTheRemainingClearance) {
  model::Machine machine = one_side_machine();
  machine.gravity_m_per_s2 = 9.81;
  const double w0 = 2 * pi * 30;
  const double rotor_sag = 9.81 / (w0 * w0), casing_sag = 0.05 * 9.81 / 5e5;
  const Cell cell = build_cell(machine, 75, WhirlRatio{0.5});
  const double remaining = 1e-3 + rotor_sag - casing_sag;
  EXPECT_NEAR(cell.quiet.mean(1), -rotor_sag, 1e-18);
  EXPECT_NEAR(cell.quiet.mean(3), -casing_sag, 1e-18);
  EXPECT_NEAR(cell.eccentricity_m,
              0.5 * remaining / whirl_amplitude(std::get<model::JeffcottRotor>(machine.rotor), 75, 1), 1e-17);
  EXPECT_NEAR(cell.scene.displacement_m(1), 0.5 * remaining - rotor_sag, 1e-17);
  EXPECT_NEAR(cell.scene.displacement_m(0), 0, 1e-17);

  machine.stops[0].geometry = model::OneSideGeometry{-90};
  const Cell below = build_cell(machine, 75, WhirlRatio{0.5});
  const double remaining_below = 1e-3 - rotor_sag + casing_sag;
  EXPECT_NEAR(below.scene.displacement_m(1), -rotor_sag - 0.5 * remaining_below, 1e-17);

  machine.stops[0].geometry = model::OneSideGeometry{0};
  EXPECT_NEAR(build_cell(machine, 75, WhirlRatio{0.5}).scene.displacement_m(0), 0.5e-3, 1e-17);
}

TEST(BuildSceneCell, SagThroughTheStopHasNoWhirlRatioButStartsAtTheWall) {
  model::Machine machine = one_side_machine();
  machine.stops[0].geometry = model::OneSideGeometry{-90};
  machine.stops[0].clearance_m = 1e-4;
  machine.gravity_m_per_s2 = 9.81;
  const Cell by_ratio = build_cell(machine, 75, WhirlRatio{0.5});
  EXPECT_EQ(by_ratio.start, Start::initial_contact);
  EXPECT_TRUE(std::isnan(by_ratio.eccentricity_m));
  const Cell by_eccentricity = build_cell(machine, 75, Eccentricity{1e-5});
  EXPECT_EQ(by_eccentricity.start, Start::contact);
  EXPECT_TRUE(std::isnan(by_eccentricity.whirl_ratio));
  EXPECT_EQ(by_eccentricity.eccentricity_m, 1e-5);
  // Rotor and casing have sunk as far as possible before they touch.
  const auto& scene = by_eccentricity.scene;
  const Eigen::Vector2d apart = relative_map(scene.structure, scene.contacts[0]) * scene.displacement_m;
  EXPECT_NEAR(apart.y(), -1e-4, 1e-18);
  EXPECT_LT(scene.displacement_m(1), 0);
  EXPECT_GT(scene.displacement_m(1), by_eccentricity.quiet.mean(1));
}

TEST(BuildSceneCell, WhereTheQuietWhirlTouchesItStartsAtRestAndIsNotKicked) {
  model::Machine machine = one_side_machine();
  machine.gravity_m_per_s2 = 9.81;
  const Cell below = build_cell(machine, 75, WhirlRatio{0.9});
  const Cell above = build_cell(machine, 75, WhirlRatio{1.2});
  EXPECT_EQ(below.scene.pulses.size(), 1u);
  EXPECT_TRUE(above.scene.pulses.empty());
  EXPECT_EQ(above.start, Start::contact);
  EXPECT_TRUE(can_run(above.start));
  // At rest in the static position; the unbalance has the same phase as in other cells.
  EXPECT_EQ(above.scene.displacement_m, above.quiet.mean);
  EXPECT_TRUE(above.scene.velocity_m_per_s.isZero(0));
  EXPECT_TRUE((above.scene.harmonic_n / 1.2).isApprox(below.scene.harmonic_n / 0.9, 1e-14));
}

TEST(BuildSceneCell, ARingHoldsASaggingRotorAtItsWall) {
  model::Machine machine = one_side_machine();
  machine.gravity_m_per_s2 = 400;  // sags by 11 mm
  machine.stops[0].casing.reset();
  for (const std::array<double, 2> offset_m :
       {std::array{0.0, 0.0}, {3e-4, 0.0}, {2e-4, -5e-4}, {0.0, 6e-4}}) {
    machine.stops[0].geometry = model::AnnularGeometry{offset_m};
    const Cell cell = build_cell(machine, 75, Eccentricity{1e-4});
    EXPECT_EQ(cell.start, Start::contact);
    const Contact& stop = cell.scene.contacts[0];
    const Eigen::Vector2d apart =
        relative_map(cell.scene.structure, stop) * cell.scene.displacement_m + contact::offset(stop.wall);
    EXPECT_NEAR(apart.norm(), 1e-3, 1e-17);
    EXPECT_LT(cell.scene.displacement_m(1), 0);
  }
}

TEST(BuildSceneCell, ContactWithoutAKickFromAWhirlRatioOfOne) {
  std::mt19937_64 random(3);
  for (int trial = 0; trial < 200; ++trial) {
    const double speed_hz = std::uniform_real_distribution(5.0, 300.0)(random);
    EXPECT_EQ(build_cell(one_side_machine(), speed_hz, WhirlRatio{1}).start, Start::contact) << speed_hz;
    EXPECT_EQ(build_cell(one_side_machine(), speed_hz, WhirlRatio{1.5}).start, Start::contact);
    EXPECT_EQ(build_cell(one_side_machine(), speed_hz, WhirlRatio{1 - 1e-14}).start, Start::quiet)
        << speed_hz;
  }
}

TEST(BuildSceneCell, ContactAtAnyStop) {
  model::Machine machine = both_sides_machine();
  machine.stops[1].clearance_m = 0.5e-3;
  EXPECT_EQ(build_cell(machine, 75, WhirlRatio{0.49}).start, Start::quiet);
  EXPECT_EQ(build_cell(machine, 75, WhirlRatio{0.51}).start, Start::contact);
}

TEST(BuildSceneCell, UnreachableAtAnUndampedResonance) {
  std::mt19937_64 random(4);
  model::Machine machine = one_side_machine();
  std::get<model::JeffcottRotor>(machine.rotor).damping_ratio = 0;
  for (int trial = 0; trial < 200; ++trial) {
    // The result must not depend on the rounding of K and w^2 M.
    std::get<model::JeffcottRotor>(machine.rotor).mass_kg = std::uniform_real_distribution(0.1, 5.0)(random);
    std::get<model::JeffcottRotor>(machine.rotor).natural_frequency_hz =
        std::uniform_real_distribution(5.0, 100.0)(random);
    const double speed_hz = std::get<model::JeffcottRotor>(machine.rotor).natural_frequency_hz;
    const Cell by_ratio = build_cell(machine, speed_hz, WhirlRatio{0.5});
    EXPECT_EQ(by_ratio.start, Start::unreachable);
    EXPECT_TRUE(std::isnan(by_ratio.eccentricity_m));
    const Cell by_eccentricity = build_cell(machine, speed_hz, Eccentricity{1e-4});
    EXPECT_EQ(by_eccentricity.start, Start::unreachable);
    EXPECT_TRUE(std::isnan(by_eccentricity.whirl_ratio));
    EXPECT_EQ(build_cell(machine, speed_hz * 1.001, WhirlRatio{0.5}).start, Start::quiet);
  }
}

TEST(BuildSceneCell, WhatOverflowsIsNoNumberThatSaysTheUnbalanceTheOtherWay) {
  model::Machine machine = one_side_machine();
  machine.stops[0].clearance_m = 1e-30;
  EXPECT_TRUE(std::isnan(build_cell(machine, 75, Eccentricity{1e290}).whirl_ratio));
  EXPECT_TRUE(std::isnan(build_cell(one_side_machine(), 1e-200, WhirlRatio{0.4}).eccentricity_m));
}

TEST(BuildSceneCell, WithoutUnbalanceTheRotorRests) {
  for (const Unbalance& none : {Unbalance{WhirlRatio{0}}, Unbalance{Eccentricity{0}}}) {
    const Cell cell = build_cell(one_side_machine(), 75, none);
    EXPECT_EQ(cell.start, Start::quiet);
    EXPECT_EQ(cell.eccentricity_m, 0);
    EXPECT_EQ(cell.whirl_ratio, 0);
    EXPECT_TRUE(cell.scene.harmonic_n.isZero(0));
    EXPECT_TRUE(cell.scene.displacement_m.isZero(0));
    EXPECT_TRUE(cell.scene.velocity_m_per_s.isZero(0));
  }
}

TEST(BuildSceneCell, KickPointsAtTheFirstStopUnlessItHasAnAngle) {
  model::Machine machine = both_sides_machine();
  machine.stops[0].geometry = model::OneSideGeometry{30};
  const auto direction = [&] {
    return build_cell(machine, 75, WhirlRatio{0.1}).scene.pulses.at(0).direction;
  };
  Eigen::VectorXd expected = Eigen::VectorXd::Zero(6);
  expected.head(2) << std::sqrt(0.75), 0.5;
  EXPECT_LE((direction() - expected).norm(), 1e-15);
  machine.kick->angle_deg = 180;
  expected.head(2) << -1, 0;
  EXPECT_EQ(direction(), expected);
  const Pulse pulse = build_cell(machine, 75, WhirlRatio{0.1}).scene.pulses.at(0);
  EXPECT_EQ(pulse.force_n, 200);
  EXPECT_EQ(pulse.duration_s, 0.005);
  machine.kick.reset();
  EXPECT_TRUE(build_cell(machine, 75, WhirlRatio{0.1}).scene.pulses.empty());
}

TEST(BuildSceneCell, InARingKickAndPhaseGoAlongOffsetPlusSag) {
  model::Machine machine = one_side_machine();
  machine.stops[0].geometry = model::AnnularGeometry{{3e-4, 1e-4}};
  machine.stops[0].casing.reset();
  machine.gravity_m_per_s2 = 9.81;
  const Cell cell = build_cell(machine, 75, WhirlRatio{0.2});
  const auto relative = relative_map(cell.scene.structure, cell.scene.contacts[0]);
  const double w = 2 * std::numbers::pi * 30, sag_m = 9.81 / (w * w);
  const Eigen::Vector2d along = Eigen::Vector2d(3e-4, 1e-4 - sag_m).normalized();
  EXPECT_LE((cell.scene.pulses.at(0).direction.head(2) - along).norm(), 1e-12);
  // At t = 0 the quiet whirl is farthest out in this direction.
  const auto excursion = [&](double phase) { return along.dot(relative * cell.quiet.displacement(phase)); };
  for (double phase = 0.05; phase < 6.25; phase += 0.05) EXPECT_LT(excursion(phase), excursion(0));
  EXPECT_NEAR(along.dot(relative * cell.quiet.velocity(0)), 0, 1e-16);
}

TEST(BuildSceneCell, EveryStopHasItsContactAndTheMovingOnesTheirCasing) {
  model::Machine machine = both_sides_machine();
  machine.stops[1].casing.reset();
  machine.stops.push_back(machine.stops[0]);
  machine.stops[2].geometry = model::OneSideGeometry{0};
  machine.stops[2].clearance_m = 2e-3;
  machine.stops[2].friction = model::ConstantFriction{0.3};
  const Scene scene = build_cell(machine, 75, WhirlRatio{0.4}).scene;
  EXPECT_EQ(scene.structure.coordinates(), 6);
  ASSERT_EQ(scene.contacts.size(), 3u);
  EXPECT_FALSE(scene.contacts[1].casing_point);
  // The third stop depends on coordinates 4 and 5, those of the second moving casing.
  const Eigen::VectorXd q = Eigen::VectorXd::LinSpaced(6, 1, 6);
  EXPECT_EQ(relative_map(scene.structure, scene.contacts[0]) * q, Eigen::Vector2d(1 - 3, 2 - 4));
  EXPECT_EQ(relative_map(scene.structure, scene.contacts[1]) * q, Eigen::Vector2d(1, 2));
  EXPECT_EQ(relative_map(scene.structure, scene.contacts[2]) * q, Eigen::Vector2d(1 - 5, 2 - 6));
  EXPECT_EQ(scene.contacts[2].clearance_m, 2e-3);
  EXPECT_EQ(std::get<model::ConstantFriction>(scene.contacts[2].friction).coefficient, 0.3);
  EXPECT_EQ(scene.length_scale_m, 1e-3);
}

TEST(BuildSceneCell, DampingTakesTheReducedMassOfRotorAndCasing) {
  model::Machine machine = one_side_machine();
  const auto damping = [&] {
    return build_cell(machine, 75, WhirlRatio{0.4}).scene.contacts[0].damping_ns_per_m;
  };
  // Damping constant d = sqrt(4 ln^2 e m K / (pi^2 + ln^2 e)).
  const double log_e = std::log(0.7);
  const auto nominal = [&](double mass) {
    return std::sqrt(4 * log_e * log_e * mass * 2e6 / (pi * pi + log_e * log_e));
  };
  EXPECT_NEAR(damping(), nominal(1 / (1 / 0.8 + 1 / 0.05)), 1e-11);
  machine.stops[0].contact_mass_kg = 0.3;
  EXPECT_NEAR(damping(), nominal(1 / (1 / 0.3 + 1 / 0.05)), 1e-11);
  machine.stops[0].casing.reset();
  EXPECT_NEAR(damping(), nominal(0.3), 1e-11);
  machine.stops[0].contact_mass_kg.reset();
  EXPECT_NEAR(damping(), nominal(0.8), 1e-11);
  machine.stops[0].damping = model::DeliveredRestitution{0.7};
  EXPECT_NEAR(contact::delivered_restitution(damping() / (2 * std::sqrt(0.8 * 2e6))), 0.7, 1e-14);
  machine.stops[0].damping = model::ExplicitDamping{12.5};
  EXPECT_EQ(damping(), 12.5);
}

TEST(BuildSceneCell, DampingWithTheMassOfTheRotorDeliversLessAgainstALightCasing) {
  model::Machine machine = one_side_machine();
  // With a casing of mass m_c the reduced mass is m', and the same d is sqrt(m / m') times closer to
  // critical. Values by hand from the closed form.
  struct Case {
    double nominal, casing_kg, delivered;
  };
  for (const Case& one :
       {Case{0.5, 2, 0.56}, Case{0.7, 0.1, 0.49}, Case{0.7, 0.03, 0.37}, Case{0.8, 0.012, 0.37}}) {
    machine.stops[0].damping = model::RestitutionByRotorMass{one.nominal};
    machine.stops[0].casing->mass_kg = one.casing_kg;
    const double damping = build_cell(machine, 75, WhirlRatio{0.4}).scene.contacts[0].damping_ns_per_m;
    const double zeta = -std::log(one.nominal) / std::hypot(pi, std::log(one.nominal));
    EXPECT_NEAR(damping, 2 * zeta * std::sqrt(0.8 * 2e6), 1e-10);
    const double reduced = 0.8 * one.casing_kg / (0.8 + one.casing_kg);
    EXPECT_NEAR(contact::delivered_restitution(damping / (2 * std::sqrt(reduced * 2e6))), one.delivered,
                0.005);
  }
  // A given contact mass replaces the rotor's mass, and with a rigid casing nothing is reduced.
  machine.stops[0].contact_mass_kg = 0.3;
  machine.stops[0].damping = model::RestitutionByRotorMass{0.7};
  const auto damping = [&] {
    return build_cell(machine, 75, WhirlRatio{0.4}).scene.contacts[0].damping_ns_per_m;
  };
  const double with_casing = damping();
  machine.stops[0].casing.reset();
  EXPECT_EQ(damping(), with_casing);
  machine.stops[0].damping = model::NominalRestitution{0.7};
  EXPECT_EQ(damping(), with_casing);
}

TEST(BuildSceneCell, QuarterTurnsAreExact) {
  const Eigen::Vector2d quarters[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  model::Machine machine = one_side_machine();
  for (int quarter = -9; quarter <= 9; ++quarter) {
    machine.stops[0].geometry = model::OneSideGeometry{90.0 * quarter};
    const Scene scene = build_cell(machine, 75, WhirlRatio{0.4}).scene;
    EXPECT_EQ(contact::first_direction(scene.contacts[0].wall), quarters[(quarter + 12) % 4]) << quarter;
    EXPECT_EQ(Eigen::Vector2d(scene.pulses.at(0).direction.head(2)), quarters[(quarter + 12) % 4]) << quarter;
  }
  // A wall above does not depend on x, and the structure does not couple x to y.
  machine.stops[0].geometry = model::OneSideGeometry{90};
  const Scene scene = build_cell(machine, 75, WhirlRatio{0.4}).scene;
  const Eigen::RowVectorXd row = contact::first_direction(scene.contacts[0].wall).transpose() *
                                 relative_map(scene.structure, scene.contacts[0]);
  EXPECT_EQ(row, Eigen::RowVectorXd(Eigen::RowVector4d(0, 1, 0, -1)));
}

TEST(BuildSceneCell, OtherAnglesAreUnitVectors) {
  model::Machine machine = one_side_machine();
  for (const double angle_deg : {-123.0, 1e-9, 45.0, 89.999999, 1e6 + 1}) {
    machine.stops[0].geometry = model::OneSideGeometry{angle_deg};
    const Eigen::Vector2d normal =
        contact::first_direction(build_cell(machine, 75, WhirlRatio{0.4}).scene.contacts[0].wall);
    EXPECT_NEAR(normal.norm(), 1, 1e-15);
    EXPECT_NEAR(std::remainder(std::atan2(normal.y(), normal.x()) * 180 / pi - angle_deg, 360), 0, 1e-9);
  }
}

TEST(BuildSceneCell, RefusesAMachineThatIsNotValid) {
  model::Machine machine = one_side_machine();
  machine.stops[0].clearance_m = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message_of<ConfigError>([&] { build_cell(machine, 75, WhirlRatio{0.4}); }),
            "stops.0.clearance_m: missing, allowed: a number > 0");
}

}  // namespace
}  // namespace rubsweep::scene
