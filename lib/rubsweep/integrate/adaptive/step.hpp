#pragma once

namespace rubsweep::integrate::adaptive {

/// One attempted or accepted step of any method: from `start` to `end`, states and rates at both.
template <class State>
struct Step {
  double start_phase = 0, end_phase = 0;
  State start, start_rate, end, end_rate;
};

}  // namespace rubsweep::integrate::adaptive
