#include "rubsweep/core/response/rotating/rotating_frame.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <random>

#include "core/response/annular_cell.hpp"
#include "core/response/rotating/initial_state.hpp"
#include "core/scene/one_side_machine.hpp"
#include "rubsweep/core/integrate/adaptive/start_adaptive.hpp"
#include "rubsweep/core/response/proof/section_map.hpp"
#include "support/annular_scene.hpp"

namespace rubsweep::response::rotating {
namespace {

using Eigen::VectorXd;
using response::testing::annular_cell;
using response::testing::annular_machine;

TEST(RotatingFrameTurned, TurnsEveryPairFromXToY) {
  const VectorXd state{{1, 0, 0, 2}};
  const VectorXd quarter{{0, 1, -2, 0}};
  EXPECT_LT((turned(state, std::numbers::pi / 2) - quarter).norm(), 1e-15);
  EXPECT_LT((turned(turned(state, 0.7), -0.7) - state).norm(), 1e-15);
}

TEST(RotatingFrameField, StandsStillOnTheClosedFormOfFullAnnularRub) {
  const test::FullRub rub;
  const scene::Scene scene = rub.scene();
  const RotatingField field(scene, {});
  const VectorXd state = initial_state(scene);
  EXPECT_LT(field.rate(state).cwiseAbs().maxCoeff(), 1e-14);
  EXPECT_TRUE(field.touches(state));
  EXPECT_FALSE(field.touches(0.8 * state));
  EXPECT_NEAR(field.contact_force_n(state), rub.k_c * (rub.radius - 1), 1e-12);
}

TEST(RotatingFrameField, IsTheSameFromEveryDirection) {
  const auto cell = annular_cell(120, 0.6);
  const RotatingField field(cell.scene, {});
  const VectorXd state{{1.2, 0.3, 0.1, -0.05, -0.2, 0.9, 0.1, 0.3}};
  // The unbalance force does not rotate with the state; it is the same for all states, so it is subtracted.
  const VectorXd zero = VectorXd::Zero(8);
  const VectorXd here = field.rate(state) - field.rate(zero),
                 there = field.rate(turned(state, 1.1)) - field.rate(zero);
  EXPECT_LT((there - turned(here, 1.1)).cwiseAbs().maxCoeff(), 1e-12);
}

/// Derivative of y = turned(x, -phase) along a run of the adaptive solver, by differences.
TEST(RotatingFrameField, IsTheRateOfARunSeenFromTheShaft) {
  auto scene = annular_cell(120, 0.6).scene;
  scene.pulses.clear();
  integrate::run::SolverOptions options;
  options.relative_tolerance = 1e-11;
  constexpr int samples = 4096;
  integrate::run::TurnRequest asked;
  integrate::run::TurnReport turn;
  asked.samples_per_revolution = samples;
  scene.displacement_m << 1.15e-3, 0, 2e-5, 0;
  scene.velocity_m_per_s << 0, 0.5, 0.01, 0;
  ASSERT_EQ(integrate::adaptive::start_adaptive(scene, options)(asked, turn), integrate::run::Outcome::ok);
  EXPECT_TRUE(turn.touched);
  const RotatingField field(scene, options);
  const double step = 2 * std::numbers::pi / samples;
  const auto seen = [&](int k) {
    return VectorXd(turned(Eigen::Map<const VectorXd>(turn.samples.data() + 8 * k, 8), -k * step));
  };
  for (int k = 10; k < samples - 10; k += 401) {
    const VectorXd by_differences = (seen(k + 1) - seen(k - 1)) / (2 * step), rate = field.rate(seen(k));
    EXPECT_LT((by_differences - rate).cwiseAbs().maxCoeff(), 1e-3 * rate.cwiseAbs().maxCoeff()) << k;
  }
}

TEST(RotatingFrameField, JacobianIsWhatDifferencesSay) {
  const auto cell = annular_cell(120, 0.6);
  for (const auto contact :
       {integrate::run::ContactHandling::located, integrate::run::ContactHandling::smoothed}) {
    integrate::run::SolverOptions options;
    options.contact = contact;
    options.smoothing_m = 1e-4;
    const RotatingField field(cell.scene, options);
    std::mt19937 random(1);
    std::normal_distribution<double> normal(0, 0.05);
    VectorXd state{{1.3, 0.2, 0.1, 0, -0.2, 0.9, 0.1, 0.1}};
    for (int trial = 0; trial < 8; ++trial) {
      for (double& value : state) value += normal(random);
      const Eigen::MatrixXd jacobian = field.jacobian(state);
      for (Eigen::Index j = 0; j < 8; ++j) {
        const VectorXd step = 1e-6 * VectorXd::Unit(8, j);
        const VectorXd column = (field.rate(state + step) - field.rate(state - step)) / 2e-6;
        EXPECT_LT((column - jacobian.col(j)).cwiseAbs().maxCoeff(), 1e-4) << trial << ' ' << j;
      }
    }
  }
}

TEST(RotatingFrameSymmetry, ARotorInCentredRings) {
  EXPECT_TRUE(rotating::rotationally_symmetric(annular_cell(110, 0.4).scene));
  EXPECT_TRUE(rotating::rotationally_symmetric(annular_cell(110, 0).scene));
  auto machine = annular_machine();
  machine.stops.push_back(machine.stops.front());
  machine.stops.back().casing.reset();
  EXPECT_TRUE(
      rotating::rotationally_symmetric(scene::build_cell(machine, 77.7, scene::WhirlRatio{0.3}).scene));
}

TEST(RotatingFrameSymmetry, NotWithAnOffsetAFlatWallOrGravity) {
  EXPECT_FALSE(rotating::rotationally_symmetric(annular_cell(110, 0.4, 1e-9).scene));
  EXPECT_FALSE(rotating::rotationally_symmetric(
      scene::build_cell(scene::one_side_machine(), 75, scene::WhirlRatio{0.4}).scene));
  auto machine = annular_machine();
  machine.gravity_m_per_s2 = 1e-6;
  EXPECT_FALSE(
      rotating::rotationally_symmetric(scene::build_cell(machine, 110, scene::WhirlRatio{0.4}).scene));
  machine.gravity_m_per_s2 = 0;
  machine.stops.push_back(scene::one_side_machine().stops.front());
  EXPECT_FALSE(
      rotating::rotationally_symmetric(scene::build_cell(machine, 110, scene::WhirlRatio{0.4}).scene));
}

TEST(RotatingFrameSymmetry, NotWithAnAnisotropicStructureOrForcing) {
  const auto without = [](auto&& change) {
    auto scene = annular_cell(110, 0.4).scene;
    change(scene);
    return rotating::rotationally_symmetric(scene);
  };
  EXPECT_FALSE(without([](auto& s) { s.structure.stiffness(1, 1) *= 1 + 1e-12; }));
  EXPECT_FALSE(without([](auto& s) { s.structure.damping(2, 2) *= 2; }));
  EXPECT_FALSE(without([](auto& s) { s.structure.mass(0, 1) = 1e-9; }));
  EXPECT_FALSE(without([](auto& s) { s.structure.points[0].map(0, 0) = 0.5; }));
  EXPECT_FALSE(without([](auto& s) { s.harmonic_n(1) *= 0.99; }));
  EXPECT_FALSE(without([](auto& s) { s.second_harmonic_n = 1e-9 * s.harmonic_n; }));
  EXPECT_FALSE(without([](auto& s) { s.impulses.push_back({Eigen::Vector4d(1, 0, 0, 0), 2, 0}); }));
  EXPECT_FALSE(without([](auto& s) { s.harmonic_n = s.harmonic_n.conjugate().eval(); }));
  // Gyroscopic and cross-coupled terms are invariant under rotation of the frame.
  EXPECT_TRUE(without([](auto& s) {
    s.structure.damping(0, 1) = 0.3;
    s.structure.damping(1, 0) = -0.3;
    s.structure.stiffness(2, 1) = 5;
    s.structure.stiffness(3, 0) = -5;
  }));
}

/// Difference between rotating a section by 0.5 rad before and after one turn of motion.
double turning_first_and_last_differ_by(const scene::Scene& scene) {
  const auto turned = [](std::vector<double> section) {
    for (std::size_t i = 0; i + 1 < section.size(); i += 2) {
      const auto z = std::complex<double>(section[i], section[i + 1]) * std::polar(1.0, 0.5);
      section[i] = z.real();
      section[i + 1] = z.imag();
    }
    return section;
  };
  auto unforced = scene;
  unforced.harmonic_n.setZero();
  integrate::run::SolverOptions solver;
  solver.relative_tolerance = 1e-10;
  integrate::exact::modes::ModeCache modes;
  proof::SceneMap map(unforced, solver, modes);
  std::vector<double> first{0.9, 0.2, 0, 0, 0.3, -0.4, 0.1, 0};
  auto last = turned(first);
  map(last);
  map(first);
  EXPECT_TRUE(map.touched());
  first = turned(first);
  double largest = 0;
  for (std::size_t i = 0; i < first.size(); ++i) largest = std::max(largest, std::abs(first[i] - last[i]));
  return largest;
}

TEST(RotatingFrameSymmetry, IsWhatTheMotionShows) {
  EXPECT_LT(turning_first_and_last_differ_by(annular_cell(110, 0.4).scene), 1e-7);
  EXPECT_GT(turning_first_and_last_differ_by(annular_cell(110, 0.4, 1e-4).scene), 1e-3);
}

}  // namespace

}  // namespace rubsweep::response::rotating
