#pragma once

#include <vector>

#include "machine_search/candidate.hpp"
#include "machine_search/findings.hpp"

namespace rubsweep::machine_search {

/// Evaluation of the maps of one candidate.
struct Evaluation {
  std::vector<Mark> marks;  ///< of the maps that were computed
  double score = 0;         ///< sum of the marks
  bool complete = false;    ///< false: given up, because the rest could not lift the score to the bar
  double processor_s = 0;
};

/// Computes the five coarse maps in turn, on one thread, and gives up as soon as full marks in all that is
/// left would not lift the score above `bar`,
/// or when a map shows too little for the next to be worth its time. The marks depend on the candidate alone.
Evaluation evaluate(const Candidate& candidate, double bar);

}  // namespace rubsweep::machine_search
