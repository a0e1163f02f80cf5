#pragma once

#include <Eigen/Core>
#include <complex>
#include <optional>
#include <vector>

#include "rubsweep/core/contact/contact_mode.hpp"
#include "rubsweep/core/contact/dry_friction.hpp"
#include "rubsweep/core/integrate/run/scaled_system.hpp"
#include "rubsweep/core/numerics/modal_form.hpp"

namespace rubsweep::integrate::exact {

/// A linear function of a motion in a sticking mode, with a direct term in the unbalance.
struct StickingView {
  double constant = 0;
  Eigen::RowVectorXd on_drift, on_drift_rate;  ///< rows of the sticking contacts
  std::complex<double> harmonic;               ///< Re(harmonic e^{i phase})
  Eigen::RowVectorXd on_free;                  ///< row on the free vibration's 2k modal numbers
  Eigen::RowVectorXd rate_on_free;             ///< row for the time derivative
  Eigen::RowVectorXd size, curvature;  ///< bounds of value, rate and second derivative, per length of a pair
};

/// A guard of a sticking mode: negative as long as the mode lasts.
struct StickingGuard {
  std::size_t contact = 0;
  StickingView view;
};

/// State of a motion in a sticking mode.
struct StickingMotion {
  double phase_rad = 0;
  Eigen::VectorXd free;  ///< 2k modal numbers
  Eigen::VectorXd drift,
      drift_rate;  ///< displacements along the tangents of the sticking contacts, and their rates
};

/// A joint mode of flat contacts, some of which stick by dry friction, in closed form. A sticking contact has
/// zero slip: along its tangent the motion has the constant speed of the surface, so that the vibration loses
/// one degree of freedom. Let R be the rows of the sliding speeds, B the accelerations by unit frictions, and
/// M = R B. Then u'' = -A u - C u' + f + B lambda and R u'' = 0 give
///
///     u = Q y + B M^-1 sigma,   R Q = 0,   sigma'' = 0,
///
/// where y is a linear vibration, forced by the unbalance, constant forces and the drift sigma. The friction
/// lambda = M^-1 R (A u + C u' - f) is a linear function of the motion. Units are scaled, time is in radians.
/// An annular stop in which the rotor sticks is replaced by a flat wall with normal n and tangent t. It
/// differs from a flat wall only for small changes of the motion: a change of the sticking place turns n and
/// t, and thus the directions of friction and normal force.
class StickingMode {
 public:
  using System = run::ScaledSystem<Eigen::Dynamic>;

  /// `modes`: mode of each contact; `sticks`: which of them stick; `ways`: sign of the slip of contacts with
  /// dry friction at its limit, otherwise 0. Sticking contacts must hold such contacts at zero slip, as on
  /// two walls with one tangent. Empty where the mode has no such closed form: the motion does not determine
  /// the frictions, no equilibrium, an undamped resonance, or nearly dependent vibrations. Forces of twice
  /// the shaft's frequency are not supported.
  static std::optional<StickingMode> make(const System& system, const std::vector<contact::Mode>& modes,
                                          const std::vector<bool>& sticks, const std::vector<double>& ways);

  const std::vector<StickingGuard>& guards() const { return guards_; }
  /// Normal forces of the touching contacts, in newtons.
  const std::vector<StickingView>& forces() const { return forces_; }
  /// Largest rate of the free vibration's pair `j`, per radian.
  double rate(Eigen::Index j) const { return rates_(j); }
  double growth() const { return form_ ? form_->growth : 0; }
  Eigen::Index pairs() const { return rates_.size(); }

  /// Sets the motion to `state` (u, u') at `phase_rad`.
  void begin(double phase_rad, const Eigen::Ref<const Eigen::VectorXd>& state, StickingMotion& motion) const;
  /// Moves the motion; `flows` has the flow of each pair, from `put_flows`.
  void move(double duration_rad, const std::vector<numerics::Pair>& flows, StickingMotion& motion) const;
  void put_flows(double duration_rad, std::vector<numerics::Pair>& flows) const;
  void put_state(const StickingMotion& motion, Eigen::Ref<Eigen::VectorXd> state) const;

  /// Moves tangent vectors of the state of `motion`, one per column, that do not let a sticking contact slip.
  void move_tangents(double duration_rad, const std::vector<numerics::Pair>& flows,
                     const StickingMotion& motion, Eigen::MatrixXd& tangents) const;

  /// View of a linear function of (u, u').
  StickingView view(const Eigen::RowVectorXd& by_u, const Eigen::RowVectorXd& by_v, double constant,
                    std::complex<double> direct) const;

 private:
  /// Adds the forces of the contacts to the system's matrices and stores the rows R of the `count` sticking
  /// contacts. Returns B.
  Eigen::MatrixXd take_contacts(const System& system, const std::vector<contact::Mode>& modes,
                                const std::vector<bool>& sticks, const std::vector<double>& ways,
                                Eigen::Index count);
  /// Solves the vibration y in the null space `q` of R; `to_y_` must be known, and `along` is B M^-1. False
  /// where the vibration has no closed form.
  bool solve_vibration(const Eigen::MatrixXd& q, const Eigen::MatrixXd& along);
  void move_free(const std::vector<numerics::Pair>& flows, Eigen::Ref<Eigen::VectorXd> free) const;
  Eigen::VectorXd by_turned_normal(const Eigen::MatrixXd& force, double duration_rad,
                                   const StickingMotion& motion) const;
  void add_guards(const System& system, const std::vector<contact::Mode>& modes,
                  const std::vector<bool>& sticks);
  void add_rings(const System& system, const std::vector<bool>& sticks, const Eigen::MatrixXd& along);

  /// A and C including the contacts, but without the friction of sticking contacts
  Eigen::MatrixXd stiffness_, damping_;
  Eigen::VectorXd constant_;
  Eigen::VectorXcd drive_;                    ///< drive by the unbalance: Re(drive e^{i phase})
  Eigen::MatrixXd rows_;                      ///< R, rows of the sliding speeds
  Eigen::MatrixXd hold_;                      ///< M^-1 R, with M = R B
  Eigen::MatrixXd to_y_;                      ///< maps u to y
  Eigen::MatrixXd on_drift_, on_drift_rate_;  ///< map sigma and sigma' to u
  Eigen::VectorXd rest_;
  Eigen::VectorXcd amplitude_;
  Eigen::MatrixXd basis_u_, basis_v_;        ///< map the modal numbers to u and u'
  std::optional<numerics::ModalForm> form_;  ///< modal form of y; empty where nothing is left to vibrate
  Eigen::VectorXd rates_;
  std::vector<StickingGuard> guards_;
  std::vector<StickingView> forces_;

  /// A sticking annular stop, in which the rotor is at the distance first_row u + offset from the centre. If
  /// its normal turns by an angle, angle * `change` * (accelerations without friction) is added.
  struct Ring {
    Eigen::Index held = 0;  ///< index among the sticking contacts
    Eigen::RowVectorXd first_row;
    double offset = 0;
    Eigen::MatrixXd change;
  };
  std::vector<Ring> rings_;
  Eigen::MatrixXd project_;  ///< maps accelerations without friction to those with it: I - B M^-1 R
};

/// Value and rate of a view for the present motion.
struct ValueAndRate {
  double value = 0, rate = 0;
};
ValueAndRate value_of(const StickingView& view, const StickingMotion& motion);

}  // namespace rubsweep::integrate::exact
