#pragma once

#include <utility>
#include <vector>

#include "rubsweep/maps/sweep/study.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::test {

/// A small map around the half orbit of parameter set A, which exists from 61.6 to 90.9 Hz at a whirl ratio
/// of 0.4.
inline sweep::Study half_orbit_study(std::vector<double> whirl_ratios) {
  sweep::Study study;
  study.machine = machine_of({});
  study.grid.speed_hz = {55, 65, 75, 85, 95};
  study.grid.unbalance = std::move(whirl_ratios);
  return study;
}

}  // namespace rubsweep::test
