#pragma once

#include "rubsweep/analysis/branch/continuation/branch_point.hpp"
#include "rubsweep/analysis/branch/curves/follow_curve.hpp"
#include "rubsweep/analysis/branch/orbits/scene_plane.hpp"

namespace rubsweep::test {

/// A two-parameter family of maps: `map(p, q, x)` is the image, `slope(p, q, x)` its derivative with respect
/// to x; both parameters range from -1 to 1.
template <class Map, class Slope>
branch::orbits::PlaneOrbits plain_plane(const Map& map, const Slope& slope) {
  branch::orbits::PlaneOrbits orbits;
  orbits.returns = [map, slope](const branch::orbits::PlanePoint& at, Eigen::VectorXd& x,
                                Eigen::MatrixXd* monodromy) {
    if (monodromy) *monodromy = slope(at.first, at.second, x);
    x = map(at.first, at.second, x);
    return branch::orbits::Evaluation::ok;
  };
  orbits.first = orbits.second = {-1, 1};
  return orbits;
}

/// A two-parameter family of maps with one coordinate.
template <class Map, class Slope>
branch::orbits::PlaneOrbits plain_plane_of_one_number(const Map& map, const Slope& slope) {
  return plain_plane(
      [map](double p, double q, const Eigen::VectorXd& x) {
        return Eigen::VectorXd(Eigen::VectorXd::Constant(1, map(p, q, x(0))));
      },
      [slope](double p, double q, const Eigen::VectorXd& x) {
        return Eigen::MatrixXd(Eigen::MatrixXd::Constant(1, 1, slope(p, q, x(0))));
      });
}

/// The same orbits with both parameters exchanged.
inline branch::orbits::PlaneOrbits exchanged(const branch::orbits::PlaneOrbits& orbits) {
  branch::orbits::PlaneOrbits other = orbits;
  other.returns = [orbits](const branch::orbits::PlanePoint& at, Eigen::VectorXd& x,
                           Eigen::MatrixXd* monodromy) {
    return orbits.returns({at.second, at.first, at.phase_rad}, x, monodromy);
  };
  other.first = orbits.second;
  other.second = orbits.first;
  return other;
}

/// The start of a curve of `kind`, searched near an orbit.
inline std::optional<branch::curves::CurveStart> start_near(const branch::orbits::PlaneOrbits& orbits,
                                                            branch::continuation::EventKind kind,
                                                            const Eigen::VectorXd& state, double p,
                                                            double q) {
  branch::continuation::BranchEvent event;
  event.kind = kind;
  event.point.state = state;
  return branch::curves::curve_start(orbits, event, {p, q, 0});
}

}  // namespace rubsweep::test
