#include "rubsweep/analysis/branch/orbits/approaches.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/annular_scene.hpp"
#include "support/simple_scenes.hpp"

namespace rubsweep::branch::orbits {
namespace {

using contact::Mode;

/// States at rest on a circle of radius `radius`; only the positions matter.
Eigen::MatrixXd states_of_circle(double radius) {
  constexpr int count = 32;
  Eigen::MatrixXd states = Eigen::MatrixXd::Zero(4, count);
  for (int k = 0; k < count; ++k)
    states.col(k).head(2) << radius * std::cos(2 * std::numbers::pi * k / count),
        radius * std::sin(2 * std::numbers::pi * k / count);
  return states;
}

scene::Scene ring_off_by(double offset) {
  scene::Scene scene = test::annular_scene(1, 0.1, 1, 0.3, 0, 4, 0);
  scene.contacts.front().wall = contact::AnnularWall{{offset, 0}};
  return scene;
}

OrbitFacts settled_facts(const scene::Scene& scene, double radius) {
  EvenContacts contacts(scene);
  contacts.add(states_of_circle(radius).leftCols(16));
  contacts.add(states_of_circle(radius).rightCols(16));
  OrbitFacts facts;
  // As if rounding decided the modes.
  facts.switches = {{1.0, 0, Mode::open, Mode::sprung}, {1.1, 0, Mode::sprung, Mode::open}};
  facts.hits = 1;
  facts.touched = true;
  facts.contact_fraction = 0.02;
  contacts.settle(facts);
  return facts;
}

TEST(ApproachesEvenContacts, ACircleInARingAboutItsCentre) {
  for (const double gap : {0.2, 1e-11, -1e-11, -0.2}) {
    const OrbitFacts facts = settled_facts(ring_off_by(0), 1 - gap);
    ASSERT_EQ(facts.even.size(), 1u) << gap;
    EXPECT_NEAR(facts.even.front().penetration, -gap, 1e-15);
    EXPECT_LT(facts.even.front().spread, 1e-15);
    EXPECT_EQ(facts.even.front().touching, Mode::sprung);
    EXPECT_TRUE(facts.switches.empty());
    EXPECT_EQ(facts.hits, 0);
    EXPECT_EQ(facts.touched, gap < 0);
    EXPECT_EQ(facts.contact_fraction, gap < 0 ? 1 : 0);
    EXPECT_EQ(facts.unbroken.size(), gap < 0 ? 1u : 0u);
  }
}

TEST(ApproachesEvenContacts, ARingOffTheCentreIsNotEven) {
  const OrbitFacts facts = settled_facts(ring_off_by(1e-6), 1);
  EXPECT_TRUE(facts.even.empty());
  EXPECT_EQ(facts.switches.size(), 2u);
  EXPECT_EQ(facts.hits, 1);
  EXPECT_TRUE(facts.touched);
  EXPECT_TRUE(facts.unbroken.empty()) << "it parts";

  EvenContacts contacts(ring_off_by(1e-3));
  contacts.add(states_of_circle(1.2));
  OrbitFacts within;
  contacts.settle(within);
  EXPECT_TRUE(within.even.empty());
  EXPECT_EQ(within.unbroken, std::vector<int>{0}) << "it touches all along though not evenly";
}

TEST(ApproachesEvenContacts, NothingWithoutStates) {
  OrbitFacts facts;
  EvenContacts(ring_off_by(0)).settle(facts);
  EXPECT_TRUE(facts.even.empty());
  EXPECT_TRUE(facts.unbroken.empty());
}

TEST(ApproachesEvenContacts, PenetrationAtAState) {
  EXPECT_NEAR(penetration_at(ring_off_by(0.1), Eigen::Vector4d(1.3, 0, 0, 0), 0), 0.4, 1e-15);
  EXPECT_NEAR(penetration_at(ring_off_by(0), Eigen::Vector4d(0.3, 0.4, 5, 6), 0), -0.5, 1e-15);
}

constexpr int samples = 128;

/// Samples of x(phase) and its rate, with the mass at rest in y.
template <class Motion, class Rate>
SampledOrbit sampled(const Motion& x, const Rate& rate) {
  Eigen::MatrixXd states = Eigen::MatrixXd::Zero(4, samples);
  for (Eigen::Index k = 0; k < samples; ++k) {
    const double phase = 2 * std::numbers::pi * static_cast<double>(k) / samples;
    states(0, k) = x(phase);
    states(2, k) = rate(phase);
  }
  return {states, 2 * std::numbers::pi / samples};
}

/// A unit mass before a wall at 1 with stiffness 2.
scene::Scene before_a_wall(double damping) {
  scene::Scene scene = test::one_mass_scene(1, 1, 0, 2 * std::numbers::pi, 1);
  scene.contacts.push_back(test::wall_across_x(1, 1, 2, damping));
  return scene;
}

/// 0.7 cos(2 phase - 1) approaches the wall twice per turn; with a suitable phase the second approach is
/// close to the end of the turn.
TEST(Approaches, InFlight) {
  for (const double lag : {1.0, -0.01}) {
    const auto motion = sampled([lag](double t) { return 0.7 * std::cos(2 * t - lag); },
                                [lag](double t) { return -1.4 * std::sin(2 * t - lag); });
    const auto found = approaches_of(before_a_wall(0), motion, {});
    ASSERT_EQ(found.size(), 2u) << lag;
    for (const Approach& approach : found) {
      EXPECT_EQ(approach.from, Mode::open);
      EXPECT_EQ(approach.to, Mode::sprung);
      EXPECT_NEAR(approach.distance, 0.3, 1e-6);
      EXPECT_NEAR(std::remainder(approach.phase_rad - lag / 2, std::numbers::pi), 0, 1e-4);
    }
  }
}

/// Always in contact with penetration 0.5 +- 0.3: contact is nearly lost at 0.2.
TEST(Approaches, InContact) {
  const auto motion =
      sampled([](double t) { return 1.5 + 0.3 * std::sin(t); }, [](double t) { return 0.3 * std::cos(t); });
  const auto found = approaches_of(before_a_wall(0), motion, {});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].from, Mode::sprung);
  EXPECT_EQ(found[0].to, Mode::open);
  EXPECT_NEAR(found[0].distance, 0.2, 1e-6);
  EXPECT_NEAR(found[0].phase_rad, 1.5 * std::numbers::pi, 1e-4);
}

/// A maximum that leads to a change of mode is not an approach: one of two maxima is an impact.
TEST(Approaches, NotWhereTheContactHits) {
  const auto motion = sampled([](double t) { return 0.8 * std::cos(2 * t) + 0.4 * std::cos(t); },
                              [](double t) { return -1.6 * std::sin(2 * t) - 0.4 * std::sin(t); });
  double touch = 0;
  for (int i = 0; i < 50; ++i)  // solution of 0.8 cos(2 t) + 0.4 cos(t) = 1
    touch -= (0.8 * std::cos(2 * touch) + 0.4 * std::cos(touch) - 1) /
             (touch == 0 ? -1.0 : -1.6 * std::sin(2 * touch) - 0.4 * std::sin(touch));
  const std::vector<integrate::run::ModeSwitch> switches{
      {touch, 0, Mode::sprung, Mode::open}, {2 * std::numbers::pi - touch, 0, Mode::open, Mode::sprung}};
  const auto found = approaches_of(before_a_wall(0), motion, switches);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].from, Mode::open);
  EXPECT_NEAR(found[0].phase_rad, std::numbers::pi, 1e-3);
  EXPECT_NEAR(found[0].distance, 1 - 0.4, 1e-6);
}

/// If it is not known that the orbit closes, the interval from the last sample to the first is ignored.
TEST(Approaches, OfAnOrbitThatDoesNotCloseAtItsSamples) {
  SampledOrbit motion = sampled([](double t) { return 0.7 * std::cos(t + 0.01); },
                                [](double t) { return -0.7 * std::sin(t + 0.01); });
  EXPECT_EQ(approaches_of(before_a_wall(0), motion, {}).size(), 1u);
  motion.closes = false;
  EXPECT_TRUE(approaches_of(before_a_wall(0), motion, {}).empty());
}

TEST(Approaches, NoneWithoutStops) {
  scene::Scene scene = before_a_wall(0);
  scene.contacts.clear();
  EXPECT_TRUE(approaches_of(scene, {Eigen::MatrixXd::Zero(4, samples), 0.1}, {}).empty());
}

}  // namespace

}  // namespace rubsweep::branch::orbits
