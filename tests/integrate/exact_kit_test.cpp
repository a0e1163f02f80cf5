#include <gtest/gtest.h>

#include "rubsweep/integrate/adaptive.hpp"
#include "rubsweep/integrate/exact.hpp"
#include "rubsweep/scene/build_scene.hpp"
#include "scene/kit_machine.hpp"

namespace rubsweep::integrate {
namespace {

/// A shaft that leans with its disc and rubs a stiff wall beside it: gyroscopic, and the modes with the
/// contact released are as good as dependent.
scene::Scene kit_scene(double speed_hz, double whirl_ratio) {
  model::Machine machine = scene::light_shaft_machine();
  machine.kit->shaft[0].density_kg_per_m3 = 7850;
  machine.kit->modes = 3;
  model::Stop& stop = machine.stops[0];
  stop.position_m = 0.29;
  stop.stiffness_n_per_m = 1.2e8;
  stop.contact_radius_m = 5e-3;
  stop.casing = {.mass_kg = 0.03, .stiffness_n_per_m = 1.18e6, .damping_ratio = 0.05};
  machine.kick->position_m = 0.2;
  return scene::build_cell(machine, speed_hz, scene::WhirlRatio{whirl_ratio}).scene;
}

double largest_difference(const Turn& a, const Turn& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.section.size(); ++i)
    largest = std::max(largest, std::abs(a.section[i] - b.section[i]));
  return largest;
}

TEST(ExactKit, TurnsInContactHaveClosedFormsAndAgreeWithTheAdaptiveSolver) {
  for (const double speed_hz : {70.0, 110.0}) {
    const scene::Scene scene = kit_scene(speed_hz, 0.7);
    ExactPlans plans;
    const auto exact = start_exact(scene, {}, plans);
    const Cursor adaptive = start_adaptive(scene, {.relative_tolerance = 1e-11});
    Turn a, b;
    int hits = 0;
    for (int k = 0; k < 6; ++k) {
      ASSERT_EQ(exact.advance(a), Outcome::ok);
      ASSERT_EQ(adaptive(b), Outcome::ok);
      hits += a.hits;
      EXPECT_EQ(a.hits, b.hits);
      EXPECT_LT(largest_difference(a, b), 1e-7) << speed_hz << ' ' << k;
    }
    EXPECT_GE(hits, 3);
    EXPECT_EQ(a.effort.adaptive_turns, 0);
    EXPECT_EQ(a.effort.rhs_calls, 0);
  }
}

}  // namespace
}  // namespace rubsweep::integrate
