#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "rubsweep/core/integrate/law/dynamics.hpp"
#include "rubsweep/core/integrate/law/own_system.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::integrate::adaptive {

/// Terms that torsion adds to the right-hand side of a scene, in scaled units: lengths by L, time in radians
/// of the drive's rotation, the angle coordinate by L like all others. phi is the angle of the rotor, phi'
/// its rate (1 at the speed of the drive).
struct TwistLaw {
  Eigen::Index coordinate = 0;
  double length_m = 0;            ///< L: angle = L times the coordinate
  Eigen::VectorXcd unbalance;     ///< M^-1 U / L: accelerations Re(unbalance (phi'^2 - i phi'') e^{i phi})
  Eigen::VectorXcd lever;         ///< L U / J: phi'' is reduced by Re(i lever e^{i phi}) . (u'' - weight)
  Eigen::VectorXcd bow;           ///< M^-1 b / (L speed^2): accelerations Re(bow e^{i phi}); empty: none
  Eigen::VectorXcd bow_lever;     ///< L b / (J speed^2): phi'' is increased by Re(i bow_lever e^{i phi}) . u
  Eigen::MatrixXd gyroscopic;     ///< M^-1 G: accelerations -(phi' - 1) gyroscopic u'; empty: none
  Eigen::MatrixXd circulatory;    ///< M^-1 C / speed: accelerations -(phi' - 1) circulatory u; empty: none
  double inertia_share = 1;       ///< polar inertia without the eccentric masses / J, which includes them
  double angle_per_nm = 0;        ///< 1 / (J speed^2): phi'' per newton metre
  double drive_stiffness_nm = 0;  ///< torque per radian of twist
  double drive_damping_nm = 0;    ///< torque per unit of the twist's rate
  std::vector<double> contact_radius_m;
};

TwistLaw twist_law(const scene::Scene& scene);  ///< Torsion law of a scene.

/// The scene without the forces that turn with the shaft, which are part of the torsion law.
scene::Scene without_turning(scene::Scene scene);

/// Twist and torque in the drive at one state, with their rates per radian of the drive's rotation. The angle
/// is positive where the rotor leads its drive; the torque, from rotor to drive, then is positive too.
struct TwistState {
  double angle_rad = 0, angle_rate = 0, torque_nm = 0, torque_rate = 0;
};

/// Right-hand side of a scene with torsion, for AdaptiveRun; the scene of its system must have no force that
/// turns with the shaft. From the energies, with the unbalance U and R = Re(i U e^{i phi}):
///
///     M q'' = ... + Re(U (phi'^2 - i phi'') e^{i phi}) + Re(bow e^{i phi}),
///     J phi'' = -k angle - c angle' - R . (q'' - g) + Re(i bow e^{i phi}) . q - sum of radius * friction,
///
/// J includes the eccentric masses; g is the acceleration by constant forces. Both equations contain both
/// accelerations; their coupling has rank one, so that phi'' follows in closed form. The slip of the rubbing
/// surfaces, gyroscopic moments and rotating damping depend on phi'. The torque of that damping on the shaft
/// is neglected, because it is of second order in the deflection.
template <bool Smoothed>
class TwistDynamics : private law::OwnSystem<Eigen::Dynamic>, public law::Dynamics<Eigen::Dynamic, Smoothed> {
  using Base = law::Dynamics<Eigen::Dynamic, Smoothed>;

 public:
  TwistDynamics(const run::ScaledSystem<Eigen::Dynamic>& system, double smoothing_width, TwistLaw law)
      : OwnSystem(system), Base(OwnSystem::own, smoothing_width), law_(std::move(law)) {
    for (const auto& contact : system.contacts) surface_m_per_s_.push_back(contact.surface_speed_m_per_s);
  }

  template <class State>
  void operator()(const State& state, State& rate, double phase) {
    set_surface_speeds(state);
    Base::operator()(state, rate, phase);
    const Eigen::Index n = OwnSystem::own.coordinates();
    const typename Base::ConstMap u(&state[0], n), v(&state[0] + n, n);
    typename Base::Map acceleration(&rate[0] + n, n);
    const double speed = shaft_speed(state), angle = phase + law_.length_m * u(law_.coordinate);
    const double cosine = std::cos(angle), sine = std::sin(angle);
    acceleration += (speed * speed) * turned(law_.unbalance, cosine, sine);
    if (law_.bow.size() > 0) acceleration += turned(law_.bow, cosine, sine);
    if (law_.gyroscopic.size() > 0) acceleration.noalias() -= (speed - 1) * (law_.gyroscopic * v);
    if (law_.circulatory.size() > 0) acceleration.noalias() -= (speed - 1) * (law_.circulatory * u);

    // i e^{i phi} is e^{i phi} turned by a quarter turn.
    const Eigen::VectorXd lever = turned(law_.lever, -sine, cosine),
                          push = turned(law_.unbalance, -sine, cosine);
    double torsional = law_.inertia_share * law_.length_m * acceleration(law_.coordinate) -
                       lever.dot(acceleration - OwnSystem::own.constant) + contact_torque(state);
    if (law_.bow.size() > 0) torsional += turned(law_.bow_lever, -sine, cosine).dot(u);
    torsional /= 1 - lever.dot(push);
    acceleration -= torsional * push;
    acceleration(law_.coordinate) = torsional / law_.length_m;
  }

  template <class State>
  double slip_m_per_s(std::size_t i, const State& state) const {
    return Base::slip_m_per_s(i, state) - OwnSystem::own.contacts[i].surface_speed_m_per_s +
           shaft_speed(state) * surface_m_per_s_[i];
  }

  template <class State>
  double friction_ratio(const State& state) {
    set_surface_speeds(state);
    return Base::friction_ratio(state);
  }

  /// Jacobian as in Dynamics, by central differences. They are exact to rounding except for the terms with
  /// rotation and friction.
  template <class State, class Jacobian>
  void jacobian(const State& state, Jacobian&& j, double phase, State& phase_rate) {
    constexpr double nudge = 1e-6;
    const std::size_t size = 2 * static_cast<std::size_t>(OwnSystem::own.coordinates());
    State moved = state, ahead = state, behind = state;
    for (std::size_t column = 0; column < size; ++column) {
      const double step = nudge * std::max(1.0, std::abs(state[column]));
      moved[column] = state[column] + step;
      (*this)(moved, ahead, phase);
      moved[column] = state[column] - step;
      (*this)(moved, behind, phase);
      moved[column] = state[column];
      for (std::size_t row = 0; row < size; ++row) j(row, column) = (ahead[row] - behind[row]) / (2 * step);
    }
    (*this)(state, ahead, phase + nudge);
    (*this)(state, behind, phase - nudge);
    for (std::size_t row = 0; row < size; ++row) phase_rate[row] = (ahead[row] - behind[row]) / (2 * nudge);
  }

  /// Twist and torque at a state and its rate.
  template <class State>
  TwistState twist(const State& state, const State& rate) const {
    const auto c = static_cast<std::size_t>(law_.coordinate),
               n = static_cast<std::size_t>(OwnSystem::own.coordinates());
    TwistState twist;
    twist.angle_rad = law_.length_m * state[c];
    twist.angle_rate = law_.length_m * state[n + c];
    const double bend = law_.length_m * rate[n + c];
    twist.torque_nm = law_.drive_stiffness_nm * twist.angle_rad + law_.drive_damping_nm * twist.angle_rate;
    twist.torque_rate = law_.drive_stiffness_nm * twist.angle_rate + law_.drive_damping_nm * bend;
    return twist;
  }

 private:
  /// Re(load e^{i phi}).
  static Eigen::VectorXd turned(const Eigen::VectorXcd& load, double cosine, double sine) {
    return load.real() * cosine - load.imag() * sine;
  }

  /// Rate phi' of the rotor's angle.
  template <class State>
  double shaft_speed(const State& state) const {
    const Eigen::Index n = OwnSystem::own.coordinates();
    return 1 + law_.length_m * state[static_cast<std::size_t>(n + law_.coordinate)];
  }

  template <class State>
  void set_surface_speeds(const State& state) {
    const double speed = shaft_speed(state);
    for (std::size_t i = 0; i < surface_m_per_s_.size(); ++i)
      OwnSystem::own.contacts[i].surface_speed_m_per_s = speed * surface_m_per_s_[i];
  }

  /// Contribution of the friction at the surfaces to phi''.
  template <class State>
  double contact_torque(const State& state) const {
    double torque_nm = 0;
    for (std::size_t i = 0; i < surface_m_per_s_.size(); ++i)
      torque_nm -= law_.contact_radius_m[i] * Base::friction_n(i, state);
    return law_.angle_per_nm * torque_nm;
  }

  TwistLaw law_;
  std::vector<double> surface_m_per_s_;  ///< surface speed at the speed of the drive
};

}  // namespace rubsweep::integrate::adaptive
