#include "rubsweep/core/integrate/taylor/expansion.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "core/integrate/taylor/set_c_scene.hpp"

namespace rubsweep::integrate::taylor {
namespace {

using contact::Mode;

/// Halving the duration of one expansion divides the error of the displacement by 2^(order + 2): the
/// displacement is one order more accurate than the velocity.
TEST(Expansion, ConvergesWithItsOrder) {
  scene::Scene scene = set_c_scene(80, 0.6);
  scene.pulses.clear();
  scene.contacts[0].surface_speed_m_per_s = 0.2;
  scene.contacts[0].friction = model::StribeckFriction{{0, 0, 0, 0.1, 2, 0}};
  const std::vector<double> state{1.3, 0.4, 0.1, -0.1, 0.5, -0.9, 0.2, 0.3};
  const auto system = run::scale<4>(scene);
  const std::vector<Mode> modes{Mode::sprung};
  const std::vector<contact::Slip> slips{contact::Slip::forward};
  Expansion<4> reference(system);
  const run::PulseTimes no_pulses(scene, run::state_scale(scene), 2 * std::numbers::pi);
  reference.expand(state.data(), 0.3, no_pulses, modes, slips);
  for (const int order : {4, 7, 10}) {
    Expansion<4> motion(system, {.order = order});
    motion.expand(state.data(), 0.3, no_pulses, modes, slips);
    std::array<double, 2> errors{};
    for (std::size_t half = 0; half < 2; ++half) {
      const double duration = half == 0 ? 0.04 : 0.02;
      std::array<double, 8> exact{}, here{};
      reference.series().put_state(duration, exact.data());
      motion.series().put_state(duration, here.data());
      errors[half] = largest_difference(std::span(exact).first(4), std::span(here).first(4));
    }
    EXPECT_NEAR(std::log2(errors[0] / errors[1]), order + 2, 0.5) << order;
  }
}

}  // namespace
}  // namespace rubsweep::integrate::taylor
