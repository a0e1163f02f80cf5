#pragma once

#include <Eigen/Core>

#include "rubsweep/core/integrate/law/dynamics.hpp"
#include "rubsweep/core/integrate/run/options.hpp"
#include "rubsweep/core/integrate/run/scaled_system.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::response::rotating {

/// A scaled state (or its 2n columns, each one) as seen after everything is turned by `angle_rad` from +x to
/// +y: every pair of coordinates (x, y), and every pair of velocities, turns alike.
Eigen::MatrixXd turned(const Eigen::MatrixXd& state, double angle_rad);

/// Rate of a rotationally symmetric scene, its pulses left out, in the frame that turns with the shaft. With
/// x' = f(x, phase) for the scaled state x in the fixed frame, the turned state y = turned(x, -phase) follows
///
///     y' = f(y, 0) - turned(y, pi/2),
///
/// which does not depend on time. The velocities in y are those seen from the fixed frame, written in turned
/// directions; they are not the derivatives of the displacements in y. States are scaled as
/// TurnReport::section, and rates are per radian of rotation.
class RotatingField {
 public:
  RotatingField(const scene::Scene& scene, const integrate::run::SolverOptions& options);

  RotatingField(const RotatingField&) = delete;
  RotatingField& operator=(const RotatingField&) = delete;

  /// 2n numbers; every contact in the mode that its state has.
  Eigen::VectorXd rate(const Eigen::VectorXd& state) const;

  /// d(rate)/d(state), 2n x 2n.
  Eigen::MatrixXd jacobian(const Eigen::VectorXd& state) const;

  /// Largest normal force at any one contact, in newtons.
  double contact_force_n(const Eigen::VectorXd& state) const;

  /// Largest distance of any casing from its unloaded place, in metres.
  double casing_displacement_m(const Eigen::VectorXd& state) const;

  /// Some contact penetrates.
  bool touches(const Eigen::VectorXd& state) const;

 private:
  /// `visit(dynamics)` with the law in force at `state`.
  template <class Visit>
  auto at(const Eigen::VectorXd& state, const Visit& visit) const;

  integrate::run::ScaledSystem<Eigen::Dynamic> system_;
  bool smoothed_;
  mutable integrate::law::Dynamics<Eigen::Dynamic, false> located_law_;
  mutable integrate::law::Dynamics<Eigen::Dynamic, true> smoothed_law_;
};

/// True when the equations of motion do not depend on time in the frame that turns with the shaft; the pulse
/// and the initial state are left aside. Every contact is then a centred annular stop (offset exactly zero),
/// nothing pulls or strikes in a constant direction, the forcing turns forward, and structure and points are
/// isotropic in pairs of coordinates (x, y): every 2 x 2 block has the form [[a, -b], [b, a]].
bool rotationally_symmetric(const scene::Scene& scene);

}  // namespace rubsweep::response::rotating
