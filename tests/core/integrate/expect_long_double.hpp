#pragma once

#include <gtest/gtest.h>

#include "rubsweep/core/integrate/hybrid_run.hpp"
#include "support/long_double_reference.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::integrate {

/// Compares the section after each turn with fixed steps in long double; returns the report of the last turn.
inline run::TurnReport expect_long_double(const test::OneSideRotor& rotor, int turns, int steps,
                                          double bound) {
  const auto reference = test::long_double_sections(rotor, turns, steps);
  exact::modes::ModeCache modes;
  const auto run = start_hybrid(test::cell_of(rotor).scene, {}, modes);
  run::TurnReport turn;
  for (int k = 1; k <= turns; ++k) {
    EXPECT_EQ(run.advance({}, turn), run::Outcome::ok);
    EXPECT_LT(test::section_error(turn.section, reference[static_cast<std::size_t>(k)], rotor), bound) << k;
  }
  return turn;
}

}  // namespace rubsweep::integrate
