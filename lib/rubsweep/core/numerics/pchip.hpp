#pragma once

#include <vector>

namespace rubsweep::numerics {

/// Piecewise cubic through points, without extrema between them. Slopes are by Fritsch and Butland (SIAM J.
/// Sci. Stat. Comput. 5, 1984): the weighted harmonic mean of the secants beside a point, or 0 where their
/// signs differ. At both ends the three-point formula is limited so that the curve stays monotone (as `pchip`
/// of SLATEC). The first derivative is continuous. Unlike boost::math::interpolators::pchip, two or three
/// points are allowed, and the ends are of second order.
class Pchip {
 public:
  /// x strictly ascending, as many y as x, at least one of each. One point gives a constant.
  Pchip(std::vector<double> x, std::vector<double> y);

  /// Value at x, exactly y at a given point; beyond the ends the value of the end. Never allocates memory.
  double operator()(double x) const;
  double slope(double x) const;  ///< Derivative at x; beyond the ends the derivative of the end.

 private:
  struct Place {
    std::size_t piece;
    double share;  ///< share of the piece's width, 0 to 1
  };
  Place place_of(double x) const;

  std::vector<double> x_, y_, slope_;
};

}  // namespace rubsweep::numerics
