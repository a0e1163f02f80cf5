#include "rubsweep/analysis/branch/orbits/even_contacts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/annular_scene.hpp"

namespace rubsweep::branch::orbits {
namespace {

using contact::Mode;

/// States of a circle of radius `radius`, in rest: of these the positions alone matter.
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
  // As where rounding makes the modes.
  facts.switches = {{1.0, 0, Mode::open, Mode::sprung}, {1.1, 0, Mode::sprung, Mode::open}};
  facts.hits = 1;
  facts.touched = true;
  facts.contact_fraction = 0.02;
  contacts.settle(facts);
  return facts;
}

TEST(EvenContacts, ACircleInARingAboutItsCentre) {
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

TEST(EvenContacts, ARingOffTheCentreIsNotEven) {
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

TEST(EvenContacts, NothingWithoutStates) {
  OrbitFacts facts;
  EvenContacts(ring_off_by(0)).settle(facts);
  EXPECT_TRUE(facts.even.empty());
  EXPECT_TRUE(facts.unbroken.empty());
}

TEST(EvenContacts, PenetrationAtAState) {
  EXPECT_NEAR(penetration_at(ring_off_by(0.1), Eigen::Vector4d(1.3, 0, 0, 0), 0), 0.4, 1e-15);
  EXPECT_NEAR(penetration_at(ring_off_by(0), Eigen::Vector4d(0.3, 0.4, 5, 6), 0), -0.5, 1e-15);
}

}  // namespace
}  // namespace rubsweep::branch::orbits
