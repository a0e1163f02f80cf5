#include <gtest/gtest.h>

#include <functional>
#include <numbers>

#include "core/integrate/largest_difference.hpp"
#include "core/integrate/rubbing_kit.hpp"
#include "core/scene/kit_machine.hpp"
#include "rubsweep/core/integrate/adaptive/start_adaptive.hpp"
#include "rubsweep/core/integrate/hybrid_run.hpp"
#include "rubsweep/core/scene/build_scene.hpp"

namespace rubsweep::integrate {
namespace {

TEST(ExactKit, TurnsInContactHaveClosedFormsAndAgreeWithTheAdaptiveSolver) {
  for (const double speed_hz : {70.0, 110.0}) {
    const scene::Scene scene = kit_scene(speed_hz, 0.7);
    exact::modes::ModeCache modes;
    const auto exact = start_hybrid(scene, {}, modes);
    const run::Cursor adaptive = adaptive::start_adaptive(scene, {.relative_tolerance = 1e-11});
    run::TurnReport a, b;
    int hits = 0;
    for (int k = 0; k < 6; ++k) {
      ASSERT_EQ(exact.advance({}, a), run::Outcome::ok);
      ASSERT_EQ(adaptive({}, b), run::Outcome::ok);
      hits += a.hits;
      EXPECT_EQ(a.hits, b.hits);
      EXPECT_LT(largest_difference(a.section, b.section), 1e-7) << speed_hz << ' ' << k;
    }
    EXPECT_GE(hits, 3);
    EXPECT_EQ(a.effort.taylor_turns + a.effort.adaptive_turns, 0);
    EXPECT_EQ(a.effort.rhs_calls, 0);
  }
}

/// Section after one turn from the quiet motion, without a kick except what `change` adds.
std::vector<double> section_with(const std::function<void(model::Machine&)>& change) {
  model::Machine machine = scene::light_shaft_machine();
  model::kit_of(machine)->shaft[0].density_kg_per_m3 = 7850;
  model::kit_of(machine)->modes = 3;
  machine.stops[0].position_m = 0.29;
  machine.kick.reset();
  change(machine);
  exact::modes::ModeCache modes;
  const auto run = start_hybrid(scene::build_cell(machine, 70, scene::WhirlRatio{0.1}).scene, {}, modes);
  run::TurnReport turn;
  EXPECT_EQ(run.advance({}, turn), run::Outcome::ok);
  EXPECT_FALSE(turn.touched);
  return turn.section;
}

constexpr model::BearingFault one_impulse{.impulse_ns = 0.02, .multiple = 1, .angle_deg = 50};

TEST(ExactKit, AFaultOfABearingIsAShortKickThere) {
  constexpr double duration_s = 1e-8;
  const auto struck =
      section_with([](model::Machine& machine) { model::kit_of(machine)->supports[1].fault = one_impulse; });
  const auto kicked = section_with([&](model::Machine& machine) {
    const double force_n = one_impulse.impulse_ns * std::numbers::pi / (2 * duration_s);
    machine.kick = {.force_n = force_n, .duration_s = duration_s, .angle_deg = 50, .position_m = 0.4};
  });
  EXPECT_GT(largest_difference(struck, section_with([](model::Machine&) {})), 0.01);
  EXPECT_LT(largest_difference(struck, kicked), 1e-5);
}

/// A stiff bearing connects shaft and pedestal, so the impulse and its reaction cancel.
TEST(ExactKit, AFaultStrikesThePedestalTheOtherWay) {
  const auto held = [](double bearing_n_per_m, bool faulty) {
    return section_with([=](model::Machine& machine) {
      for (model::Support& support : model::kit_of(machine)->supports) {
        support.stiffness_x_n_per_m = support.stiffness_y_n_per_m = bearing_n_per_m;
        support.pedestal = {.mass_kg = 0.1, .stiffness_x_n_per_m = 3e4, .stiffness_y_n_per_m = 3e4};
      }
      if (faulty) model::kit_of(machine)->supports[1].fault = one_impulse;
    });
  };
  EXPECT_LT(largest_difference(held(3e10, true), held(3e10, false)), 1e-5);
  EXPECT_GT(largest_difference(held(3e4, true), held(3e4, false)), 1e-3);
}

}  // namespace
}  // namespace rubsweep::integrate
