#pragma once

#include <complex>
#include <vector>

#include "rubsweep/maps/config/run_config.hpp"
#include "shared/cell_argument.hpp"

namespace rubsweep::apps {

/// Settled motion of the cell for the comparison: one period of it.
struct SimulatedMotion {
  std::vector<std::complex<double>> period_m;
  int turns = 1;
};

/// Runs the cell until its motion has settled. Throws ConfigError where the motion does not repeat.
SimulatedMotion simulate(const config::RunConfig& config, const CellArgument& cell);

}  // namespace rubsweep::apps
