#pragma once

#include <span>
#include <vector>

namespace rubsweep::recording {

/// Signal of the mark on the shaft when it passes its probe.
enum class Mark {
  dark,   ///< the signal falls below the threshold, as for a keyway at a proximity probe
  bright  ///< the signal rises above the threshold, as for a reflecting strip or a key
};

/// Threshold halfway between the 0.1 % and the 99.9 % quantile of the finite values of the signal. Throws
/// ConfigError for a signal that does not change.
double middle_threshold(std::span<const double> signal);

/// Instants in seconds at which the leading edge of the mark passes, interpolated linearly between samples.
/// `t_s` ascends. The next mark is looked for once the signal is back beyond the threshold by `hysteresis`
/// (>= 0, in units of the signal). NaN are skipped: an edge across such a gap does not count.
std::vector<double> mark_times_s(std::span<const double> t_s, std::span<const double> signal, Mark mark,
                                 double threshold, double hysteresis);

/// Consecutive marks, one per turn.
struct TurnMarks {
  std::vector<double> t_s;
  int filled = 0;   ///< number of turns whose mark was missing and is interpolated
  int dropped = 0;  ///< number of surplus marks
};

/// Finds turns without a mark, and surplus marks. Marks are known to `resolution_s`. Of all sequences of
/// marks it chooses the one whose intervals change least from turn to turn. A surplus mark, or a missing one,
/// costs as much as a change of the interval by a quarter. If marks come once per turn, any number of surplus
/// marks is found, unless the surplus marks also come at regular intervals.
TurnMarks numbered_marks(std::span<const double> marks_s, double resolution_s = 0);

}  // namespace rubsweep::recording
