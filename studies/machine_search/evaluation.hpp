#pragma once

#include <vector>

#include "machine_search/candidate.hpp"
#include "machine_search/findings.hpp"

namespace rubsweep::machine_search {

/// Evaluation of the maps of one candidate.
struct Evaluation {
  std::vector<Mark> marks;  ///< marks of the computed maps
  double score = 0;         ///< score of the marks
  bool complete = false;    ///< false: given up, because full marks in the other maps would not reach the bar
  double processor_s = 0;
};

/// Number of grids to choose from.
inline constexpr std::size_t grid_count = 3;

/// Computes the five coarse maps on grid number `grid`, one after another on one thread. It gives up as soon
/// as full marks in the remaining maps would not raise the score above `bar`. The marks depend on the
/// candidate and the grid alone.
Evaluation evaluate(const Candidate& candidate, std::size_t grid, double bar);

}  // namespace rubsweep::machine_search
