#pragma once

#include <Eigen/Core>

#include "rubsweep/core/integrate/law/dynamics.hpp"
#include "rubsweep/core/integrate/run/options.hpp"
#include "rubsweep/core/integrate/run/scaled_system.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::response::rotating {

/// A scaled state (or each of its 2n columns) after a rotation by `angle_rad` from +x to +y: each pair of
/// coordinates (x, y) and each pair of velocities rotates by this angle.
Eigen::MatrixXd turned(const Eigen::MatrixXd& state, double angle_rad);

/// Rate of a rotationally symmetric scene, without its pulses, in the rotating frame. With x' = f(x, phase)
/// for the scaled state x in the fixed frame, the state y = turned(x, -phase) follows
///
///     y' = f(y, 0) - turned(y, pi/2),
///
/// which does not depend on time. The velocities in y are those relative to the fixed frame, written in
/// rotating directions; they are not the derivatives of the displacements in y. States are scaled as
/// TurnReport::section, and rates are per radian of rotation.
class RotatingField {
 public:
  RotatingField(const scene::Scene& scene, const integrate::run::SolverOptions& options);

  RotatingField(const RotatingField&) = delete;
  RotatingField& operator=(const RotatingField&) = delete;

  /// Rate, 2n numbers; every contact is in the mode of the given state.
  Eigen::VectorXd rate(const Eigen::VectorXd& state) const;

  Eigen::MatrixXd jacobian(const Eigen::VectorXd& state) const;  ///< d(rate)/d(state), 2n x 2n.

  double contact_force_n(const Eigen::VectorXd& state) const;  ///< Largest normal force of a contact, in N.

  /// Largest distance of any casing from its unloaded position, in metres.
  double casing_displacement_m(const Eigen::VectorXd& state) const;

  bool touches(const Eigen::VectorXd& state) const;  ///< Whether some contact penetrates.

 private:
  /// Calls `visit(dynamics)` with the law that applies at `state`.
  template <class Visit>
  auto at(const Eigen::VectorXd& state, const Visit& visit) const;

  integrate::run::ScaledSystem<Eigen::Dynamic> system_;
  bool smoothed_;
  mutable integrate::law::Dynamics<Eigen::Dynamic, false> located_law_;
  mutable integrate::law::Dynamics<Eigen::Dynamic, true> smoothed_law_;
};

/// Whether the equations of motion do not depend on time in the rotating frame, apart from the pulse and the
/// initial state. Then every contact is a centred annular stop (offset exactly zero), no force or impulse has
/// a constant direction, the forcing turns forward, and structure and points are isotropic in pairs of
/// coordinates (x, y): every 2 x 2 block has the form [[a, -b], [b, a]].
bool rotationally_symmetric(const scene::Scene& scene);

}  // namespace rubsweep::response::rotating
