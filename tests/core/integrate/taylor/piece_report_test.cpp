#include "rubsweep/core/integrate/taylor/piece_report.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "rubsweep/core/integrate/run/pulse_times.hpp"
#include "support/annular_scene.hpp"

namespace rubsweep::integrate::taylor {
namespace {

using contact::Mode;
constexpr int peak_order = 24;

Expansion<2> expanded(const run::ScaledSystem<2>& system, const scene::Scene& scene,
                      const std::vector<double>& state, Mode mode) {
  Expansion<2> motion(system, {.order = peak_order});
  const run::PulseTimes none(scene, run::state_scale(scene), 2 * std::numbers::pi);
  motion.expand(state.data(), 0, none, {mode}, {contact::Slip::forward});
  return motion;
}

/// An undamped rotor on an ellipse is farthest out at the end of the long half-axis, after a quarter turn; in
/// a shorter step, it is farthest out at the step's end.
TEST(PieceReport, FindTheLongHalfAxisOfAnEllipse) {
  const scene::Scene scene = test::annular_scene(1, 0, 1, 0, 0, 10, 0);
  const auto system = run::scale<2>(scene);
  std::vector<double> states;
  const Expansion<2> motion = expanded(system, scene, {0.3, 0, 0, 0.9}, Mode::open);
  EXPECT_NEAR(largest_displacements<2>(motion, system, 1, 2.0, states).observed, 0.9, 5e-5);
  const double end = 1.0;
  EXPECT_NEAR(largest_displacements<2>(motion, system, 1, end, states).observed,
              std::hypot(0.3 * std::cos(end), 0.9 * std::sin(end)), 1e-12);
  EXPECT_NEAR(largest_displacements<2>(motion, system, 1, 0.01, states).observed,
              std::hypot(0.3 * std::cos(0.01), 0.9 * std::sin(0.01)), 1e-12);
}

/// A rotor that moves straight into an undamped stop feels the largest force where it reverses. With the
/// penetration p from zero on, p'' + (1 + k_c) p = -1, so p = -(1 - cos w t) / w^2 + v sin(w t) / w.
TEST(PieceReport, FindTheForceWhereTheRotorTurnsRound) {
  const double k_c = 10, w = std::sqrt(1 + k_c), v = 0.7;
  const scene::Scene scene = test::annular_scene(1, 0, 1, 0, 0, k_c, 0);
  const auto system = run::scale<2>(scene);
  Expansion<2> motion = expanded(system, scene, {1, 0, v, 0}, Mode::sprung);
  const double deepest = -1 / (w * w) + std::hypot(1 / (w * w), v / w);
  EXPECT_NEAR(largest_force(motion.contact(0), peak_order, w, 0.6), k_c * deepest, 5e-5);
  const double early = 0.1;
  EXPECT_NEAR(largest_force(motion.contact(0), peak_order, w, early),
              k_c * (-(1 - std::cos(w * early)) / (w * w) + v * std::sin(w * early) / w), 1e-12);
}

}  // namespace
}  // namespace rubsweep::integrate::taylor
