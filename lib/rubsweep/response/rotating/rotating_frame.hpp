#pragma once

#include <Eigen/Core>

#include "rubsweep/integrate/adaptive/dynamics.hpp"
#include "rubsweep/integrate/run/options.hpp"
#include "rubsweep/integrate/run/scaled_system.hpp"
#include "rubsweep/scene/scene.hpp"

namespace rubsweep::response::rotating {

/// A scaled state (or its 2n columns, each one) as seen after everything is turned by `angle_rad` from +x to
/// +y: every pair of coordinates (x, y), and every pair of velocities, turns alike.
Eigen::MatrixXd turned(const Eigen::MatrixXd& state, double angle_rad);

/// Rate of a rotationally symmetric scene, its pulse left out, in the frame that turns with the shaft:
/// states y = turned(x, -phase) of scaled states x follow y' = f(y, 0) - turned(y, pi/2), where x' = f(x,
/// phase), which does not depend on time. Velocities stay those of the fixed frame, only turned. States and
/// modes as in Turn::section, per radian.
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

  /// Some contact penetrates.
  bool touches(const Eigen::VectorXd& state) const;

 private:
  /// `visit(dynamics)` with the law in force at `state`.
  template <class Visit>
  auto at(const Eigen::VectorXd& state, const Visit& visit) const;

  integrate::run::ScaledSystem<Eigen::Dynamic> system_;
  bool smoothed_;
  mutable integrate::adaptive::Dynamics<Eigen::Dynamic, false> located_law_;
  mutable integrate::adaptive::Dynamics<Eigen::Dynamic, true> smoothed_law_;
};

}  // namespace rubsweep::response::rotating
