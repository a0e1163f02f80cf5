#pragma once

#include <Eigen/Core>

#include "rubsweep/analysis/branch/continuation/branch_point.hpp"
#include "rubsweep/analysis/branch/continuation/orbit_newton.hpp"
#include "rubsweep/analysis/branch/orbits/scene_plane.hpp"

namespace rubsweep::branch::curves {

/// Extended system of a codimension-one point of periodic orbits: the fixed-point equations and one
/// bifurcation condition. Its solutions are curves in the plane of two parameters. Its coordinates (Position)
/// are state / sqrt(states), for a graze the phase at which it touches, and both parameters, each divided by
/// the width of its range.
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
  continuation::EventKind kind = continuation::EventKind::fold;  ///< kind for which has_curve() is true
  Eigen::Index states = 0;
  orbits::ArmedGuard guard = {};  ///< guard that is grazed
  /// True: the orbit touches at all its phases at once, so that the graze has no definite phase
  /// (orbits::EvenContact).
  bool even = false;

  bool has_phase() const { return kind == continuation::EventKind::graze && !even; }
  Eigen::Index unknowns() const { return states + (has_phase() ? 3 : 2); }
};

/// Whether events of a kind form a curve in two parameters that can be followed.
bool has_curve(continuation::EventKind kind);

continuation::Position position_of(const ExtendedSystem& system, const orbits::PlanePoint& place,
                                   const Eigen::VectorXd& state);
orbits::PlanePoint place_of(const ExtendedSystem& system, const continuation::Position& at);
Eigen::VectorXd state_of(const ExtendedSystem& system, const continuation::Position& at);

/// Null vectors and normal form coefficients at a codimension-one point, needed to find meetings.
struct Critical {
  Eigen::VectorXd left, right;  ///< null vectors for the multiplier +-1, of arbitrary sign
  double quadratic = 0;    ///< left . second derivative along right; zero at a cusp; sign depends on left
  double cubic = 0;        ///< normal form coefficient of third order; its sign depends on `left` and `right`
  double pair_sum = 0;     ///< torus: 2 cos of the angle of its multipliers
  double curvature = 0;    ///< second derivative of a grazing guard
  double open_defect = 0;  ///< branch point: closing error of the orbit along `left`
};

/// Equations at the position `at`.
struct Extended {
  orbits::Evaluation evaluation = orbits::Evaluation::ok;  ///< if not ok, all other members are empty
  Eigen::VectorXd residual;                                ///< unknowns() - 1 numbers
  Eigen::MatrixXd jacobian;                                ///< derivative by the coordinates
  Eigen::MatrixXd monodromy;
  Critical critical;
};

/// Evaluates the equations. The rows of the closed orbit have exact derivatives by the state, and central
/// differences by parameters and phase. The row of the condition is left^T dM right with exact singular
/// vectors; dM are central differences of the exact monodromy matrix M. Since second derivatives are
/// symmetric, a single pair of differences along the right vector gives the derivatives by the whole state.
/// `difference_steps` > 0: step sizes as multiples of the usual ones.
Extended extend(const ExtendedSystem& system, const continuation::Position& at, double difference_steps = 1);

}  // namespace rubsweep::branch::curves
