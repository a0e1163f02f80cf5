#pragma once

#include <span>
#include <vector>

namespace rubsweep::recording {

/// Marks in a row, one for each turn.
struct TurnMarks {
  std::vector<double> t_s;
  int filled = 0;   ///< turns whose mark is missing: it was put between its neighbours
  int dropped = 0;  ///< marks too many
};

/// Tells turns without a mark, and marks without a turn; marks are known to `resolution_s`. Of all ways to
/// pass from mark to mark that one is taken whose intervals change least from one turn to the next, where a
/// mark that is passed over and a turn that has none cost as much as a change of the interval by a fourth: so
/// any number of marks too many is found among those that come once a turn, unless they come evenly, too.
TurnMarks numbered_marks(std::span<const double> marks_s, double resolution_s = 0);

}  // namespace rubsweep::recording
