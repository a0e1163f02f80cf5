#pragma once

#include <vector>

#include "rubsweep/integrate/run/options.hpp"
#include "rubsweep/model/machine.hpp"
#include "rubsweep/response/motion/options.hpp"

namespace rubsweep::sweep {

/// What the second axis of the map holds.
enum class UnbalanceMeasure {
  whirl_ratio,    ///< largest normal excursion of the quiet motion / remaining clearance at the first stop
  eccentricity_m  ///< e of the disc, in metres
};

/// Grid of cells. Speeds in Hz, strictly > 0; unbalance values >= 0 in the unit of `measure`.
struct Grid {
  std::vector<double> speed_hz;
  UnbalanceMeasure measure = UnbalanceMeasure::whirl_ratio;
  std::vector<double> unbalance;
};

/// Whether each cell is run twice more to tell how firmly it holds its class (see is_robust).
enum class Robustness { off, on };

/// Everything that decides the numbers of a map: never paths, threads or times.
struct Study {
  model::Machine machine;
  Grid grid;
  integrate::run::SolverOptions solver;
  response::motion::ResponseOptions response;
  Robustness robustness = Robustness::off;
};

}  // namespace rubsweep::sweep
