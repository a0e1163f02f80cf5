#pragma once

#include <span>
#include <vector>

namespace rubsweep::recording {

/// The mark on the shaft as its probe sees it.
enum class Mark {
  dark,   ///< the signal falls below the threshold while the mark passes: a keyway before a proximity probe
  bright  ///< it rises above: a reflecting strip, a key
};

/// Threshold half way between the tenth of a per cent of the lowest and of the highest values. Throws
/// ConfigError for a signal that does not change.
double middle_threshold(std::span<const double> signal);

/// Instants at which the leading edge of the mark passes, in seconds, between samples by a straight line.
/// `t_s` rises. The mark is left, and the next one counts, once the signal is back beyond the threshold by
/// `hysteresis` (>= 0, in units of the signal). Samples that are NaN are passed over: an edge across such a
/// gap does not count.
std::vector<double> mark_times_s(std::span<const double> t_s, std::span<const double> signal, Mark mark,
                                 double threshold, double hysteresis);

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
