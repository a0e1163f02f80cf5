// Dry whip: friction drives the rotor backwards around the annular stop, at a self-excited frequency.
#include <gtest/gtest.h>

#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>

#include "core/response/annular_cell.hpp"
#include "rubsweep/core/response/settle.hpp"

namespace rubsweep::response::testing {
namespace {

using Complex = std::complex<double>;
constexpr Complex i{0, 1};

SettledRun run(const model::Machine& machine, double speed_hz, double whirl_ratio,
               int max_revolutions = 300) {
  const motion::ResponseOptions options{.max_revolutions = max_revolutions};
  motion::Workspace workspace;
  return settle(scene::build_cell(machine, speed_hz, scene::WhirlRatio{whirl_ratio}), {}, options, workspace);
}

/// Parameter set A in an annular stop with a friction coefficient of 0.1.
model::Machine whip_machine() {
  model::Machine machine = annular_machine();
  std::get<model::JeffcottRotor>(machine.rotor).damping_ratio = 0.02;
  machine.stops[0].friction = model::StribeckFriction{{0, 0, 0, 0.1, 100, 0}};
  machine.stops[0].casing->damping_ratio = 0.1;
  machine.kick->force_n = 200;
  return machine;
}

/// Dynamic stiffness k - m w^2 - i c w of a mass in backward whirl e^{-iwt}.
Complex backward_stiffness(double mass_kg, double stiffness, double damping_ratio, double w) {
  return stiffness - mass_kg * w * w - 2.0 * i * damping_ratio * std::sqrt(stiffness * mass_kg) * w;
}

/// Circular backward whirl with the force K p (1 + i mu) d / |d| on the casing. d = z - z_C gives C + p = -K
/// p (1 + i mu) (1 / Z_R + 1 / Z_C), whose imaginary part is an equation for w alone.
struct Whip {
  model::Machine machine = whip_machine();
  double mu = 0.1;

  Complex compliance(double w) const {
    const auto& rotor = std::get<model::JeffcottRotor>(machine.rotor);
    const auto& casing = *machine.stops[0].casing;
    const double w0 = 2 * std::numbers::pi * rotor.natural_frequency_hz;
    return 1.0 / backward_stiffness(rotor.mass_kg, rotor.mass_kg * w0 * w0, rotor.damping_ratio, w) +
           1.0 / backward_stiffness(casing.mass_kg, casing.stiffness_n_per_m, casing.damping_ratio, w);
  }
  double frequency(double low, double high) const {
    const auto defect = [this](double w) { return ((1.0 + i * mu) * compliance(w)).imag(); };
    const auto [a, b] =
        boost::math::tools::bisect(defect, low, high, boost::math::tools::eps_tolerance<double>(48));
    return (a + b) / 2;
  }
  /// Radius |z| of the rotor's circle.
  double radius(double w) const {
    const auto& stop = machine.stops[0];
    const double k = stop.stiffness_n_per_m, gain = -((1.0 + i * mu) * compliance(w)).real();
    const double penetration = stop.clearance_m / (k * gain - 1);
    const double w0 =
        2 * std::numbers::pi * std::get<model::JeffcottRotor>(machine.rotor).natural_frequency_hz;
    return std::abs(k * penetration * (1.0 + i * mu)) /
           std::abs(backward_stiffness(std::get<model::JeffcottRotor>(machine.rotor).mass_kg,
                                       std::get<model::JeffcottRotor>(machine.rotor).mass_kg * w0 * w0,
                                       std::get<model::JeffcottRotor>(machine.rotor).damping_ratio, w));
  }
};

TEST(DryWhip, IsABackwardCircleAtItsClosedFormFrequency) {
  const Whip whip;
  const double speed_hz = 60, w = whip.frequency(2 * std::numbers::pi * 60, 2 * std::numbers::pi * 200);
  const auto settled = run(whip.machine, speed_hz, 0);
  EXPECT_EQ(std::string(to_string(settled.motion.motion_class)), "quasi_periodic");
  EXPECT_FALSE(settled.motion.order);
  EXPECT_EQ(settled.proof, motion::Proof::observed);
  const motion::Measures& m = settled.motion.measures;
  EXPECT_EQ(m.orbit, spectrum::OrbitKind::circle);
  EXPECT_EQ(m.whirl, spectrum::WhirlKind::backward);
  const double order = -w / (2 * std::numbers::pi * speed_hz);
  EXPECT_NEAR(m.dominant.value().order, order, 1e-6);
  EXPECT_NEAR(m.comb_spacing.value(), 1 - order, 1e-6);
  EXPECT_NEAR(m.dominant->amplitude_m, whip.radius(w), 1e-6 * whip.radius(w));
  EXPECT_NEAR(m.contact.contact_fraction, 1, 1e-12);
}

TEST(DryWhip, AtAFractionOfTheShaftSpeedItIsSubharmonicAndStillBackward) {
  const Whip whip;
  const double hz =
      whip.frequency(2 * std::numbers::pi * 60, 2 * std::numbers::pi * 200) / (2 * std::numbers::pi);
  const auto settled = run(whip.machine, hz / 1.5, 0);
  EXPECT_EQ(std::string(to_string(settled.motion.motion_class)), "subharmonic");
  EXPECT_EQ(settled.motion.order, 2);
  EXPECT_EQ(settled.motion.measures.orbit, spectrum::OrbitKind::circle);
  EXPECT_EQ(settled.motion.measures.whirl, spectrum::WhirlKind::backward);
  EXPECT_NEAR(settled.motion.measures.dominant.value().order, -1.5, 1e-12);
  EXPECT_FALSE(settled.motion.measures.comb_spacing);
}

TEST(DryWhip, UnbalanceMakesItAnOvalThatTurnsBackwards) {
  const auto settled = run(whip_machine(), 60, 0.5);
  EXPECT_EQ(std::string(to_string(settled.motion.motion_class)), "quasi_periodic");
  EXPECT_EQ(settled.motion.measures.orbit, spectrum::OrbitKind::oval);
  EXPECT_EQ(settled.motion.measures.whirl, spectrum::WhirlKind::backward);
  EXPECT_NEAR(settled.motion.measures.dominant.value().order,
              1 - settled.motion.measures.comb_spacing.value(), 1e-12);
}

TEST(DryWhip, TheSynchronousCircleOfTheSameMachineTurnsForward) {
  const auto settled = run(whip_machine(), 75, 0.5, 600);
  EXPECT_EQ(std::string(to_string(settled.motion.motion_class)), "synchronous");
  EXPECT_EQ(settled.motion.measures.orbit, spectrum::OrbitKind::circle);
  EXPECT_EQ(settled.motion.measures.whirl, spectrum::WhirlKind::forward);
  EXPECT_FALSE(settled.motion.measures.comb_spacing);
}

TEST(DryWhip, OffTheCentreItTakesAnExponent) {
  model::Machine machine = whip_machine();
  machine.stops[0].geometry = model::AnnularGeometry{{0, 1e-4}};
  const auto settled = run(machine, 60, 0);
  EXPECT_EQ(std::string(to_string(settled.motion.motion_class)), "quasi_periodic");
  EXPECT_FALSE(settled.motion.measures.comb_spacing);
  EXPECT_EQ(settled.motion.measures.whirl, spectrum::WhirlKind::backward);
  EXPECT_NEAR(settled.motion.exponent.value().per_revolution, 0, 1e-3);
}

/// In a rigid annular stop only the slip limits the whip: it decreases until the rotor rolls, and friction
/// takes the required value. There w = zeta / mu + sqrt((zeta / mu)^2 + 1) and r = 1 / (1 - 2 zeta w / (mu
/// b)), in units of the natural frequency and the clearance (b: contact over shaft stiffness). mu is the
/// friction coefficient at the remaining slip.
TEST(DryWhip, RollsInARigidRingWithTheFrictionOfItsSlip) {
  model::Machine machine = whip_machine();
  auto& stop = machine.stops[0];
  const double limit = 0.2, steepness = 1e3, speed_hz = 30,
               zeta = std::get<model::JeffcottRotor>(machine.rotor).damping_ratio;
  stop.casing.reset();
  stop.contact_radius_m = 3e-3;
  stop.friction = model::StribeckFriction{{0, 0, 0, limit, steepness, 0}};
  const auto settled = run(machine, speed_hz, 0);
  EXPECT_EQ(std::string(to_string(settled.motion.motion_class)), "quasi_periodic");
  const motion::Measures& m = settled.motion.measures;
  EXPECT_EQ(m.orbit, spectrum::OrbitKind::circle);
  EXPECT_EQ(m.whirl, spectrum::WhirlKind::backward);
  const double shaft = 2 * std::numbers::pi * speed_hz,
               natural =
                   2 * std::numbers::pi * std::get<model::JeffcottRotor>(machine.rotor).natural_frequency_hz;
  const double b =
      stop.stiffness_n_per_m / (std::get<model::JeffcottRotor>(machine.rotor).mass_kg * natural * natural);
  const double w = -m.dominant.value().order * shaft;
  const double slip = stop.contact_radius_m * shaft - m.dominant->amplitude_m * w;
  EXPECT_GT(slip, 0);
  const double mu = limit * std::tanh(steepness * slip);
  EXPECT_LT(mu, 0.5 * limit);
  const double by_formula = zeta / mu + std::sqrt(zeta * zeta / (mu * mu) + 1);
  EXPECT_NEAR(w / natural, by_formula, 1e-4 * by_formula);
  EXPECT_NEAR(m.dominant->amplitude_m / stop.clearance_m, 1 / (1 - 2 * zeta * by_formula / (mu * b)), 1e-5);
}

/// With dry friction the rotor rolls without slip: w = R Omega / r, where (k_c + k - m w^2) r = k_c c. The
/// samples of a turn do not resolve this whirl, and a turn has thousands of radians of the contact's
/// vibration.
TEST(DryWhip, RollsInAStiffRingWithDryFriction) {
  model::Stop stop;
  stop.geometry = model::AnnularGeometry{};
  stop.clearance_m = 1.5e-4;
  stop.stiffness_n_per_m = 9e7;
  stop.damping = model::NominalRestitution{0.8};
  stop.contact_radius_m = 0.02;
  stop.friction = model::ConstantFriction{0.15};
  model::Machine machine;
  machine.rotor = model::JeffcottRotor{.mass_kg = 3, .natural_frequency_hz = 30, .damping_ratio = 0.004};
  machine.stops = {stop};
  machine.kick = model::Kick{.force_n = 700, .duration_s = 1e-3, .angle_deg = {}};
  const double speed_hz = 0.4;
  motion::Workspace workspace;
  const SettledRun settled =
      settle(scene::build_cell(machine, speed_hz, scene::Eccentricity{3e-6}), {}, {}, workspace);
  EXPECT_EQ(std::string(to_string(settled.motion.motion_class)), "quasi_periodic");
  EXPECT_EQ(settled.proof, motion::Proof::floquet_observed);
  EXPECT_LT(settled.revolutions, 60);
  const motion::Measures& m = settled.motion.measures;
  EXPECT_EQ(m.orbit, spectrum::OrbitKind::circle);
  EXPECT_EQ(m.whirl, spectrum::WhirlKind::backward);
  const double shaft = 2 * std::numbers::pi * speed_hz, k = 3 * std::pow(2 * std::numbers::pi * 30, 2);
  double radius = stop.clearance_m;
  for (int step = 0; step < 20; ++step) {
    const double w = stop.contact_radius_m * shaft / radius;
    radius = stop.stiffness_n_per_m * stop.clearance_m / (stop.stiffness_n_per_m + k - 3 * w * w);
  }
  EXPECT_NEAR(m.dominant.value().order, -stop.contact_radius_m / radius, 1e-6 * 133);
  EXPECT_NEAR(m.dominant->amplitude_m, radius, 1e-7 * radius);
  EXPECT_NEAR(m.comb_spacing.value(), 1 - m.dominant->order, 1e-9);
}

}  // namespace
}  // namespace rubsweep::response::testing
