#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "rubsweep/core/integrate/run/options.hpp"
#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/core/response/motion/options.hpp"
#include "rubsweep/core/vocabulary.hpp"
#include "rubsweep/maps/sweep/basin_sampling.hpp"
#include "rubsweep/maps/sweep/grid.hpp"
#include "rubsweep/maps/sweep/threshold.hpp"

namespace rubsweep::sweep {

/// Further runs of each cell with slightly different kicks, which test whether it keeps its class (see
/// is_robust and robust_share).
enum class Robustness { off, on, probability };
inline constexpr auto robustness_words = words_of<Robustness>();

/// Neighbouring kicks for Robustness::probability.
struct Neighbours {
  int count = 8;       ///< even: half of them weaker, half stronger
  double part = 0.01;  ///< largest relative change of the force, in (0, 1)

  static void visit_fields(auto& self, auto&& visit) {
    using model::newer_key;
    visit("robustness_neighbours", self.count,
          newer_key(model::IntegerRange{2, 1000, true}, "how many other kicks, half of them weaker"));
    visit("robustness_part", self.part,
          newer_key(model::Range{.low = 0, .high = 1, .low_open = true, .high_open = true},
                    "largest relative change of the force"));
  }
};

/// Everything that decides the numbers of a map, and names. It has no paths, threads or times.
struct Study {
  model::Machine machine;
  std::vector<std::string>
      stop_names{};  ///< names of the stops for messages, tables and figures; see name_at
  Grid grid;
  integrate::run::SolverOptions solver;
  response::motion::ResponseOptions response;
  Robustness robustness = Robustness::off;
  Neighbours neighbours{};
  /// If the forces of a cell leave the range of its Hertz secants, it is run again with secants at the force
  /// found, at most this many times; see with_hertz_iterations.
  int hertz_iterations = 0;
  std::optional<BasinSampling> basin{};      ///< starts for a count of attractors in each cell
  std::optional<ThresholdScan> threshold{};  ///< numbers for a search of thresholds of rub in each cell
  /// Makes this study with other numbers under some of its keys, and with an empty grid. Throws ConfigError
  /// where the numbers are not allowed. Set by the reader of the study; empty where nothing varies keys.
  /// Threads may share it.
  std::function<Study(std::span<const KeyValue>)> with_keys{};

  /// Visits the keys of `response` that follow those of ResponseOptions.
  static void visit_fields(auto& self, auto&& visit) {
    visit("robustness", self.robustness,
          model::key(robustness_words, "more runs of each cell with other kicks: two, or many"));
    Neighbours::visit_fields(self.neighbours, visit);
    visit(
        "hertz_iterations", self.hertz_iterations,
        model::newer_key(model::IntegerRange{0, 20},
                         "how often a cell whose force leaves the range of a hertz stiffness is run again"));
  }
};

}  // namespace rubsweep::sweep
