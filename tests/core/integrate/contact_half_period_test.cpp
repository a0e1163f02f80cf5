// A free rotor mass hits a free casing mass: the contact lasts pi / sqrt(K (1/m + 1/m_C)) and changes the
// speeds as an elastic impact does.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "rubsweep/core/integrate/adaptive/start_adaptive.hpp"
#include "support/simple_scenes.hpp"

namespace rubsweep::integrate {
namespace {

/// Mass m at x = 0 moves at `speed` towards a casing of mass m_C, at rest behind a gap.
scene::Scene two_free_masses(double m, double m_casing, double stiffness, double gap, double speed) {
  auto scene = test::one_mass_scene(m, 0, 0, 1, gap);
  auto& system = scene.structure;
  system.mass = Eigen::Vector4d(m, m, m_casing, m_casing).asDiagonal();
  system.damping = system.stiffness = Eigen::MatrixXd::Zero(4, 4);
  system.points.assign(2, {Eigen::Matrix<double, 2, Eigen::Dynamic>::Zero(2, 4)});
  system.points[0].map.leftCols(2).setIdentity();
  system.points[1].map.rightCols(2).setIdentity();
  scene.harmonic_n = Eigen::VectorXcd::Zero(4);
  scene.constant_n = scene.displacement_m = Eigen::VectorXd::Zero(4);
  scene.velocity_m_per_s = Eigen::Vector4d(speed, 0, 0, 0);
  scene::Contact wall = test::wall_across_x(1, gap, stiffness, 0);
  wall.casing_point = 1;
  scene.contacts.push_back(wall);
  return scene;
}

TEST(ContactHalfPeriod, IsThatOfBothMassesOnTheContactSpring) {
  const double m = 0.8, stiffness = 2e6, gap = 1e-3, speed = 0.5;
  for (const double m_casing : {0.001, 0.05, 0.8, 50.0}) {
    const run::Cursor advance = adaptive::start_adaptive(two_free_masses(m, m_casing, stiffness, gap, speed),
                                                         {.relative_tolerance = 1e-11});
    run::TurnRequest asked;
    run::TurnReport turn;
    asked.switches = asked.peaks = true;
    ASSERT_EQ(advance(asked, turn), run::Outcome::ok);
    ASSERT_EQ(turn.switches.size(), 2u) << m_casing;
    const double seconds = 1 / (2 * std::numbers::pi);
    const double rate = std::sqrt(stiffness * (1 / m + 1 / m_casing));
    EXPECT_NEAR(turn.switches[0].phase_rad * seconds, gap / speed, 1e-9);
    EXPECT_NEAR((turn.switches[1].phase_rad - turn.switches[0].phase_rad) * seconds, std::numbers::pi / rate,
                1e-8 * std::numbers::pi / rate);
    EXPECT_NEAR(turn.peak_contact_force_n, stiffness * speed / rate, 1e-4 * stiffness * speed / rate);
    const double unit = gap * 2 * std::numbers::pi;
    EXPECT_NEAR(turn.section[4] * unit, speed * (m - m_casing) / (m + m_casing), 1e-8);
    EXPECT_NEAR(turn.section[6] * unit, speed * 2 * m / (m + m_casing), 1e-8);
  }
}

}  // namespace
}  // namespace rubsweep::integrate
