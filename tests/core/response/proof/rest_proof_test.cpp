#include "rubsweep/core/response/proof/rest_proof.hpp"

#include <gtest/gtest.h>

#include <random>

#include "rubsweep/core/integrate/adaptive/start_adaptive.hpp"
#include "rubsweep/core/integrate/run/scaled_system.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::response::proof {
namespace {

TEST(RestProof, QuietMotionRests) {
  const auto cell = test::cell_of({});
  EXPECT_TRUE(RestProof(cell).proves(integrate::run::scaled_initial_state(cell.scene)));
}

TEST(RestProof, NeverProvesAFlightThatTouchesLater) {
  // From random states in flight: every motion proven contact-free is integrated for 40 turns and must stay
  // open.
  test::OneSideRotor rotor;
  rotor.kick_n = 0;
  std::mt19937 random(4);
  std::normal_distribution<double> normal;
  int proven = 0, refused_but_quiet = 0, touched = 0;
  for (int trial = 0; trial < 600; ++trial) {
    auto cell = test::cell_of(rotor);
    for (Eigen::Index i = 0; i < 4; ++i) {
      const double scale = cell.scene.length_scale_m * (i < 2 ? 0.4 : 0.1);
      cell.scene.displacement_m(i) += scale * normal(random);
      cell.scene.velocity_m_per_s(i) += scale * 188 * normal(random);
    }
    const auto start = integrate::run::scaled_initial_state(cell.scene);
    if (start[1] - start[3] >= 1) continue;
    const bool proof = RestProof(cell).proves(start);
    const integrate::run::Cursor advance = integrate::adaptive::start_adaptive(cell.scene, {});
    integrate::run::TurnReport turn;
    bool touches = false;
    for (int k = 0; k < 40 && !touches; ++k) {
      ASSERT_EQ(advance({}, turn), integrate::run::Outcome::ok);
      touches = turn.touched;
    }
    ASSERT_FALSE(proof && touches) << trial;
    proven += proof;
    touched += touches;
    refused_but_quiet += !proof && !touches;
  }
  // The bound is tight: it rejects few flights that stay open.
  EXPECT_GT(proven, 50);
  EXPECT_GT(touched, 50);
  EXPECT_LT(refused_but_quiet, proven / 2);
}

TEST(RestProof, GivesUpWhereImpulsesGoOn) {
  auto cell = test::cell_of({});
  cell.scene.impulses.push_back({Eigen::Vector4d(1, 0, 0, 0), 3.5, 0});
  EXPECT_FALSE(RestProof(cell).proves(integrate::run::scaled_initial_state(cell.scene)));
}

TEST(RestProof, GivesUpWhereAModeGrows) {
  auto cell = test::cell_of({});
  cell.scene.structure.damping(0, 0) = -1;
  EXPECT_FALSE(RestProof(cell).proves(integrate::run::scaled_initial_state(cell.scene)));
  EXPECT_TRUE(RestProof(cell).vibration_grows());
  cell.scene.impulses.push_back({Eigen::Vector4d(1, 0, 0, 0), 3.5, 0});
  EXPECT_TRUE(RestProof(cell).vibration_grows());  // self-excited growth, whatever the impulses are
}

TEST(RestProof, HoldsThroughCriticalDamping) {
  test::OneSideRotor rotor;
  for (const double ratio : {0.9, 1.0, 1.5}) {
    rotor.damping_ratio = ratio;
    const auto cell = test::cell_of(rotor);
    EXPECT_TRUE(RestProof(cell).proves(integrate::run::scaled_initial_state(cell.scene))) << ratio;
  }
}

TEST(RestProof, GivesUpOnADefectiveBasis) {
  auto cell = test::cell_of({});
  // x drives y at equal frequencies: a resonance that grows for a while.
  cell.scene.structure.stiffness(1, 0) = 0.1 * cell.scene.structure.stiffness(0, 0);
  EXPECT_FALSE(RestProof(cell).proves(integrate::run::scaled_initial_state(cell.scene)));
}

TEST(RestProof, UndampedRotorIsProvenBelowItsAmplitude) {
  test::OneSideRotor rotor;
  rotor.damping_ratio = 0;
  auto cell = test::cell_of(rotor);
  cell.scene.displacement_m(1) += 0.55e-3;  // 0.4 + 0.55 < 1 clearance
  EXPECT_TRUE(RestProof(cell).proves(integrate::run::scaled_initial_state(cell.scene)));
  cell.scene.displacement_m(1) += 0.1e-3;
  EXPECT_FALSE(RestProof(cell).proves(integrate::run::scaled_initial_state(cell.scene)));
}

}  // namespace
}  // namespace rubsweep::response::proof
