#pragma once

#include <vector>

namespace rubsweep::integrate::adaptive {

/// State of a run, and its rate: coordinates, then their rates, then what a law adds.
using State = std::vector<double>;

/// One attempted or accepted step of any method: from `start` to `end`, states and rates at both.
struct Step {
  double start_phase = 0, end_phase = 0;
  State start, start_rate, end, end_rate;
};

}  // namespace rubsweep::integrate::adaptive
