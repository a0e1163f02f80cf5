#include "rubsweep/core/response/rotating/rotating_proof.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <utility>

#include "core/response/annular_cell.hpp"
#include "rubsweep/core/integrate/run/scaled_system.hpp"
#include "rubsweep/core/numerics/dense/eigenvalues.hpp"
#include "rubsweep/core/numerics/matrix_flow.hpp"
#include "rubsweep/core/response/proof/section_map.hpp"
#include "rubsweep/core/response/rotating/rotating_frame.hpp"
#include "rubsweep/core/response/settle.hpp"
#include "support/annular_scene.hpp"

namespace rubsweep::response::testing {
namespace {

SettledRun run(const scene::Cell& cell, bool proof, int max_revolutions = 600) {
  motion::ResponseOptions options;
  options.floquet_proof = proof;
  options.max_revolutions = max_revolutions;
  motion::Workspace workspace;
  return settle(cell, {}, options, workspace);
}

std::string name(const SettledRun& settled) { return std::string(to_string(settled.motion.motion_class)); }

/// A motion proven within some turns, and the motion observed after `observed_turns` without a proof.
struct ProvenAndObserved {
  SettledRun proven, observed;

  ProvenAndObserved(const scene::Cell& cell, const char* motion_class, int within_turns, int observed_turns)
      : proven(run(cell, true)), observed(run(cell, false, observed_turns)) {
    EXPECT_EQ(proven.proof, motion::Proof::floquet_observed);
    EXPECT_LT(proven.revolutions, within_turns);
    EXPECT_EQ(name(proven), motion_class);
    EXPECT_EQ(name(observed), motion_class);
  }
};

/// A turn in which the rotor's distance from the centre has `maxima` maxima. They grow from turn to turn, so
/// that no state returns.
integrate::run::TurnReport turn_with(int maxima, int samples, int number) {
  integrate::run::TurnReport turn;
  turn.touched = true;
  turn.sample_count = samples;
  for (int k = 0; k < samples; ++k) {
    const double phase = 2 * std::numbers::pi * (k + 0.5) / samples, radius = 1.2 + 0.3 * number;
    const double distance = radius + 0.05 * std::cos(maxima * phase),
                 rate = -0.05 * maxima * std::sin(maxima * phase);
    const std::complex<double> way = std::polar(1.0, phase), z = distance * way,
                               v = (rate + std::complex(0.0, distance)) * way;
    turn.samples.insert(turn.samples.end(), {z.real(), z.imag(), 0, 0, v.real(), v.imag(), 0, 0});
  }
  turn.section.assign(turn.samples.begin(), turn.samples.begin() + 8);
  return turn;
}

TEST(RotatingProof, AsksForFewerSamplesWhereMaximaAreFew) {
  for (const auto& [maxima, usual] : {std::pair{2, 32}, {8, 64}}) {
    const motion::ResponseOptions options;
    motion::Workspace workspace;
    integrate::run::WorkBudget budget(1e9);
    rotating::RotatingProof proof(annular_cell(165, 0.6).scene, {}, options, workspace, budget);
    for (int number = 0; number < 20; ++number) {
      const int wanted = proof.samples_wanted();
      EXPECT_EQ(wanted, number % 8 == 0 ? 64 : usual) << maxima << ' ' << number;
      EXPECT_FALSE(proof.look(turn_with(maxima, wanted, number)));
    }
  }
}

TEST(RotatingProof, TheCircleIsWhatALongRunShows) {
  const auto [proven, observed] = ProvenAndObserved(annular_cell(80, 0.6), "synchronous", 20, 200);
  EXPECT_EQ(proven.motion.order, 1);
  const motion::Measures &a = proven.motion.measures, &b = observed.motion.measures;
  EXPECT_EQ(a.orbit, spectrum::OrbitKind::circle);
  EXPECT_EQ(a.whirl, b.whirl);
  EXPECT_EQ(a.contact.hits, 0);
  EXPECT_EQ(b.contact.hits, 0);
  EXPECT_NEAR(a.amplitude_1x_forward_m, b.amplitude_1x_forward_m, 1e-10);
  EXPECT_NEAR(a.contact.peak_displacement_m, b.contact.peak_displacement_m, 1e-10);
  EXPECT_NEAR(a.contact.peak_casing_displacement_m, b.contact.peak_casing_displacement_m, 1e-10);
  EXPECT_GT(a.contact.peak_casing_displacement_m, 1e-6);
  EXPECT_NEAR(a.contact.contact_fraction, b.contact.contact_fraction, 1e-12);
  EXPECT_FALSE(a.comb_spacing);
}

TEST(RotatingProof, TheOvalIsWhatALongRunShows) {
  const auto [proven, observed] = ProvenAndObserved(annular_cell(165, 0.6), "quasi_periodic", 40, 400);
  const motion::Measures &a = proven.motion.measures, &b = observed.motion.measures;
  EXPECT_NEAR(a.comb_spacing.value(), b.comb_spacing.value(), 1e-8);
  EXPECT_EQ(a.orbit, b.orbit);
  EXPECT_EQ(a.whirl, b.whirl);
  EXPECT_NEAR(a.dominant.value().order, b.dominant.value().order, 1e-8);
  EXPECT_NEAR(a.dominant->amplitude_m, b.dominant->amplitude_m, 1e-6 * b.dominant->amplitude_m);
  // Lines between the bins of the observed window are accurate to 1 %.
  EXPECT_NEAR(a.amplitude_1x_forward_m, b.amplitude_1x_forward_m, 2e-2 * b.amplitude_1x_forward_m);
  EXPECT_NEAR(a.contact.contact_fraction, b.contact.contact_fraction, 1e-2);
  EXPECT_NEAR(a.contact.hits, b.contact.hits, 1);
  EXPECT_NEAR(a.contact.peak_displacement_m, b.contact.peak_displacement_m, 1e-9);
  EXPECT_NEAR(a.contact.peak_contact_force_n, b.contact.peak_contact_force_n, 1e-3);
  EXPECT_NEAR(a.contact.peak_casing_displacement_m, b.contact.peak_casing_displacement_m, 1e-9);
}

/// Multiplier -0.9915: the transient alternates for a thousand turns, so a run of 600 turns finds the double
/// period.
TEST(RotatingProof, AnOvalThatIsReachedSlowlyIsProvenAtOnce) {
  const auto proven = run(annular_cell(120, 0.6), true);
  EXPECT_EQ(proven.proof, motion::Proof::floquet_observed);
  EXPECT_LT(proven.revolutions, 400);
  EXPECT_NEAR(proven.motion.measures.comb_spacing.value(), 0.40854734, 1e-7);
  EXPECT_NEAR(proven.floquet_modulus.value(), 0.991531, 1e-5);
}

TEST(RotatingProof, DryWhipHasNoMaximumToReturnToAndStaysObserved) {
  model::Machine machine = annular_machine();
  std::get<model::JeffcottRotor>(machine.rotor).damping_ratio = 0.02;
  machine.stops[0].friction = model::StribeckFriction{{0, 0, 0, 0.1, 100, 0}};
  machine.stops[0].casing->damping_ratio = 0.1;
  machine.kick->force_n = 200;
  const auto whip = run(scene::build_cell(machine, 60, scene::WhirlRatio{0}), true, 300);
  EXPECT_EQ(whip.proof, motion::Proof::observed);
  EXPECT_EQ(whip.motion.measures.orbit, spectrum::OrbitKind::circle);
}

/// In a coarse map every label equals that of long runs without a proof.
TEST(RotatingProof, LabelsAreThoseOfLongRuns) {
  for (const double speed_hz : {75.0, 100.0, 150.0, 210.0}) {
    for (const double whirl_ratio : {0.3, 0.8}) {
      const auto cell = annular_cell(speed_hz, whirl_ratio);
      if (cell.start != scene::Start::quiet) continue;
      const auto proven = run(cell, true), observed = run(cell, false, 400);
      SCOPED_TRACE(std::to_string(speed_hz) + " " + std::to_string(whirl_ratio));
      EXPECT_EQ(name(proven), name(observed));
      EXPECT_EQ(proven.motion.order, observed.motion.order);
      EXPECT_EQ(proven.motion.measures.orbit, observed.motion.measures.orbit);
      EXPECT_NE(proven.proof, motion::Proof::observed);
    }
  }
}

}  // namespace
}  // namespace rubsweep::response::testing

namespace rubsweep::response::rotating {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

TEST(RotatingProofFind, FullAnnularRubAndTheMultiplierOfItsSection) {
  const test::FullRub rub;
  const auto scene = rub.scene();
  const RotatingField field(scene, {});
  integrate::run::SolverOptions solver;
  solver.relative_tolerance = 1e-11;
  integrate::exact::modes::ModeCache modes;
  proof::SceneMap map(scene, solver, modes);
  const auto on_circle = integrate::run::scaled_initial_state(scene);
  const VectorXd exact = Eigen::Map<const VectorXd>(on_circle.data(), 4);
  VectorXd before = exact;
  before(0) += 0.01;
  VectorXd now = before;
  ASSERT_TRUE(map({now.data(), 4}));
  const auto circle = find_rotating_equilibrium({[&](const VectorXd& y) { return field.rate(y); },
                                                 [&](const VectorXd& y) { return field.jacobian(y); }},
                                                now);
  ASSERT_TRUE(circle);
  EXPECT_LT((circle->state - exact).cwiseAbs().maxCoeff(), 1e-12);
  auto section = on_circle;
  MatrixXd monodromy = MatrixXd::Identity(4, 4);
  ASSERT_TRUE(map.carry(section, monodromy));
  EXPECT_NEAR(circle->floquet_modulus, numerics::dense::spectral_radius(monodromy), 1e-6);
}

/// y' = A (y - 1) + quadratic terms: a focus, stable for positive `damping`.
RotatingEquations focus(double damping) {
  const MatrixXd a{{-damping, 1}, {-1, -damping}};
  return {[a](const VectorXd& y) -> VectorXd {
            const VectorXd d = y - VectorXd::Ones(2);
            return a * d + d.squaredNorm() * VectorXd::Unit(2, 0);
          },
          [a](const VectorXd& y) -> MatrixXd {
            const VectorXd d = y - VectorXd::Ones(2);
            return a + 2 * VectorXd::Unit(2, 0) * d.transpose();
          }};
}

TEST(RotatingProofFind, FindsAStablePointWithItsModulus) {
  const VectorXd start{{1.02, 0.99}};
  const auto circle = find_rotating_equilibrium(focus(0.1), start);
  ASSERT_TRUE(circle);
  EXPECT_LT((circle->state - VectorXd::Ones(2)).norm(), 1e-12);
  EXPECT_NEAR(circle->floquet_modulus, std::exp(-0.2 * std::numbers::pi), 1e-12);
  EXPECT_NEAR(numerics::dense::spectral_radius(circle->transition), circle->floquet_modulus, 1e-12);
}

TEST(RotatingProofFind, RefusesAnUnstablePoint) {
  const VectorXd start{{1.002, 0.999}};
  EXPECT_FALSE(find_rotating_equilibrium(focus(-0.1), start));
  EXPECT_FALSE(find_rotating_equilibrium(focus(1e-9), start));
}

TEST(RotatingProofFind, RefusesAPointFarAway) {
  const VectorXd start{{1.3, 1}};
  EXPECT_FALSE(find_rotating_equilibrium(focus(0.1), start));
}

}  // namespace
}  // namespace rubsweep::response::rotating
