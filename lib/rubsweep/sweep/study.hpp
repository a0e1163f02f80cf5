#pragma once

#include <functional>
#include <optional>
#include <span>

#include "rubsweep/integrate/run/options.hpp"
#include "rubsweep/model/machine.hpp"
#include "rubsweep/response/motion/options.hpp"
#include "rubsweep/sweep/grid.hpp"
#include "rubsweep/sweep/threshold.hpp"

namespace rubsweep::sweep {

/// Whether each cell is run twice more to tell how firmly it holds its class (see is_robust).
enum class Robustness { off, on };

/// Everything that decides the numbers of a map: never paths, threads or times.
struct Study {
  model::Machine machine;
  Grid grid;
  integrate::run::SolverOptions solver;
  response::motion::ResponseOptions response;
  Robustness robustness = Robustness::off;
  std::optional<ThresholdScan> threshold{};  ///< each cell is also asked after which of these numbers it rubs
  /// This study with other numbers under some of its keys, and with a grid that says nothing. Throws
  /// ConfigError where they are not allowed. Whoever reads the study fills it, and leaves it empty where
  /// nothing varies keys. Threads may share it.
  std::function<Study(std::span<const KeyValue>)> with_keys{};
};

}  // namespace rubsweep::sweep
