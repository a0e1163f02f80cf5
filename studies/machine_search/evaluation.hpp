#pragma once

#include <vector>

#include "machine_search/candidate.hpp"
#include "machine_search/findings.hpp"

namespace rubsweep::machine_search {

/// Evaluation of the maps of one candidate.
struct Evaluation {
  std::vector<Mark> marks;  ///< of the maps that were computed
  double score = 0;         ///< of the marks
  bool complete = false;    ///< false: given up, because the rest could not lift the score to the bar
  double processor_s = 0;
};

/// How many grids there are to choose from.
inline constexpr std::size_t grid_count = 3;

/// Computes the five coarse maps in turn on one thread, on grid `grid` of them, and gives up as soon as full
/// marks in all that is left would not lift the score above `bar`. The marks depend on the candidate and the
/// grid alone.
Evaluation evaluate(const Candidate& candidate, std::size_t grid, double bar);

}  // namespace rubsweep::machine_search
