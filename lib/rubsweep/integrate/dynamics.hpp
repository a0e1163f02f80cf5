#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "rubsweep/contact/contact_mode.hpp"
#include "rubsweep/contact/force_law.hpp"
#include "rubsweep/contact/friction_coefficient.hpp"
#include "rubsweep/integrate/scaled_system.hpp"

namespace rubsweep::integrate {

/// Right-hand side of a scaled system as Odeint wants it, u then u' in one state. Located: every contact obeys the
/// law of its current mode, continued smoothly past the mode's end. Smoothed: the blended law, whatever the mode.
/// Any state with contiguous doubles behind operator[] will do.
template <int N, bool Smoothed>
class Dynamics {
 public:
  static constexpr bool smoothed = Smoothed;
  using Vector = Eigen::Matrix<double, N, 1>;
  using ConstMap = Eigen::Map<const Vector>;
  using Map = Eigen::Map<Vector>;

  Dynamics(const ScaledSystem<N>& system, double smoothing_width)
      : system_(system), smoothing_width_(smoothing_width), modes_(system.contacts.size(), contact::Mode::open) {}

  /// `phase` in [0, 2 pi]: the revolution is an integer kept elsewhere, so that phases stay exact for ever.
  template <class State>
  void operator()(const State& state, State& rate, double phase) const {
    ++rhs_calls_;
    const Eigen::Index n = system_.coordinates();
    const ConstMap u(&state[0], n), v(&state[0] + n, n);
    Map velocity(&rate[0], n), acceleration(&rate[0] + n, n);
    velocity = v;
    if (system_.diagonal) {
      acceleration = system_.constant - system_.stiffness_diagonal.cwiseProduct(u) -
                     system_.damping_diagonal.cwiseProduct(v);
    } else {
      acceleration = system_.constant;
      acceleration.noalias() -= system_.stiffness * u;
      acceleration.noalias() -= system_.damping * v;
    }
    acceleration += system_.cosine * std::cos(phase) + system_.sine * std::sin(phase);
    if (pulse_on_) acceleration += system_.pulse * std::sin(system_.pulse_rate * (pulse_elapsed_ + phase));
    for (std::size_t i = 0; i < system_.contacts.size(); ++i) add_contact(i, u, v, acceleration);
  }

  /// Penetration, closing speed and closing acceleration of contact `i`, scaled, from a state and its rate.
  template <class State>
  contact::Kinematics kinematics(std::size_t i, const State& state, const State& rate) const {
    const Eigen::Index n = system_.coordinates();
    const auto& c = system_.contacts[i];
    return {c.normal_row.dot(ConstMap(&state[0], n).transpose()) - c.clearance,
            c.normal_row.dot(ConstMap(&state[0] + n, n).transpose()),
            c.normal_row.dot(ConstMap(&rate[0] + n, n).transpose())};
  }

  /// Normal force in newtons by the law this object integrates.
  contact::NormalForce normal_force(std::size_t i, double penetration, double closing_speed) const {
    const auto& c = system_.contacts[i];
    if constexpr (Smoothed) {
      return contact::smoothed_elastogap(c.stiffness, c.damping, penetration, closing_speed, smoothing_width_);
    } else {
      return contact::force_in_mode(modes_[i], c.stiffness, c.damping, penetration, closing_speed);
    }
  }

  template <class State>
  double slip_m_per_s(std::size_t i, const State& state) const {
    const Eigen::Index n = system_.coordinates();
    const auto& c = system_.contacts[i];
    return c.slip_scale_m_per_s * c.tangent_row.dot(ConstMap(&state[0] + n, n).transpose()) +
           c.surface_speed_m_per_s;
  }

  /// d(rate)/d(state), 2n x 2n, and d(rate)/d(phase), by the law in force. `j(row, column)` is a reference to one entry.
  template <class State, class Jacobian>
  void jacobian(const State& state, Jacobian&& j, double phase, State& phase_rate) const {
    const Eigen::Index n = system_.coordinates();
    const ConstMap u(&state[0], n), v(&state[0] + n, n);
    Eigen::MatrixXd by_u = -system_.stiffness, by_v = -system_.damping;
    for (std::size_t i = 0; i < system_.contacts.size(); ++i) add_contact_jacobian(i, u, v, by_u, by_v);
    for (Eigen::Index r = 0; r < n; ++r) {
      for (Eigen::Index c = 0; c < n; ++c) {
        const auto row = static_cast<std::size_t>(r), column = static_cast<std::size_t>(c);
        const auto offset = static_cast<std::size_t>(n);
        j(row, column) = 0;
        j(row, column + offset) = r == c ? 1 : 0;
        j(row + offset, column) = by_u(r, c);
        j(row + offset, column + offset) = by_v(r, c);
      }
    }
    Map velocity_rate(&phase_rate[0], n), force_rate(&phase_rate[0] + n, n);
    velocity_rate.setZero();
    force_rate = system_.sine * std::cos(phase) - system_.cosine * std::sin(phase);
    if (pulse_on_) {
      const double angle = system_.pulse_rate * (pulse_elapsed_ + phase);
      force_rate += system_.pulse * (system_.pulse_rate * std::cos(angle));
    }
  }

  const ScaledSystem<N>& system() const { return system_; }
  std::vector<contact::Mode>& modes() { return modes_; }
  const std::vector<contact::Mode>& modes() const { return modes_; }
  double smoothing_width() const { return smoothing_width_; }
  long rhs_calls() const { return rhs_calls_; }

  /// `elapsed_rad`: rotation since the start of the pulse at phase 0 of this revolution.
  void set_pulse(bool on, double elapsed_rad) {
    pulse_on_ = on;
    pulse_elapsed_ = elapsed_rad;
  }

 private:
  void add_contact(std::size_t i, const ConstMap& u, const ConstMap& v, Map& acceleration) const {
    if constexpr (!Smoothed) {
      if (modes_[i] == contact::Mode::open) return;
    }
    const auto& c = system_.contacts[i];
    const double penetration = c.normal_row.dot(u.transpose()) - c.clearance;
    if constexpr (Smoothed) {
      if (penetration <= -smoothing_width_ / 2) return;
    }
    const contact::NormalForce force = normal_force(i, penetration, c.normal_row.dot(v.transpose()));
    const double slip = c.slip_scale_m_per_s * c.tangent_row.dot(v.transpose()) + c.surface_speed_m_per_s;
    const double friction = contact::friction_coefficient(c.friction, slip) * force.spring_n;
    acceleration += c.normal_push * force.total_n + c.tangent_push * friction;
  }

  /// Partial derivatives of the normal force: of the spring part by p, of the total by p and by v.
  struct ForceSlopes {
    double spring_by_p = 0, total_by_p = 0, total_by_v = 0;
  };

  ForceSlopes force_slopes(std::size_t i, double p, double v) const {
    const auto& c = system_.contacts[i];
    if constexpr (Smoothed) {
      const double width = smoothing_width_, force_width = c.stiffness * width;
      const double spring = c.stiffness * contact::smooth_ramp(p, width);
      const double spring_by_p = c.stiffness * contact::smooth_ramp_slope(p, width);
      const double above = contact::smooth_ramp_slope(c.damping * v - spring, force_width);
      const double below = contact::smooth_ramp_slope(-c.damping * v - spring, force_width);
      return {spring_by_p, spring_by_p * (1 + above - below), c.damping * (1 - above - below)};
    } else {
      switch (modes_[i]) {
        case contact::Mode::open: return {};
        case contact::Mode::clamped: return {c.stiffness, 2 * c.stiffness, 0};
        case contact::Mode::sprung: return {c.stiffness, c.stiffness, c.damping};
        case contact::Mode::released: return {c.stiffness, 0, 0};
      }
      return {};
    }
  }

  void add_contact_jacobian(std::size_t i, const ConstMap& u, const ConstMap& v, Eigen::MatrixXd& by_u,
                            Eigen::MatrixXd& by_v) const {
    const auto& c = system_.contacts[i];
    const double p = c.normal_row.dot(u.transpose()) - c.clearance;
    const double closing = c.normal_row.dot(v.transpose());
    const ForceSlopes slopes = force_slopes(i, p, closing);
    if (slopes.spring_by_p == 0 && slopes.total_by_v == 0) return;
    const double slip = c.slip_scale_m_per_s * c.tangent_row.dot(v.transpose()) + c.surface_speed_m_per_s;
    const double spring = normal_force(i, p, closing).spring_n;
    const double mu = contact::friction_coefficient(c.friction, slip);
    const double mu_by_v = contact::friction_slope(c.friction, slip) * c.slip_scale_m_per_s;
    by_u += (c.normal_push * slopes.total_by_p + c.tangent_push * (mu * slopes.spring_by_p)) * c.normal_row;
    by_v += c.normal_push * slopes.total_by_v * c.normal_row + c.tangent_push * (mu_by_v * spring) * c.tangent_row;
  }

  const ScaledSystem<N>& system_;
  double smoothing_width_;
  std::vector<contact::Mode> modes_;
  bool pulse_on_ = false;
  double pulse_elapsed_ = 0;
  mutable long rhs_calls_ = 0;
};

}  // namespace rubsweep::integrate
