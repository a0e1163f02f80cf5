#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "rubsweep/core/response/spectrum/full_spectrum.hpp"

namespace rubsweep::response {

/// How near a once-per-turn section comes to returning.
struct ClosestReturn {
  int order = 0;        ///< n of the smallest mean square distance between rows n turns apart
  double distance = 0;  ///< root of that mean square, in the unit of the rows
  double rate = 0;  ///< rate at which the distance grows, per turn; negative: the motion is still settling
  double rate_error_bar = 0;  ///< half-width of the 99 % confidence interval of `rate`
};

/// Nearest return over all orders 1..max_order. `rows` as `period_of_section` takes them. On a torus the
/// distance stays, towards a periodic motion it decays at the rate of the slowest multiplier, whatever else
/// moves: it shows a weak modulation that dies out long before the exponent does. The rate is the slope of
/// ln(distance) over 8 successive blocks by least squares, its bar t s(slope) with t = 3.7074 (Student, 6
/// degrees of freedom); both are NaN when a block returns exactly. SolverError when `rows` has no such shape
/// or fewer than max_order + 16 turns.
ClosestReturn closest_return(std::span<const double> rows, int states, int max_order);

/// A section that returns closer than this, in units of the clearance, is not known to be a torus.
inline constexpr double significant_return = 1e-4;
/// Rate per turn at which the closest return grows or shrinks that counts as zero, whatever its bar: 5 % in
/// 2560 turns.
inline constexpr double zero_rate = 2e-5;

/// Allowed relative difference of the mean square of a torus's sections between both halves, of 80 turns or
/// more: 3 % on the maps of figures 6, 9 and 12.
inline constexpr double steady_share = 0.1;

/// A motion turn by turn, and how a disturbance of it grows.
struct Followed {
  std::size_t states = 0;
  std::vector<double> rows;           ///< sections after turns 1, 2, ..., in units of the clearance
  std::vector<double> contributions;  ///< contributions to the exponent, one per turn
  int turns_without_contact = 0;      ///< the last ones

  std::size_t turns() const { return contributions.size(); }
  void add(std::span<const double> section, double contribution, bool touched);
  std::span<const double> last_rows(std::size_t count) const { return std::span(rows).last(count * states); }
};

/// Whether the last four fifths of the turns look like a torus: the closest return within window / 2 turns is
/// significant and neither grows nor shrinks, by a rate that is known to within `known_rate` per turn, and
/// both halves are as large (`steady_share`) and hold the same discrete lines. `observed` (2 x states / 2)
/// maps displacements to (x, y). Says nothing about the exponent.
bool returns_like_a_torus(const Followed& motion, const Eigen::Matrix<double, 2, Eigen::Dynamic>& observed,
                          int window, double known_rate, spectrum::SpectrumWorkspace& workspace);

/// Whether successive sections, such as those of a window that numbers are measured in, are of the motion
/// that the last four fifths of the turns show: in the mean they lie as near to those as the last ones of as
/// many turns do to the others, within a factor of four, or nearer than a hundredth of a clearance. True
/// where these are too few to tell.
bool belongs_to(const Followed& motion, std::span<const double> sections);

}  // namespace rubsweep::response
