#include "rubsweep/analysis/branch/families/quiet_cells.hpp"

#include <gtest/gtest.h>

#include <variant>

#include "rubsweep/core/structure/stability.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::branch::families {
namespace {

/// The quiet whirl of a Jeffcott rotor of 30 Hz reaches the wall near its resonance alone.
TEST(QuietCells, TouchNearResonance) {
  sweep::Study study;
  study.machine = test::machine_of({});
  study.grid.measure = sweep::UnbalanceMeasure::eccentricity_m;
  study.grid.speed_hz = {10, 30, 90};
  study.grid.unbalance = {1e-6, 2e-4};
  using enum Quiet;
  EXPECT_EQ(quiet_cells(study), (std::vector<Quiet>{stable, stable, stable, stable, touches, stable}));
}

/// Damping that turns with the shaft makes the free rotor unstable above a speed.
TEST(QuietCells, AreUnstableAboveASpeed) {
  sweep::Study study;
  study.machine = test::machine_of({});
  std::get<model::JeffcottRotor>(study.machine.rotor).rotating_damping_ratio = 0.02;
  const auto prepared = scene::prepare_machine(study.machine);
  const auto from_hz = structure::instability_hz(prepared.assembly, 200);
  ASSERT_TRUE(from_hz);
  study.grid.speed_hz = {0.99 * *from_hz, 1.01 * *from_hz};
  study.grid.unbalance = {0.1};
  EXPECT_EQ(quiet_cells(study), (std::vector<Quiet>{Quiet::stable, Quiet::unstable}));
}

}  // namespace
}  // namespace rubsweep::branch::families
