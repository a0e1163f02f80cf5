#include "rubsweep/core/response/proof/orbit_proof.hpp"

#include <gtest/gtest.h>

#include "core/scene/one_side_machine.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "rubsweep/core/response/settle.hpp"

namespace rubsweep::response::proof {
namespace {

/// The one-side machine with its stop divided into `count` equal stops on rigid casings, which share its
/// stiffness and damping.
model::Machine shared_by(int count) {
  model::Machine machine = scene::one_side_machine();
  model::Stop stop = machine.stops.front();
  stop.casing.reset();
  stop.friction = model::StribeckFriction{{0, 0, 0, 0.1, 100, 0}};
  stop.stiffness_n_per_m /= count;
  stop.damping = model::ExplicitDamping{600.0 / count};
  machine.stops.assign(static_cast<std::size_t>(count), stop);
  return machine;
}

scene::Cell cell_of(const model::Machine& machine) {
  return scene::build_cell(machine, 75, scene::WhirlRatio{0.4});
}

TEST(OrbitProof, MakeOneStopWithTheSumOfTheirForces) {
  const scene::Scene one = cell_of(shared_by(1)).scene;
  for (const int count : {2, 3, 4}) {
    const scene::Scene merged = with_equal_stops_as_one(cell_of(shared_by(count)).scene);
    ASSERT_EQ(merged.contacts.size(), 1U);
    EXPECT_DOUBLE_EQ(merged.contacts[0].stiffness_n_per_m, one.contacts[0].stiffness_n_per_m);
    EXPECT_DOUBLE_EQ(merged.contacts[0].damping_ns_per_m, one.contacts[0].damping_ns_per_m);
    // In every turn the motion with several stops equals that with the merged stop.
    integrate::exact::modes::ModeCache modes;
    const auto several = integrate::start(cell_of(shared_by(count)).scene, {}, modes);
    const auto alone = integrate::start(merged, {}, modes);
    integrate::run::TurnReport a, b;
    for (int k = 0; k < 20; ++k) {
      ASSERT_EQ(several.advance({}, a), integrate::run::Outcome::ok);
      ASSERT_EQ(alone.advance({}, b), integrate::run::Outcome::ok);
      for (std::size_t i = 0; i < a.section.size(); ++i) EXPECT_NEAR(a.section[i], b.section[i], 1e-9) << k;
    }
  }
}

TEST(OrbitProof, AnythingThatDiffersKeepsThemApart) {
  const auto stops_left = [](const auto& change) {
    model::Machine machine = shared_by(2);
    change(machine.stops.back());
    return with_equal_stops_as_one(cell_of(machine).scene).contacts.size();
  };
  EXPECT_EQ(stops_left([](model::Stop& stop) { stop.clearance_m *= 1 + 1e-12; }), 2U);
  EXPECT_EQ(stops_left([](model::Stop& stop) { stop.geometry = model::OneSideGeometry{91}; }), 2U);
  EXPECT_EQ(stops_left([](model::Stop& stop) { stop.geometry = model::AnnularGeometry{}; }), 2U);
  EXPECT_EQ(stops_left([](model::Stop& stop) { stop.friction = model::NoFriction{}; }), 2U);
  EXPECT_EQ(stops_left([](model::Stop& stop) { stop.damping = model::ExplicitDamping{200}; }), 2U);
  EXPECT_EQ(stops_left([](model::Stop& stop) { stop.contact_radius_m *= 2; }), 2U);
  EXPECT_EQ(stops_left([](model::Stop& stop) { stop.casing = scene::one_side_machine().stops[0].casing; }),
            2U);
  // Twice the stiffness with twice the damping gives the same guard.
  EXPECT_EQ(stops_left([](model::Stop& stop) {
              stop.stiffness_n_per_m *= 2;
              stop.damping = model::ExplicitDamping{600};
            }),
            1U);
}

/// Two guards that are the same function of the state cross at the same instant, so no tube of motions can
/// separate them.
TEST(OrbitProof, AnOrbitAgainstThemIsProvenAsThatAgainstOne) {
  motion::Workspace workspace;
  for (const int count : {1, 2, 3}) {
    const SettledRun run = settle(cell_of(shared_by(count)), {}, {}, workspace);
    EXPECT_EQ(run.proof, motion::Proof::floquet) << count;
    EXPECT_EQ(run.motion.order, 2) << count;
  }
}

}  // namespace
}  // namespace rubsweep::response::proof
