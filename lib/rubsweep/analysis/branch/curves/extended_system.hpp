#pragma once

#include <Eigen/Core>

#include "rubsweep/analysis/branch/continuation/branch_point.hpp"
#include "rubsweep/analysis/branch/continuation/orbit_newton.hpp"
#include "rubsweep/analysis/branch/orbits/scene_plane.hpp"

namespace rubsweep::branch::curves {

/// Extended system of a codimension-one point of periodic orbits: the fixed-point equations and one
/// bifurcation condition more, so that its solutions are curves in the plane of two parameters. Their
/// coordinates (Position) are state / sqrt(states), of a graze then the phase at which it touches, and both
/// parameters, each divided by the width of its range.
///
/// | kind | condition |
/// |---|---|
/// | fold, period doubling | smallest singular value of M - 1, of M + 1 |
/// | torus | product of the two multipliers whose product is nearest to 1, less 1 |
/// | branch point | as a fold, and a second derivative in place of the equation that says nothing there |
/// | graze | at the start of the turn the guard is as good as zero, and so is its rate |
/// | graze of an even contact | the guard alone, of orbits that are clear of the contact |
struct ExtendedSystem {
  const orbits::PlaneOrbits* orbits = nullptr;                   ///< never null
  continuation::EventKind kind = continuation::EventKind::fold;  ///< a kind that has_curve()
  Eigen::Index states = 0;
  orbits::ArmedGuard guard = {};  ///< guard that is grazed
  bool even = false;  ///< grazed everywhere at once, so that no phase belongs to it (orbits::EvenContact)

  bool has_phase() const { return kind == continuation::EventKind::graze && !even; }
  Eigen::Index unknowns() const { return states + (has_phase() ? 3 : 2); }
};

/// Whether a kind of event goes on as a curve in two parameters, and is followed as one.
bool has_curve(continuation::EventKind kind);

continuation::Position position_of(const ExtendedSystem& system, const orbits::PlanePoint& place,
                                   const Eigen::VectorXd& state);
orbits::PlanePoint place_of(const ExtendedSystem& system, const continuation::Position& at);
Eigen::VectorXd state_of(const ExtendedSystem& system, const continuation::Position& at);

/// Null vectors and normal form coefficients at a codimension-one point, for tests of meetings.
struct Critical {
  Eigen::VectorXd left, right;  ///< null vectors of the multiplier +-1; their signs mean nothing
  double quadratic = 0;    ///< left . second derivative along right; zero at a cusp. Its sign is that of left
  double cubic = 0;        ///< coefficient of the normal form behind it; its sign is that of left times right
  double pair_sum = 0;     ///< torus: 2 cos of the angle of its multipliers
  double curvature = 0;    ///< curvature of a grazing guard
  double open_defect = 0;  ///< branch point: how far the orbit is from closing along `left`
};

/// The equations at `at`.
struct Extended {
  orbits::Evaluation evaluation = orbits::Evaluation::ok;  ///< all else is empty where it is not ok
  Eigen::VectorXd residual;                                ///< unknowns() - 1
  Eigen::MatrixXd jacobian;                                ///< derivative by the coordinates
  Eigen::MatrixXd monodromy;
  Critical critical;
};

/// Rows of the closing orbit: exact derivatives by the state, central differences by parameters and phase.
/// The row of the condition: exact left and right vectors, between which central differences of the exact
/// monodromy matrix stand; second derivatives are symmetric, so that one pair of differences, along the right
/// vector, gives the derivatives by the whole state. `difference_steps` > 0: in shares of the usual ones.
Extended extend(const ExtendedSystem& system, const continuation::Position& at, double difference_steps = 1);

}  // namespace rubsweep::branch::curves
