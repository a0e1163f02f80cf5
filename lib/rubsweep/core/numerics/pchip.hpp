#pragma once

#include <vector>

namespace rubsweep::numerics {

/// Piecewise cubic through points that has no extremum between them: slopes by Fritsch and Butland (SIAM J.
/// Sci. Stat. Comput. 5, 1984), the weighted harmonic mean of the secants beside a point, 0 where these
/// differ in sign; at both ends the three-point formula, limited so that the curve stays monotone (as `pchip`
/// of SLATEC). Its first derivative is continuous. Unlike boost::math::interpolators::pchip it takes two or
/// three points too, and its ends are of second order.
class Pchip {
 public:
  /// x strictly ascending, as many y as x, at least one of each. One point is a constant.
  Pchip(std::vector<double> x, std::vector<double> y);

  /// The value at x, at a point exactly its y; beyond the ends that of the end. Never allocates.
  double operator()(double x) const;
  /// The derivative; beyond the ends that of the end.
  double slope(double x) const;

 private:
  struct Place {
    std::size_t piece;
    double share;  ///< share of the piece's width, 0 to 1
  };
  Place place_of(double x) const;

  std::vector<double> x_, y_, slope_;
};

}  // namespace rubsweep::numerics
