#include "rubsweep/core/integrate/exact/modes/unbalance_responses.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rubsweep/core/integrate/exact/modes/machine_modes.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::integrate::exact::modes {
namespace {

using Force = Eigen::VectorXcd;

const Force force = Force::Constant(4, {3, -2});
constexpr double rate = 470;

TEST(UnbalanceResponses, AreThoseMadeAlone) {
  MachineModes<4> machine(test::cell_of({}).scene);
  const auto responses = machine.responses_to(force, rate);
  for (const std::size_t joint : {2u, 0u, 3u, 1u}) {
    const LinearMode<4>& mode = *machine.mode(joint);
    HarmonicResponse<4> alone;
    EXPECT_EQ(responses->of(mode).usable, make_harmonic_response(mode, force, rate, alone));
    const HarmonicResponse<4>& shared = responses->of(mode).response;
    EXPECT_EQ(shared.amplitude, alone.amplitude);
    EXPECT_EQ(shared.at_guard, alone.at_guard);
    EXPECT_EQ(shared.curvature, alone.curvature);
  }
}

/// Runs keep pointers to the responses of their modes.
TEST(UnbalanceResponses, StayAtTheirPlaceWhenOthersJoin) {
  MachineModes<4> machine(test::cell_of({}).scene);
  const auto responses = machine.responses_to(force, rate);
  const auto* const first = &responses->of(*machine.mode(0));
  for (const std::size_t joint : {1u, 2u, 3u}) responses->of(*machine.mode(joint));
  EXPECT_EQ(&responses->of(*machine.mode(0)), first);
}

TEST(UnbalanceResponses, AreSharedByRunsOfEqualUnbalanceOnly) {
  MachineModes<4> machine(test::cell_of({}).scene);
  const auto first = machine.responses_to(force, rate);
  EXPECT_EQ(machine.responses_to(force, rate), first);
  const auto faster = machine.responses_to(force, rate + 1), larger = machine.responses_to(2 * force, rate);
  EXPECT_NE(faster, first);
  EXPECT_NE(larger, faster);
  EXPECT_EQ(faster->rate_rad_per_s, rate + 1);
  EXPECT_EQ(larger->acceleration, 2 * force);
}

TEST(UnbalanceResponses, RememberAnUndampedResonance) {
  scene::Scene scene = test::cell_of({}).scene;
  scene.structure.damping.setZero();
  MachineModes<4> machine(scene);
  const LinearMode<4>& open = *machine.mode(0);
  const double natural = std::sqrt(open.stiffness(0, 0));
  const auto responses = machine.responses_to(force, natural);
  EXPECT_FALSE(responses->of(open).usable);
  EXPECT_FALSE(responses->of(open).usable);
}

}  // namespace
}  // namespace rubsweep::integrate::exact::modes
