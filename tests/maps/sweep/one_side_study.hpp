#pragma once

#include <utility>
#include <vector>

#include "core/scene/one_side_machine.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::sweep {

/// A sweep of the one-side machine that settles quickly: short windows, coarse samples.
inline Study one_side_study(std::vector<double> speed_hz, std::vector<double> whirl_ratio) {
  Study study;
  study.machine = scene::one_side_machine();
  study.grid.speed_hz = std::move(speed_hz);
  study.grid.unbalance = std::move(whirl_ratio);
  study.response = {
      .max_revolutions = 40, .samples_per_revolution = 32, .window_revolutions = 12, .max_order = 6};
  return study;
}

}  // namespace rubsweep::sweep
