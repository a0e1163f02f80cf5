#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <span>
#include <vector>

namespace rubsweep::response::motion {

/// Largest return error of a periodic section, in units of (clearance, clearance x omega).
inline constexpr double section_tolerance = 1e-5;

/// Turns in the window of order n: n floor(turns / n), as many whole periods as fit.
constexpr int window_turns(int turns, int order) { return order * (turns / order); }

struct SectionPeriod {
  int order = 0;        ///< the section returns after this many turns
  double residual = 0;  ///< largest return error over the window, in the unit of the rows
};

/// Period of the once-per-turn section. `rows` holds (turns + 1) x `states` numbers, row-major: row k is the
/// state k turns after the start of the window, with displacements divided by the clearance and velocities by
/// clearance x omega.
///
/// Returns the smallest n <= `max_order` for which |row(k + n) - row(k)| <= section_tolerance in the maximum
/// norm, for all k with both rows in the last window_turns(turns, n) turns. Orders whose window holds fewer
/// than two periods are skipped. Empty when no n returns or a number is not finite. Also empty when a smaller
/// order returns over the rows that decided for n. The longer window of the smaller order then began in a
/// transient that the window of n just misses, and n is not the period of the motion that follows.
/// SolverError when `rows` has another shape.
///
/// A slow approach to an orbit of k turns can look like a period of 2 k. With a multiplier m near -1,
/// sections 2 k turns apart differ by 1 - m^2 of the distance from the orbit, sections k turns apart by 1 -
/// m, a hundred times more. Therefore each divisor of n whose return error shrinks over the window is
/// extrapolated (`return_limit`). If the limit is a distance above zero, n is the period. If it is zero, the
/// divisor is the period, with the residual at the end. Otherwise no window decides, and the result is empty.
std::optional<SectionPeriod> period_of_section(std::span<const double> rows, int states, int max_order);

/// Sections of the last turns of a run that settles on a known order, to detect when it has settled.
class SectionReturns {
 public:
  /// `order` >= 1, in turns.
  explicit SectionReturns(int order) : order_(static_cast<std::size_t>(order)) {}

  /// Adds the section of one more turn. Returns whether it equals the section `order` turns ago within
  /// section_tolerance in the maximum norm.
  bool returned(const std::vector<double>& section);

 private:
  std::size_t order_;
  std::deque<std::vector<double>> sections_;
};

}  // namespace rubsweep::response::motion
