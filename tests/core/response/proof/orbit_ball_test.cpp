#include "rubsweep/core/response/proof/orbit_ball.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <random>

#include "rubsweep/core/response/proof/approach.hpp"
#include "rubsweep/core/response/proof/section_map.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::response::proof {
namespace {

/// The 1/2 subharmonic of parameter set A at 75 Hz and whirl ratio 0.4.
struct HalfMotion {
  scene::Scene scene = after_the_kick(test::cell_of({}).scene);
  integrate::exact::modes::ModeCache modes;
  SceneMap map{scene, {}, modes};
  StableOrbit orbit;
  AdaptedNorms norms;
  std::vector<double> section;

  TurnMap turn() {
    return [this](std::span<double> s, Eigen::MatrixXd* disturbances) {
      return disturbances ? map.carry(s, *disturbances) : map(s);
    };
  }

  HalfMotion() {
    const auto start = test::cell_of({}).scene;
    const auto run = integrate::start(start, {}, modes);
    integrate::run::TurnReport turn_made;
    for (int k = 0; k < 400; ++k) EXPECT_EQ(run.advance({}, turn_made), integrate::run::Outcome::ok);
    const auto found = find_orbit(turn(), turn_made.section, 2);
    EXPECT_TRUE(found);
    orbit = *found;
    EXPECT_EQ(orbit.order, 2);
    norms = *adapted_norms(orbit.transitions);
    section.assign(orbit.sections[0].begin(), orbit.sections[0].end());
  }

  /// A random state on the boundary of the ball with this radius.
  std::vector<double> on_the_rim(double radius, std::mt19937_64& random) const {
    std::normal_distribution<double> normal;
    Eigen::VectorXd y(orbit.sections[0].size());
    for (double& x : y) x = normal(random);
    const Eigen::VectorXd off = norms.norm[0].triangularView<Eigen::Upper>().solve(radius * y.normalized());
    const Eigen::VectorXd state = orbit.sections[0] + off;
    return {state.begin(), state.end()};
  }
};

std::vector<integrate::run::ModeSwitch> switches_of(const HalfMotion& motion,
                                                    integrate::exact::modes::ModeCache& modes,
                                                    std::span<const double> section) {
  const auto run = integrate::start(motion.scene, {}, modes);
  run.restart(section);
  std::vector<integrate::run::ModeSwitch> all;
  integrate::run::TurnRequest asked;
  integrate::run::TurnReport turn;
  asked.switches = true;
  for (int k = 0; k < 2; ++k) {
    EXPECT_EQ(run.advance(asked, turn), integrate::run::Outcome::ok);
    all.insert(all.end(), turn.switches.begin(), turn.switches.end());
  }
  return all;
}

TEST(OrbitBall, EveryMotionOnItsRimComesNearerByTheOrbitsOwnModes) {
  HalfMotion motion;
  const auto radius = ball_radius(motion.scene, motion.modes, motion.section, motion.norms);
  ASSERT_TRUE(radius);
  EXPECT_GT(*radius, 1e-6);
  const auto own = switches_of(motion, motion.modes, motion.section);
  ASSERT_FALSE(own.empty());
  std::mt19937_64 random(3);
  for (int trial = 0; trial < 200; ++trial) {
    auto state = motion.on_the_rim(*radius, random);
    const auto switches = switches_of(motion, motion.modes, state);
    ASSERT_EQ(switches.size(), own.size());
    for (std::size_t i = 0; i < own.size(); ++i) {
      EXPECT_EQ(switches[i].contact, own[i].contact);
      EXPECT_EQ(switches[i].to, own[i].to);
    }
    double last = *radius;
    for (std::size_t k = 1; k <= 4; ++k) {
      ASSERT_TRUE(motion.map(state));
      const Eigen::Map<const Eigen::VectorXd> x(state.data(), static_cast<Eigen::Index>(state.size()));
      const double now = (motion.norms.norm[k % 2] * (x - motion.orbit.sections[k % 2])).norm();
      EXPECT_LT(now, last);
      last = now;
    }
  }
}

/// The ball cannot be much larger: at a hundred times its radius other modes occur.
TEST(OrbitBall, FartherOutOtherModesOccur) {
  HalfMotion motion;
  const auto radius = ball_radius(motion.scene, motion.modes, motion.section, motion.norms);
  ASSERT_TRUE(radius);
  const auto own = switches_of(motion, motion.modes, motion.section);
  std::mt19937_64 random(4);
  int others = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const auto rim = motion.on_the_rim(std::max(2.0, 100 * *radius), random);
    others += switches_of(motion, motion.modes, rim).size() != own.size();
  }
  EXPECT_GT(others, 0);
}

/// With separate radii the ball for a vibration along the wall is much larger than a ball with one radius for
/// all directions.
TEST(OrbitBallSplit, EveryMotionOnItsRimComesNearerByTheOrbitsOwnModes) {
  HalfMotion motion;
  const auto norms = split_norms(motion.orbit.transitions, seen_by_contacts(motion.scene));
  ASSERT_TRUE(norms);
  EXPECT_EQ(norms->slow(), 2);
  const auto radii = split_ball_radii(motion.scene, motion.modes, motion.section, *norms, {1e-3, 0.1});
  ASSERT_TRUE(radii);
  const auto radius = ball_radius(motion.scene, motion.modes, motion.section, motion.norms);
  ASSERT_TRUE(radius);
  EXPECT_GE(radii->fast, *radius);
  EXPECT_GT(radii->slow, 100 * *radius);
  const auto size_of = [&](const std::vector<double>& state, std::size_t at) {
    const Eigen::Map<const Eigen::VectorXd> x(state.data(), static_cast<Eigen::Index>(state.size()));
    const auto parts = parts_of(*norms, at, x - motion.orbit.sections[at]);
    return std::max(parts.fast / radii->fast, parts.slow / radii->slow);
  };
  const auto own = switches_of(motion, motion.modes, motion.section);
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 200; ++trial) {
    Eigen::VectorXd y(norms->norm[0].rows());
    for (double& x : y) x = normal(random);
    y.head(norms->fast) *= radii->fast / y.head(norms->fast).norm();
    y.tail(norms->slow()) *= radii->slow / y.tail(norms->slow()).norm();
    const Eigen::VectorXd from = motion.orbit.sections[0] + norms->unit[0] * y;
    std::vector<double> state(from.begin(), from.end());
    const auto switches = switches_of(motion, motion.modes, state);
    ASSERT_EQ(switches.size(), own.size());
    for (std::size_t i = 0; i < own.size(); ++i) {
      EXPECT_EQ(switches[i].contact, own[i].contact);
      EXPECT_EQ(switches[i].to, own[i].to);
    }
    double last = size_of(state, 0);
    EXPECT_NEAR(last, 1, 1e-9);
    for (std::size_t k = 1; k <= 4; ++k) {
      ASSERT_TRUE(motion.map(state));
      const double now = size_of(state, k % 2);
      EXPECT_LT(now, last);
      last = now;
    }
  }
}

/// Friction that leaves saturation limits the ball of the slow part, too.
TEST(OrbitBallSplit, SlipsMustStaySaturatedForTheSlowPartToo) {
  HalfMotion motion;
  const auto norms = split_norms(motion.orbit.transitions, seen_by_contacts(motion.scene));
  ASSERT_TRUE(norms);
  const auto slow_at = [&](double share) {
    scene::Scene scene = motion.scene;
    scene.contacts.front().surface_speed_m_per_s *= share;
    integrate::exact::modes::ModeCache modes;
    const auto radii = split_ball_radii(scene, modes, motion.section, *norms, {1e-3, 0.1});
    return radii ? radii->slow : 0;
  };
  double none = 0, some = 1;
  ASSERT_GT(slow_at(some), 0);
  for (int i = 0; i < 30; ++i) {
    const double middle = (none + some) / 2;
    (slow_at(middle) > 0 ? some : none) = middle;
  }
  EXPECT_LT(slow_at(some), 0.5 * slow_at(1));
}

TEST(OrbitBall, NoneWhereTurnsHaveNoClosedForm) {
  HalfMotion motion;
  motion.scene.contacts.front().friction = model::StribeckFriction{{0, 0, 0, 0.1, 100, 0.01}};
  integrate::exact::modes::ModeCache modes;
  EXPECT_FALSE(ball_radius(motion.scene, modes, motion.section, motion.norms));
}

}  // namespace
}  // namespace rubsweep::response::proof
