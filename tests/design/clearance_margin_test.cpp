#include "rubsweep/design/clearance_margin.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "rubsweep/batch/axis.hpp"
#include "rubsweep/design/unbalance_response.hpp"
#include "scene/kit_machine.hpp"

namespace rubsweep::design {
namespace {

const std::vector<double> to_120_hz = batch::evenly_spaced(0.5, 120, 240);

/// A whirl whose diameter at resonance is nine tenths of what is allowed: a radius in place of either
/// diameter would leave a margin of 0.55 or -0.8.
TEST(ClearanceMargin, ComparesADiameterWithADiameter) {
  model::Machine machine = scene::one_side_machine();
  const double zeta = 0.02, largest = 1 / (2 * zeta * std::sqrt(1 - zeta * zeta));
  const double eccentricity_m = 0.9 * 0.75 * machine.stops[0].clearance_m / largest;
  const auto margins = clearance_margins(scene::prepare_machine(machine), eccentricity_m, to_120_hz);
  ASSERT_EQ(margins.size(), 1u);
  EXPECT_NEAR(margins[0].margin, 0.1, 1e-9);
  EXPECT_NEAR(margins[0].diametral_clearance_m, 2e-3, 1e-15);
  EXPECT_NEAR(margins[0].major_axis_m, 0.9 * 0.75 * 2e-3, 1e-12);
  EXPECT_NEAR(margins[0].speed_hz, 30 / std::sqrt(1 - 2 * zeta * zeta), 1e-4);
}

TEST(ClearanceMargin, OffsetAndWeightTakeFromTheClearance) {
  model::Machine machine = scene::one_side_machine();
  machine.stops[0].geometry = model::AnnularGeometry{{3e-4, 4e-4}};
  EXPECT_NEAR(clearance_margins(scene::prepare_machine(machine), 1e-6, to_120_hz)[0].diametral_clearance_m,
              1e-3, 1e-12);
  machine.stops[0].geometry = model::OneSideGeometry{-90};
  machine.stops[0].casing.reset();
  machine.gravity_m_per_s2 = 9.81;
  const double sag_m = 9.81 / std::pow(2 * std::numbers::pi * 30, 2);
  EXPECT_NEAR(clearance_margins(scene::prepare_machine(machine), 1e-6, to_120_hz)[0].diametral_clearance_m,
              2 * (1e-3 - sag_m), 1e-9);
  machine.gravity_m_per_s2 = 99;
  const ClearanceMargin pressed = clearance_margins(scene::prepare_machine(machine), 1e-6, to_120_hz)[0];
  EXPECT_EQ(pressed.diametral_clearance_m, 0);
  EXPECT_TRUE(std::isinf(pressed.margin) && pressed.margin < 0);
}

/// Two discs on supports of unequal stiffness: the left stop is tightest in the first mode, the right one in
/// the second.
model::Machine two_stops() {
  model::Machine machine = scene::light_shaft_machine();
  model::RotorKit& kit = *model::kit_of(machine);
  kit.discs[0].position_m = 0.05;
  kit.discs.push_back(kit.discs[0]);
  kit.discs[1].position_m = 0.35;
  kit.supports[0].stiffness_x_n_per_m = kit.supports[0].stiffness_y_n_per_m = 2e4;
  kit.supports[1].stiffness_x_n_per_m = kit.supports[1].stiffness_y_n_per_m = 2e5;
  kit.shaft[0].outer_diameter_m = 0.03;
  kit.modes = 4;
  machine.stops.front().position_m = 0.05;
  machine.stops.push_back(machine.stops.front());
  machine.stops.back().position_m = 0.35;
  return machine;
}

TEST(ClearanceMargin, EachStopIsLookedAtAtItsOwnSpeed) {
  const scene::PreparedMachine prepared = scene::prepare_machine(two_stops());
  const double eccentricity_m = 1e-5;
  const auto margins = clearance_margins(prepared, eccentricity_m, to_120_hz);
  ASSERT_EQ(margins.size(), 2u);
  const auto places = stop_places(prepared);
  const auto margin_at = [&](std::size_t stop, double hz) {
    return 1 - eccentricity_m * major_axis_at(unit_response(prepared, hz), places[stop]) / (0.75 * 2e-3);
  };
  for (std::size_t stop = 0; stop < 2; ++stop) {
    double smallest = 1;
    for (const double hz : batch::evenly_spaced(0.5, 120, 60001))
      smallest = std::min(smallest, margin_at(stop, hz));
    EXPECT_NEAR(margins[stop].margin, smallest, 1e-6) << stop;
  }
  EXPECT_GT(margins[1].speed_hz, 1.5 * margins[0].speed_hz);
  EXPECT_GT(margin_at(1, margins[0].speed_hz), margins[1].margin + 0.02) << "one speed for both hides it";
}

/// A bearing that pushes sideways makes the orbit lean: its shadow on x is shorter than its axis.
TEST(ClearanceMargin, TakesTheMajorAxisAndNotTheMotionAlongX) {
  model::Machine machine = scene::light_shaft_machine();
  for (model::Support& support : model::kit_of(machine)->supports)
    support.stiffness_xy_n_per_m = support.stiffness_yx_n_per_m = 1.2e4;
  const scene::PreparedMachine prepared = scene::prepare_machine(machine);
  const ClearanceMargin found = clearance_margins(prepared, 1e-6, to_120_hz)[0];
  const scene::QuietMotion motion = unit_response(prepared, found.speed_hz);
  const Eigen::Vector2cd there = stop_places(prepared)[0].map.cast<std::complex<double>>() * motion.amplitude;
  double farthest_m = 0;
  for (int k = 0; k < 3600; ++k) {
    const std::complex<double> turned = std::polar(1.0, 2 * std::numbers::pi * k / 3600);
    farthest_m = std::max(farthest_m, std::hypot((there(0) * turned).real(), (there(1) * turned).real()));
  }
  EXPECT_NEAR(found.major_axis_m, 2 * 1e-6 * farthest_m, 1e-5 * found.major_axis_m);
  EXPECT_GT(found.major_axis_m, 1.25 * 2 * 1e-6 * std::abs(there(0)));
}

}  // namespace
}  // namespace rubsweep::design
