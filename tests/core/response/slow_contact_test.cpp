// A rotor lies on a stiff damped stop and turns slowly; friction depends on the slip. A turn contains 5e4
// radians of the stop's vibration, which dies out at the very beginning.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "rubsweep/core/integrate/start.hpp"
#include "rubsweep/core/response/settle.hpp"

namespace rubsweep::response {
namespace {

model::Machine machine() {
  model::Stop stop;
  stop.geometry = model::OneSideGeometry{.angle_deg = -90};
  stop.clearance_m = 6e-5;
  stop.stiffness_n_per_m = 3e8;
  stop.damping = model::NominalRestitution{.value = 0.4};
  stop.contact_radius_m = 4e-4;
  stop.friction = model::StribeckFriction{.gamma = {0, 0, 0, 0.05, 1500, 0}};
  model::Machine machine;
  machine.rotor = model::JeffcottRotor{.mass_kg = 0.8, .natural_frequency_hz = 14, .damping_ratio = 0.01};
  machine.stops = {stop};
  machine.gravity_m_per_s2 = 9.81;
  machine.kick = model::Kick{.force_n = 0.3, .duration_s = 0.02, .angle_deg = {}};
  return machine;
}

scene::Cell cell() { return scene::build_cell(machine(), 0.06, scene::Eccentricity{2e-5}); }

/// Runs without the proof that would end it after a few turns.
TEST(SlowContact, ARubOnAStiffStopIsDecidedByItsWindows) {
  motion::Workspace workspace;
  motion::ResponseOptions options;
  options.floquet_proof = false;
  const SettledRun run = settle(cell(), {}, options, workspace);
  EXPECT_EQ(run.outcome, integrate::run::Outcome::ok);
  EXPECT_EQ(run.motion.motion_class, motion::MotionClass::synchronous);
  EXPECT_EQ(run.revolutions, options.max_revolutions);
}

TEST(SlowContact, ItsTurnsAreThoseOfAnExplicitStepper) {
  integrate::exact::modes::ModeCache modes;
  integrate::run::SolverOptions explicitly;
  explicitly.method = integrate::run::Method::adaptive;
  explicitly.stepper = integrate::run::Stepper::dopri5;
  explicitly.relative_tolerance = 1e-10;
  const integrate::run::Run run = integrate::start(cell().scene, {}, modes),
                            stepper = integrate::start(cell().scene, explicitly, modes);
  integrate::run::TurnReport a, b;
  for (int k = 0; k < 3; ++k) {
    ASSERT_EQ(run.advance({}, a), integrate::run::Outcome::ok);
    ASSERT_EQ(stepper.advance({}, b), integrate::run::Outcome::ok);
    for (std::size_t i = 0; i < a.section.size(); ++i) EXPECT_NEAR(a.section[i], b.section[i], 1e-7) << k;
  }
  EXPECT_GE(a.effort.adaptive_turns, 1);
}

/// Beside a slipping contact, dry friction holds the rotor on a stiff stop with a light casing. Steps of the
/// implicit stepper become long only if its Jacobian contains the holding friction.
TEST(SlowContact, ADryContactThatSticksBesideASlippingOneIsDecidedByItsWindows) {
  model::Stop belt, dry;
  belt.geometry = model::OneSideGeometry{.angle_deg = 330};
  dry.geometry = model::OneSideGeometry{.angle_deg = -90};
  belt.clearance_m = dry.clearance_m = 7e-5;
  belt.stiffness_n_per_m = 4e5;
  dry.stiffness_n_per_m = 5e8;
  belt.damping = model::NominalRestitution{.value = 0.6};
  dry.damping = model::NominalRestitution{.value = 0.9};
  belt.contact_radius_m = 0.05;
  belt.friction = model::StribeckFriction{.gamma = {0, 0, 0, 0.3, 40, 0}};
  dry.contact_radius_m = 0;
  dry.friction = model::ConstantFriction{0.7};
  belt.casing = model::Casing{.mass_kg = 0.05, .stiffness_n_per_m = 7e4, .damping_ratio = 0.3};
  dry.casing = model::Casing{.mass_kg = 0.03, .stiffness_n_per_m = 6e4, .damping_ratio = 0.06};
  model::Machine both = machine();
  both.stops = {belt, dry};
  both.rotor = model::JeffcottRotor{.mass_kg = 2.2, .natural_frequency_hz = 25, .damping_ratio = 0.01};
  const scene::Cell held = scene::build_cell(both, 0.8, scene::Eccentricity{2e-5});
  motion::Workspace workspace;
  motion::ResponseOptions options;
  options.floquet_proof = false;
  const SettledRun run = settle(held, {}, options, workspace);
  EXPECT_EQ(run.outcome, integrate::run::Outcome::ok);
  EXPECT_EQ(std::string(to_string(run.motion.motion_class)), "synchronous");
  EXPECT_EQ(run.motion.status, motion::MotionStatus::ok);
  EXPECT_LT(run.effort.taylor_pieces, 10 * 50'000);
}

}  // namespace
}  // namespace rubsweep::response
