#include "rubsweep/core/integrate/exact/tube/exact_tube.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <complex>
#include <random>

#include "core/integrate/exact/rubbing_turn.hpp"
#include "rubsweep/core/numerics/spectral/decompositions.hpp"

namespace rubsweep::integrate::exact::tube {
namespace {

/// Tube of one turn.
std::optional<TurnTube> tube_of(const scene::Scene& scene, modes::ModeCache& modes,
                                std::vector<double>& section, const Eigen::MatrixXd& disturbances,
                                const Eigen::MatrixXd& end_norm) {
  auto tubes = turn_tubes(scene, modes, section, {disturbances}, {end_norm});
  return tubes ? std::optional(std::move(tubes->front())) : std::nullopt;
}

using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd vector_of(const std::vector<double>& x) {
  return Eigen::Map<const VectorXd>(x.data(), static_cast<Eigen::Index>(x.size()));
}

/// Follows a turn from random states in a ball around its start.
void expect_deviations_below_their_bound(RubbingTurn turn) {
  const MatrixXd identity = MatrixXd::Identity(8, 8);
  std::vector<double> section = turn.start;
  const auto tube = tube_of(turn.scene, turn.modes, section, identity, identity);
  ASSERT_TRUE(tube);
  EXPECT_NEAR((vector_of(section) - vector_of(turn.end)).cwiseAbs().maxCoeff(), 0, 1e-12);
  double radius = 0.1;
  while (!tube->holds({radius})) radius /= 2;
  ASSERT_GT(radius, 1e-7);
  EXPECT_FALSE(tube->holds({10}));
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  double largest_share = 0;
  for (int trial = 0; trial < 300; ++trial) {
    VectorXd y(8);
    for (double& x : y) x = normal(random);
    const double share = trial % 2 == 0 ? 1 : 0.25;
    y *= share * radius / y.norm();
    VectorXd from = vector_of(turn.start) + y;
    run::TurnReport made;
    turn.turn_from({from.begin(), from.end()}, made);
    const double deviation = (vector_of(made.section) - vector_of(turn.end) - turn.transition * y).norm();
    EXPECT_LE(deviation, tube->deviation({radius}).fast * share * share + 1e-12);
    largest_share = std::max(largest_share, deviation / tube->deviation({radius}).fast);
  }
  // The bound is too large by a few orders of magnitude at most.
  EXPECT_GT(largest_share, 1e-4);
}

TEST(ExactTube, DeviationFromTheLinearMapIsBelowItsBound) {
  expect_deviations_below_their_bound(RubbingTurn());
}

TEST(ExactTube, CarriesAForceOfTwiceTheShaftsFrequency) {
  scene::Scene scene = test::cell_of({}).scene;
  scene.second_harmonic_n = std::polar(0.3, 0.7) * scene.harmonic_n;
  const RubbingTurn plain;
  RubbingTurn forced(scene);
  EXPECT_GT((vector_of(plain.start) - vector_of(forced.start)).norm(), 1e-3);
  expect_deviations_below_their_bound(std::move(forced));
}

TEST(ExactTube, AFlightHasNoDeviation) {
  scene::Scene scene = test::cell_of({}).scene;
  scene.pulses.clear();
  modes::ModeCache modes;
  std::vector<double> section(8, 0.0);
  const MatrixXd identity = MatrixXd::Identity(8, 8);
  const auto tube = tube_of(scene, modes, section, identity, identity);
  ASSERT_TRUE(tube);
  EXPECT_TRUE(tube->holds({1e-2}));
  EXPECT_EQ(tube->deviation({1e-2}).fast, 0);
  EXPECT_FALSE(tube->holds({5}));
  EXPECT_EQ(tube->deviation({5}).fast, std::numeric_limits<double>::infinity());
}

TEST(ExactTube, ContractionIsThatOfTheLinearMap) {
  RubbingTurn turn;
  std::vector<double> section = turn.start;
  const MatrixXd identity = MatrixXd::Identity(8, 8);
  const auto tube = tube_of(turn.scene, turn.modes, section, identity, identity);
  ASSERT_TRUE(tube);
  EXPECT_NEAR(tube->to_fast.fast, numerics::spectral::singular_values(turn.transition).values(0),
              1e-9 * tube->to_fast.fast);
}

/// Closed forms do not include viscous friction, however small it is.
TEST(ExactTube, NoneWhereFrictionNeverSaturates) {
  RubbingTurn turn;
  std::vector<double> section = turn.start;
  turn.scene.contacts.front().friction = model::StribeckFriction{{0, 0, 0, 0, 0, 1e-9}};
  modes::ModeCache modes;
  const MatrixXd identity = MatrixXd::Identity(8, 8);
  EXPECT_FALSE(tube_of(turn.scene, modes, section, identity, identity));
}

/// With saturated friction the motion does not depend on the surface speed, but the tube does.
TEST(ExactTube, SlipsMustStaySaturated) {
  RubbingTurn turn;
  const MatrixXd identity = MatrixXd::Identity(8, 8);
  const auto radius_at = [&](double surface_speed_m_per_s) {
    turn.scene.contacts.front().surface_speed_m_per_s = surface_speed_m_per_s;
    modes::ModeCache modes;
    std::vector<double> section = turn.start;
    const auto tube = tube_of(turn.scene, modes, section, identity, identity);
    double radius = tube ? 0.1 : 0;
    while (radius > 1e-12 && !tube->holds({radius})) radius /= 2;
    return radius;
  };
  const double usual = turn.scene.contacts.front().surface_speed_m_per_s, free = radius_at(usual);
  EXPECT_GT(free, 1e-7);
  double none = 0, some = usual;
  EXPECT_EQ(radius_at(none), 0);
  for (int i = 0; i < 40; ++i) {
    const double middle = (none + some) / 2;
    (radius_at(middle) > 0 ? some : none) = middle;
  }
  EXPECT_LT(radius_at(some), 0.1 * free);
}

}  // namespace
}  // namespace rubsweep::integrate::exact::tube
