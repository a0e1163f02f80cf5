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

/// A linear function of a motion in a sticking mode, and of the unbalance directly.
struct StickingView {
  double constant = 0;
  Eigen::RowVectorXd on_drift, on_drift_rate;  ///< rows of the sticking contacts
  std::complex<double> harmonic;               ///< Re(harmonic e^{i phase})
  Eigen::RowVectorXd on_free;                  ///< row over the free vibration's 2k modal numbers
  Eigen::RowVectorXd rate_on_free;             ///< row for the rate
  Eigen::RowVectorXd size, curvature;  ///< bounds of both and of the second rate, per length of a pair
};

/// A guard: negative as long as the mode lasts.
struct StickingGuard {
  std::size_t contact = 0;
  StickingView view;
};

/// A motion in a sticking mode.
struct StickingMotion {
  double phase_rad = 0;
  Eigen::VectorXd free;  ///< 2k modal numbers
  Eigen::VectorXd drift,
      drift_rate;  ///< places along the tangents of the contacts that stick, and their rates
};

/// A joint mode of flat contacts of which some stick by dry friction, in closed form. A contact that sticks
/// keeps its slip at zero: along its tangent the motion has the constant speed of the surface, which takes
/// one direction away from the vibration. With rows R of the sliding speeds, pushes B of the frictions and M
/// = R B, u'' = -A u - C u' + f + B lambda and R u'' = 0 give
///
///     u = Q y + B M^-1 sigma,   R Q = 0,   sigma'' = 0,
///
/// where y is a linear vibration that unbalance, constant forces and the drift sigma force, and
/// lambda = M^-1 R (A u + C u' - f) is the friction, itself a linear function of the motion. Scaled units,
/// time in radians. A ring in whose mode the wall looks like a flat one, with its normal n and tangent t
/// where the rotor sticks, differs in small changes only: one that begins at another place turns n and t,
/// which changes the directions of friction and of normal force.
class StickingMode {
 public:
  using System = run::ScaledSystem<Eigen::Dynamic>;

  /// Mode of each contact, which of them stick, and the sign of the slip of those with dry friction at its
  /// limit, else 0; what sticks must keep the slip of these as it is, as on two walls of one tangent. Empty
  /// where the mode has no closed form of this kind: contacts whose frictions the motion does not determine,
  /// no equilibrium, an undamped resonance, vibrations that are nearly dependent. Nor is a force of twice the
  /// shaft's frequency part of the form.
  static std::optional<StickingMode> make(const System& system, const std::vector<contact::Mode>& modes,
                                          const std::vector<bool>& sticks, const std::vector<double>& ways);

  const std::vector<StickingGuard>& guards() const { return guards_; }
  /// Normal forces of the contacts that touch, newtons.
  const std::vector<StickingView>& forces() const { return forces_; }
  /// Largest rate of the free vibration's pair `j`, per radian.
  double rate(Eigen::Index j) const { return rates_(j); }
  double growth() const { return form_ ? form_->growth : 0; }
  Eigen::Index pairs() const { return rates_.size(); }

  /// The motion that is at `state` (u, u') at `phase_rad`.
  void begin(double phase_rad, const Eigen::Ref<const Eigen::VectorXd>& state, StickingMotion& motion) const;
  /// Moves it; `flows` has the flow of each pair, as of `put_flows`.
  void move(double duration_rad, const std::vector<numerics::Pair>& flows, StickingMotion& motion) const;
  void put_flows(double duration_rad, std::vector<numerics::Pair>& flows) const;
  void put_state(const StickingMotion& motion, Eigen::Ref<Eigen::VectorXd> state) const;

  /// Moves small changes of the state of `motion`, one a column, which do not let a sticking contact slip.
  void move_tangents(double duration_rad, const std::vector<numerics::Pair>& flows,
                     const StickingMotion& motion, Eigen::MatrixXd& tangents) const;

  /// A linear function of (u, u').
  StickingView view(const Eigen::RowVectorXd& by_u, const Eigen::RowVectorXd& by_v, double constant,
                    std::complex<double> direct) const;

 private:
  /// Takes the system with the forces of its contacts in, and the rows R of the `count` that stick. Their
  /// pushes B.
  Eigen::MatrixXd take_contacts(const System& system, const std::vector<contact::Mode>& modes,
                                const std::vector<bool>& sticks, const std::vector<double>& ways,
                                Eigen::Index count);
  /// Solves the vibration y in the null space `q` of R, `to_y_` being known and `along` = B M^-1. False where
  /// it has no closed form.
  bool solve_vibration(const Eigen::MatrixXd& q, const Eigen::MatrixXd& along);
  void move_free(const std::vector<numerics::Pair>& flows, Eigen::Ref<Eigen::VectorXd> free) const;
  Eigen::VectorXd by_turned_normal(const Eigen::MatrixXd& force, double duration_rad,
                                   const StickingMotion& motion) const;
  void add_guards(const System& system, const std::vector<contact::Mode>& modes,
                  const std::vector<bool>& sticks);
  void add_rings(const System& system, const std::vector<bool>& sticks, const Eigen::MatrixXd& along);

  Eigen::MatrixXd stiffness_, damping_;  ///< A and C, contacts included, those that stick without friction
  Eigen::VectorXd constant_;
  Eigen::VectorXcd drive_;                    ///< unbalance: Re(drive e^{i phase})
  Eigen::MatrixXd rows_;                      ///< R
  Eigen::MatrixXd hold_;                      ///< M^-1 R
  Eigen::MatrixXd to_y_;                      ///< y of u
  Eigen::MatrixXd on_drift_, on_drift_rate_;  ///< u of sigma and of sigma'
  Eigen::VectorXd rest_;
  Eigen::VectorXcd amplitude_;
  Eigen::MatrixXd basis_u_, basis_v_;        ///< u and u' of the modal numbers
  std::optional<numerics::ModalForm> form_;  ///< form of y; empty where nothing is left to vibrate
  Eigen::VectorXd rates_;
  std::vector<StickingGuard> guards_;
  std::vector<StickingView> forces_;

  /// A ring that holds the rotor, at the distance first_row u + offset from its centre. Where its normal is
  /// turned by an angle, the accelerations are changed by the angle times `change` times those without
  /// friction.
  struct Ring {
    Eigen::Index held = 0;  ///< number among the contacts that stick
    Eigen::RowVectorXd first_row;
    double offset = 0;
    Eigen::MatrixXd change;
  };
  std::vector<Ring> rings_;
  Eigen::MatrixXd project_;  ///< accelerations without friction to those with it: I - B M^-1 R
};

/// Value and rate of a view where the motion is.
struct ValueAndRate {
  double value = 0, rate = 0;
};
ValueAndRate value_of(const StickingView& view, const StickingMotion& motion);

}  // namespace rubsweep::integrate::exact
