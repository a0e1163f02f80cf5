#include "rubsweep/core/integrate/adaptive/twist_dynamics.hpp"

#include <gtest/gtest.h>

#include <array>
#include <boost/math/tools/roots.hpp>
#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <complex>
#include <numbers>

#include "rubsweep/core/integrate/adaptive/start_adaptive.hpp"
#include "rubsweep/core/integrate/adaptive/stepper_table.hpp"
#include "rubsweep/core/integrate/run/state_scale.hpp"

namespace rubsweep::integrate::adaptive {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

/// A disc on a massless shaft with a torsional spring to its drive; coordinates x, y, twist angle.
struct Disc {
  double m = 0.8, k = 0.8 * std::pow(2 * pi * 30, 2), c = 6, J = 2e-5, drive_k = 4, drive_c = 1e-3;
  double e = 8e-4, speed_hz = 50, g = 0;
  double w() const { return 2 * pi * speed_hz; }
};

scene::Scene scene_of(const Disc& disc) {
  scene::Scene scene;
  const Eigen::Vector3cd turning(1, Complex(0, -1), 0);
  scene.structure.mass = Eigen::Vector3d(disc.m, disc.m, disc.J).asDiagonal();
  scene.structure.damping = Eigen::Vector3d(disc.c, disc.c, disc.drive_c).asDiagonal();
  scene.structure.stiffness = Eigen::Vector3d(disc.k, disc.k, disc.drive_k).asDiagonal();
  scene.structure.unbalance_kg = disc.m * turning;
  scene.structure.weight_kg = Eigen::Vector3d(0, -disc.m, 0);
  scene.structure.points = {{Eigen::Matrix<double, 2, 3>::Identity()}};
  scene.speed_rad_per_s = disc.w();
  scene.harmonic_n = disc.e * disc.w() * disc.w() * disc.m * turning;
  scene.constant_n = disc.g * scene.structure.weight_kg;
  scene.displacement_m = scene.velocity_m_per_s = Eigen::Vector3d::Zero();
  scene.length_scale_m = 1e-3;
  scene::Twist& twist = scene.twist.emplace();
  twist.coordinate = 2;
  twist.unbalance_kg_m = disc.m * disc.e * turning;
  twist.unbalance_inertia_kg_m2 = disc.m * disc.e * disc.e;
  return scene;
}

void add_stop(scene::Scene& scene, const contact::Wall& wall, double stiffness, double damping,
              const model::Friction& friction, double radius_m) {
  scene::Contact contact;
  contact.wall = wall;
  contact.clearance_m = 1e-3;
  contact.stiffness_n_per_m = stiffness;
  contact.damping_ns_per_m = damping;
  contact.friction = friction;
  contact.surface_speed_m_per_s = radius_m * scene.speed_rad_per_s;
  scene.contacts.push_back(contact);
  scene.twist->contact_radius_m.push_back(radius_m);
}

/// Displacements and velocities in SI units after some turns.
struct End {
  Eigen::VectorXd q, rate;
};

End after(const scene::Scene& scene, int turns, run::Stepper stepper = run::Stepper::automatic,
          double tolerance = 1e-12) {
  const run::Cursor cursor = start_adaptive(scene, {.stepper = stepper, .relative_tolerance = tolerance});
  run::TurnReport turn;
  for (int i = 0; i < turns; ++i) EXPECT_EQ(cursor({}, turn), run::Outcome::ok);
  const run::StateScale scale = run::state_scale(scene);
  return {scale.displacement_m(turn.section), scale.velocity_m_per_s(turn.section)};
}

TEST(TwistDynamics, VibratesFreelyAgainstTheDrive) {
  Disc disc;
  disc.e = 0;
  scene::Scene scene = scene_of(disc);
  scene.displacement_m(2) = 0.01;
  const double decay = disc.drive_c / (2 * disc.J), w0 = std::sqrt(disc.drive_k / disc.J);
  const double wd = std::sqrt(w0 * w0 - decay * decay), t = 3 / disc.speed_hz;
  const double expected = 0.01 * std::exp(-decay * t) * (std::cos(wd * t) + decay / wd * std::sin(wd * t));
  EXPECT_NEAR(after(scene, 3).q(2), expected, 1e-10);
}

/// The same disc in coordinates of its mass centre G = z + e e^{i phi}, which decouple the accelerations: m
/// G'' = F - i m g, J phi'' = -k angle - c angle' + (z - G) x F, with the shaft force F = -k z - c z'.
std::array<double, 6> by_mass_centre(const Disc& disc, double end_s) {
  using State = std::array<double, 6>;  // G_x, G_y, phi - w t, and rates
  const auto rate = [&](const State& s, State& ds, double t) {
    const double phi_rate = disc.w() + s[5];
    const Complex arm = std::polar(disc.e, disc.w() * t + s[2]), i(0, 1);
    const Complex z = Complex(s[0], s[1]) - arm, v = Complex(s[3], s[4]) - i * phi_rate * arm;
    const Complex force = -disc.k * z - disc.c * v;
    const double torque = (std::conj(-arm) * force).imag();
    ds = {s[3],
          s[4],
          s[5],
          force.real() / disc.m,
          force.imag() / disc.m - disc.g,
          (-disc.drive_k * s[2] - disc.drive_c * s[5] + torque) / disc.J};
  };
  State state{disc.e, 0, 0, 0, disc.e * disc.w(), 0};
  namespace odeint = boost::numeric::odeint;
  odeint::integrate_adaptive(odeint::make_controlled<odeint::runge_kutta_fehlberg78<State>>(1e-14, 1e-13),
                             rate, state, 0.0, end_s, 1e-6);
  return state;
}

TEST(TwistDynamics, OfAnUnbalancedDiscIsThatByItsMassCentre) {
  for (const double g : {0.0, 9.81}) {
    Disc disc;
    disc.g = g;
    const auto expected = by_mass_centre(disc, 6 / disc.speed_hz);
    const End end = after(scene_of(disc), 6);
    const double phi = end.q(2);  // six whole turns are left out, so only the twist angle remains
    EXPECT_GT(std::abs(expected[2]), 2e-4) << "a twist that matters";
    EXPECT_NEAR(end.q(2), expected[2], 1e-9);
    EXPECT_NEAR(end.q(0) + disc.e * std::cos(phi), expected[0], 1e-12);
    EXPECT_NEAR(end.q(1) + disc.e * std::sin(phi), expected[1], 1e-12);
    EXPECT_NEAR(end.rate(2), expected[5], 1e-6);
  }
}

TEST(TwistDynamics, IsTheSameByEveryStepper) {
  Disc disc;
  disc.J = 2e-4;
  const double expected = by_mass_centre(disc, 2 / disc.speed_hz)[2];
  for (const run::Stepper stepper : single_steppers())
    EXPECT_NEAR(after(scene_of(disc), 2, stepper, 1e-9).q(2), expected, 1e-7) << row_of(stepper).word;
}

/// Circular whirl in an annular stop: |(k - m w^2) r + F + i (c w r + mu F)| = m e w^2 with F = K (r - C).
/// The drive balances damping and friction with the torque c w r^2 + mu F (R + r), which twists the shaft.
TEST(TwistDynamics, FullAnnularRubTwistsTheRotorBackByItsTorque) {
  Disc disc;
  disc.speed_hz = 25;
  disc.e = 1.2e-3;
  disc.c = 20;
  disc.J = 1e-3;
  disc.drive_k = 3;
  disc.drive_c = 0.05;
  constexpr double stiffness = 2e5, mu = 0.05, radius = 0.02, clearance = 1e-3;
  const double w = disc.w();
  const auto excess = [&](double r) {
    const double force = stiffness * (r - clearance);
    return std::abs(Complex((disc.k - disc.m * w * w) * r + force, disc.c * w * r + mu * force)) -
           disc.m * disc.e * w * w;
  };
  const auto [low, high] =
      boost::math::tools::bisect(excess, clearance, 3e-3, [](double a, double b) { return b - a < 1e-16; });
  const double r = (low + high) / 2, force = stiffness * (r - clearance);
  const double torque = disc.c * w * r * r + mu * force * (radius + r);
  ASSERT_GT(force, 1);

  scene::Scene scene = scene_of(disc);
  add_stop(scene, contact::AnnularWall{}, stiffness, 50, model::ConstantFriction{mu}, radius);
  const run::Cursor cursor = start_adaptive(scene, {.relative_tolerance = 1e-10});
  run::TurnReport turn;
  for (int i = 0; i < 400; ++i) ASSERT_EQ(cursor({.peaks = true}, turn), run::Outcome::ok);
  EXPECT_NEAR(turn.peak_displacement_m, r, 1e-6 * r);
  EXPECT_NEAR(turn.peak_contact_force_n, force, 1e-5 * force);
  EXPECT_NEAR(turn.peak_torque_nm, torque, 1e-5 * torque);
  EXPECT_NEAR(turn.peak_twist_rad, torque / disc.drive_k, 1e-5 * torque / disc.drive_k);
  EXPECT_LT(turn.section[2], 0) << "behind its drive";
}

/// Energy of mass centre, rotation and the springs of shaft, drive and contact. Over turns with impacts it
/// must equal the work of the drive at constant speed minus the losses in dampers and friction.
TEST(TwistDynamics, EnergyBalances) {
  Disc disc;
  disc.J = 1e-4;
  disc.e = 3e-4;
  disc.drive_k = 8;
  constexpr double stiffness = 1e5, radius = 0.03;
  scene::Scene scene = scene_of(disc);
  const model::Friction friction = model::StribeckFriction{{0, 0, 0, 0.2, 2, 0.01}};
  add_stop(scene, contact::FlatWall{{0, 1}}, stiffness, 0, friction, radius);
  scene.displacement_m(1) = 9e-4;
  scene.velocity_m_per_s = Eigen::Vector3d(0.1, 0.4, 0);
  const double w = disc.w();
  const Complex i(0, 1);
  const auto energy_and_powers = [&](const Eigen::VectorXd& q, const Eigen::VectorXd& rate, double phase) {
    const Complex centre_rate =
        Complex(rate(0), rate(1)) + i * (w + rate(2)) * std::polar(disc.e, phase + q(2));
    const double p = std::max(0.0, q(1) - 1e-3);
    const double energy = disc.m * std::norm(centre_rate) / 2 + disc.J * std::pow(w + rate(2), 2) / 2 +
                          disc.k * q.head(2).squaredNorm() / 2 + disc.drive_k * q(2) * q(2) / 2 +
                          stiffness * p * p / 2;
    const double slip = -rate(0) + radius * (w + rate(2));
    const double friction_w = contact::friction_coefficient(friction, slip) * stiffness * p * slip;
    const double power = -(disc.drive_k * q(2) + disc.drive_c * rate(2)) * w -
                         disc.c * rate.head(2).squaredNorm() - disc.drive_c * rate(2) * rate(2) - friction_w;
    return std::array<double, 3>{energy, power, friction_w};
  };
  constexpr int samples = 4096, turns = 6;
  const run::Cursor cursor = start_adaptive(scene, {.relative_tolerance = 1e-12});
  const run::StateScale scale = run::state_scale(scene);
  run::TurnReport turn;
  double work = 0, throughput = 0, rubbed = 0, first = 0, last = 0, before = 0;
  int hits = 0;
  for (int k = 0; k < turns; ++k) {
    ASSERT_EQ(cursor({.samples_per_revolution = samples}, turn), run::Outcome::ok);
    hits += turn.hits;
    for (int s = 0; s < samples; ++s) {
      const auto state = std::span(turn.samples).subspan(static_cast<std::size_t>(6 * s), 6);
      const auto [energy, power, friction_w] =
          energy_and_powers(scale.displacement_m(state), scale.velocity_m_per_s(state), 2 * pi * s / samples);
      const double dt = 1 / (disc.speed_hz * samples);
      if (k == 0 && s == 0) {
        first = energy;
      } else {
        work += (power + before) / 2 * dt;
        throughput += std::abs(power) * dt;
      }
      rubbed += friction_w * dt;
      before = power;
      last = energy;
    }
  }
  EXPECT_GE(hits, 3);
  EXPECT_GT(rubbed, 0.05 * throughput) << "friction that matters";
  EXPECT_NEAR(last - first, work, 2e-4 * throughput);
}

}  // namespace
}  // namespace rubsweep::integrate::adaptive
