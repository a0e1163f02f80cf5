#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "rubsweep/core/contact/force_law.hpp"
#include "rubsweep/core/integrate/adaptive/start_adaptive.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::integrate {
namespace {

using test::OneSideEquations;
using test::OneSideState;

struct Power {
  double input = 0;      ///< work of unbalance and kick
  double structure = 0;  ///< dissipated by rotor and casing mounts
  double normal = 0;     ///< taken from the motion by the normal force
  double friction = 0;   ///< taken from the motion by friction; negative when the shaft drives the rotor
};

double stored(const OneSideEquations<double>& e, const OneSideState<double>& s) {
  return (e.m * (s[4] * s[4] + s[5] * s[5]) + e.k * (s[0] * s[0] + s[1] * s[1]) +
          e.mc * (s[6] * s[6] + s[7] * s[7]) + e.kc * (s[2] * s[2] + s[3] * s[3])) /
         2;
}

Power power(const OneSideEquations<double>& e, const OneSideState<double>& s, double t) {
  const double cosine = std::cos(e.omega * t), sine = std::sin(e.omega * t);
  const double pulse = t < e.kick_s ? e.kick * std::sin(e.kick_rate * t) : 0;
  const double fx = e.force_x_cos * cosine + e.force_x_sin * sine;
  const double fy = e.force_x_cos * sine - e.force_x_sin * cosine + pulse;
  Power p;
  p.input = fx * s[4] + fy * s[5];
  p.structure = e.c * (s[4] * s[4] + s[5] * s[5]) + e.cc * (s[6] * s[6] + s[7] * s[7]);
  const auto force = contact::elastogap(e.contact_k, e.d, e.penetration(s), e.closing_speed(s));
  p.normal = force.total_n * e.closing_speed(s);
  const double friction = e.mu * std::tanh(e.steepness * (-(s[4] - s[6]) + e.surface_speed)) * force.spring_n;
  p.friction = -friction * (s[4] - s[6]);
  return p;
}

struct Balance {
  double defect = 0;  ///< |stored + dissipated - input| at the end
  double throughput = 0;
  double normal_loss = 0;
};

/// Integrates the powers from samples over six turns of the rubbing 1/2 motion, by the trapezoidal rule.
Balance balance(run::ContactHandling contact, double smoothing_m, int samples) {
  const test::OneSideRotor rotor;
  const OneSideEquations<double> equations(rotor);
  run::SolverOptions options;
  options.relative_tolerance = 1e-10;
  options.contact = contact;
  options.smoothing_m = smoothing_m;
  const run::Cursor advance = adaptive::start_adaptive(test::cell_of(rotor).scene, options);
  run::TurnRequest asked;
  run::TurnReport turn;
  asked.samples_per_revolution = samples;
  const double dt = 1 / (rotor.speed_hz * samples), unit_speed = rotor.clearance_m * equations.omega;
  double sum = 0, first_energy = 0, last_energy = 0;
  Balance result;
  Power previous;
  for (int k = 0; k < 6 * samples; ++k) {
    if (k % samples == 0) {
      EXPECT_EQ(advance(asked, turn), run::Outcome::ok);
    }
    OneSideState<double> s;
    for (std::size_t i = 0; i < 8; ++i) {
      s[i] = turn.samples[static_cast<std::size_t>(k % samples) * 8 + i] *
             (i < 4 ? rotor.clearance_m : unit_speed);
    }
    const Power now = power(equations, s, k * dt);
    if (k == 0) {
      first_energy = stored(equations, s);
    } else {
      const auto mean = [&](double Power::*part) { return (now.*part + previous.*part) / 2 * dt; };
      sum += mean(&Power::input) - mean(&Power::structure) - mean(&Power::normal) - mean(&Power::friction);
      result.throughput += std::abs(mean(&Power::input)) + std::abs(mean(&Power::normal));
      result.normal_loss += mean(&Power::normal);
    }
    previous = now;
    last_energy = stored(equations, s);
  }
  result.defect = std::abs(last_energy - first_energy - sum);
  return result;
}

TEST(EnergyBalance, ClosesOverARubbingRun) {
  const Balance coarse = balance(run::ContactHandling::located, 1e-7, 4096);
  const Balance fine = balance(run::ContactHandling::located, 1e-7, 16384);
  EXPECT_GT(fine.throughput, 0.1);  // joules: the rotor does rub
  EXPECT_LT(fine.defect, 1e-6 * fine.throughput);
  // The remaining error comes from the trapezoidal rule, not from the run.
  EXPECT_LT(fine.defect, coarse.defect / 4);
}

TEST(EnergyBalance, TheNormalForceOnlyDissipates) {
  EXPECT_GT(balance(run::ContactHandling::located, 1e-7, 4096).normal_loss, 0);
}

TEST(EnergyBalance, SmoothingChangesTheForceByItsWidthOnly) {
  // The balance uses the exact force, the run the smoothed one. This causes an error that shrinks with the
  // width of the smoothing.
  const Balance wide = balance(run::ContactHandling::smoothed, 1e-5, 16384);
  const Balance narrow = balance(run::ContactHandling::smoothed, 1e-6, 16384);
  EXPECT_LT(narrow.defect, 1e-4 * narrow.throughput);
  EXPECT_LT(narrow.defect, wide.defect / 3);
}

}  // namespace
}  // namespace rubsweep::integrate
