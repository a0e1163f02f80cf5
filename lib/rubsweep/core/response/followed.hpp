#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "rubsweep/core/response/spectrum/full_spectrum.hpp"

namespace rubsweep::response {

/// Return of a once-per-turn section that comes closest to an exact return.
struct ClosestReturn {
  int order = 0;        ///< n with the smallest mean square distance between rows n turns apart
  double distance = 0;  ///< root of that mean square, in the unit of the rows
  double rate = 0;      ///< rate at which the distance grows, per turn; negative: the motion still settles
  double rate_error_bar = 0;  ///< half-width of the 99 % confidence interval of `rate`
};

/// Closest return over all orders 1..max_order, with `rows` as for `period_of_section`. On a torus the
/// distance stays constant; towards a periodic motion it decays at the rate of the slowest multiplier. A
/// weak, decaying modulation therefore shows here long before it shows in the exponent. The rate is the slope
/// of ln(distance) over 8 successive blocks by least squares, its error bar t s(slope) with t = 3.7074
/// (Student, 6 degrees of freedom); both are NaN when a block returns exactly. SolverError when `rows` has
/// another shape or fewer than max_order + 16 turns.
ClosestReturn closest_return(std::span<const double> rows, int states, int max_order);

/// Smallest distance, in clearances, at which a section that does not return exactly may be a torus.
inline constexpr double significant_return = 1e-4;
/// Rate per turn of the closest return that counts as zero, whatever its error bar: 5 % in 2560 turns.
inline constexpr double zero_rate = 2e-5;

/// Allowed relative difference between the mean squares of a torus's sections in two halves of at least 80
/// turns. It is 3 % on the maps of figures 6, 9 and 12.
inline constexpr double steady_share = 0.1;

/// A motion turn by turn, with the growth of a disturbance.
struct Followed {
  std::size_t states = 0;
  std::vector<double> rows;           ///< sections after turns 1, 2, ..., in units of the clearance
  std::vector<double> contributions;  ///< contributions to the exponent, one per turn
  int turns_without_contact = 0;      ///< number of turns without contact at the end

  std::size_t turns() const { return contributions.size(); }
  void add(std::span<const double> section, double contribution, bool touched);
  std::span<const double> last_rows(std::size_t count) const { return std::span(rows).last(count * states); }
};

/// Whether the last four fifths of the turns look like a torus. The closest return within window / 2 turns
/// must be significant, and its rate must be zero and known to within `known_rate` per turn. Both halves must
/// be equally large (`steady_share`) and have the same discrete lines. `observed` (2 x states / 2) maps
/// displacements to (x, y). The exponent is not checked.
bool returns_like_a_torus(const Followed& motion, const Eigen::Matrix<double, 2, Eigen::Dynamic>& observed,
                          int window, double known_rate, spectrum::SpectrumWorkspace& workspace);

/// Whether successive sections (such as a measuring window) belong to the motion of the last four fifths of
/// the turns. The mean distance between sections and motion is compared with that between the last turns (as
/// many as there are sections) and the other turns. The ratio must be within a factor of four, or the first
/// distance below a hundredth of a clearance. True where there are too few turns for a comparison.
bool belongs_to(const Followed& motion, std::span<const double> sections);

}  // namespace rubsweep::response
