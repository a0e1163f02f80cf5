#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <span>
#include <vector>

namespace rubsweep::response::motion {

/// A section that returns within this, in units of (clearance, clearance x omega), is periodic.
inline constexpr double section_tolerance = 1e-5;

/// Turns in the window of order n: n floor(turns / n), the whole periods that fit.
constexpr int window_turns(int turns, int order) { return order * (turns / order); }

struct SectionPeriod {
  int order = 0;        ///< the section returns after this many turns
  double residual = 0;  ///< largest return error over the window, in the unit of the rows
};

/// Period of the once-per-turn section. `rows` holds (turns + 1) x `states` numbers, row-major: row k is the
/// state k turns after the start of the window, displacements divided by the clearance, velocities by
/// clearance x omega.
///
/// Returns the smallest n <= `max_order` for which |row(k + n) - row(k)| <= section_tolerance in the maximum
/// norm for all k with both rows in the last window_turns(turns, n) turns. Orders whose window holds fewer
/// than two periods are not looked for. Empty when no n returns, when a number is not finite, and when a
/// smaller order returns over the rows that decided for n: then the window began in a transient, which the
/// shorter window of n just misses, and n says nothing about the motion behind it. SolverError when `rows`
/// has no such shape.
///
/// A slow approach to an orbit of fewer turns passes for n turns: where a multiplier m of an orbit of k turns
/// is near -1, sections 2 k turns apart differ by 1 - m^2 of the distance from the orbit, those k turns apart
/// by 1 - m, a hundred times more. A part of n (a divisor of it) whose return shrinks over the window is
/// therefore asked where it shrinks to (`return_limit`): to a distance of its own, and n stands; to nothing,
/// and the part is the order, its residual that of the end; anything between is decided by no window, and the
/// answer is empty.
std::optional<SectionPeriod> period_of_section(std::span<const double> rows, int states, int max_order);

/// Sections of the last turns of a run that settles on a known order, to see when it has.
class SectionReturns {
 public:
  /// `order` >= 1 turns.
  explicit SectionReturns(int order) : order_(static_cast<std::size_t>(order)) {}

  /// Takes in the section of one more turn. Whether it is that of `order` turns ago within section_tolerance,
  /// in the maximum norm.
  bool returned(const std::vector<double>& section);

 private:
  std::size_t order_;
  std::deque<std::vector<double>> sections_;
};

}  // namespace rubsweep::response::motion
