#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

#include "rubsweep/core/integrate/law/contact_forces.hpp"
#include "rubsweep/core/integrate/run/pulse_times.hpp"
#include "rubsweep/core/integrate/run/scaled_system.hpp"

namespace rubsweep::integrate::law {

/// Right-hand side of a scaled system for Odeint, with u then u' in one state, and its derivatives. A state
/// may be any type with contiguous doubles behind operator[]. A sticking contact keeps its slip.
template <int N, bool Smoothed>
class Dynamics : public ContactForces<N, Smoothed> {
  using Forces = ContactForces<N, Smoothed>;

 public:
  static constexpr bool smoothed = Smoothed;
  static constexpr int coordinates = N;
  using typename Forces::ConstMap;
  using typename Forces::Holding;
  using typename Forces::Map;
  using typename Forces::Matrix;
  using typename Forces::Vector;

  Dynamics(const run::ScaledSystem<N>& system, double smoothing_width) : Forces(system, smoothing_width) {}

  /// `phase` in [0, 2 pi]; revolutions are counted elsewhere, so that phases never lose accuracy.
  template <class State>
  void operator()(const State& state, State& rate, double phase) const {
    loose(state, rate, phase);
    if (this->any_dry()) this->hold(state, rate);
  }

  /// Right-hand side without the friction that holds sticking contacts.
  template <class State>
  void loose(const State& state, State& rate, double phase) const {
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
    for_each_acting_pulse([&](const auto& pulse, double elapsed) {
      acceleration += pulse.top * std::sin(pulse.rate * (elapsed + phase));
    });
    for (std::size_t i = 0; i < system_.contacts.size(); ++i) add_contact(i, u, v, acceleration);
  }

  /// Derivatives of the acceleration by u and by u', n x n, for the present modes; `holding` is the result of
  /// `hold` at this state.
  template <class State>
  void slopes(const State& state, const Holding& holding, Matrix& by_u, Matrix& by_v) const {
    given_slopes(state, holding, by_u, by_v);
    this->hold_slopes(state, holding, by_u, by_v);
  }

  /// Derivative, by the state, of the reserve of contact `i`, which sticks: the friction limit minus its
  /// holding friction in the direction of `slip`. `rate` is scratch.
  template <class State>
  Eigen::RowVectorXd reserve_gradient(std::size_t i, contact::Slip slip, const State& state, State& rate,
                                      double phase) const {
    loose(state, rate, phase);
    const Holding holding = this->hold(state, rate);
    Matrix by_u, by_v;
    given_slopes(state, holding, by_u, by_v);
    const auto [force_by_u, force_by_v] = this->holding_slopes(state, holding, by_u, by_v);
    const auto& list = holding.stuck.list;
    const Eigen::Index row = std::find(list.begin(), list.end(), i) - list.begin();
    const Contact& c = system_.contacts[i];
    const contact::ContactFrame f = this->frame_at(i, state);
    const double bound = dry_[i].holding * this->force_slopes(i, f.penetration, f.closing_speed).spring_by_p;
    Eigen::RowVectorXd gradient(2 * by_u.cols());
    gradient << bound * (f.cosine * c.first_row + f.sine * c.second_row) -
                    contact::sign_of(slip) * force_by_u.row(row),
        -contact::sign_of(slip) * force_by_v.row(row);
    return gradient;
  }

  /// Jacobian d(rate)/d(state), 2n x 2n, and d(rate)/d(phase), for the present modes. `j(row, column)` is a
  /// reference to one entry.
  template <class State, class Jacobian>
  void jacobian(const State& state, Jacobian&& j, double phase, State& phase_rate) const {
    const Eigen::Index n = system_.coordinates();
    Matrix by_u, by_v;
    Holding holding;
    if (this->any_dry()) {
      loose(state, phase_rate, phase);
      holding = this->hold(state, phase_rate);
    }
    slopes(state, holding, by_u, by_v);
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
    for_each_acting_pulse([&](const auto& pulse, double elapsed) {
      force_rate += pulse.top * (pulse.rate * std::cos(pulse.rate * (elapsed + phase)));
    });
    this->keep_sticking(state, Eigen::Map<Eigen::VectorXd>(&phase_rate[0], 2 * n));
  }

  /// State with which a run starts at `section`.
  std::vector<double> whole_state(std::vector<double> section) const { return section; }

  double smoothing_width() const { return smoothing_width_; }
  long rhs_calls() const { return rhs_calls_; }

  /// Sets the pulses that act from now on, with times in radians; `pulses` must outlive this object. Without
  /// this call only the second harmonic acts.
  void follow(const run::PulseTimes& pulses) { pulses_ = &pulses; }
  /// Pulses of the latest call of `follow`.
  const run::PulseTimes& pulses() const { return *pulses_; }

 private:
  /// The same as `slopes`, but with constant holding friction.
  template <class State>
  void given_slopes(const State& state, const Holding& holding, Matrix& by_u, Matrix& by_v) const {
    const Eigen::Index n = system_.coordinates();
    const ConstMap u(&state[0], n), v(&state[0] + n, n);
    by_u = -system_.stiffness;
    by_v = -system_.damping;
    for (std::size_t i = 0; i < system_.contacts.size(); ++i)
      add_contact_slopes(i, holding, u, v, by_u, by_v);
  }

  using Forces::dry_;
  using Forces::modes_;
  using Forces::slips_;
  using Forces::smoothing_width_;
  using Forces::system_;
  using typename Forces::Contact;

  template <class Visit>
  void for_each_acting_pulse(const Visit& visit) const {
    if (pulses_ != nullptr) {
      for (const std::size_t i : pulses_->acting()) visit(system_.pulses[i], pulses_->elapsed(i));
      return;
    }
    for (const auto& pulse : system_.pulses)
      if (pulse.always_elapsed) visit(pulse, *pulse.always_elapsed);
  }

  void add_contact(std::size_t i, const ConstMap& u, const ConstMap& v, Map& acceleration) const {
    if constexpr (!Smoothed) {
      if (modes_[i] == contact::Mode::open) return;
    }
    const Contact& c = system_.contacts[i];
    const contact::ContactFrame f = contact_frame(c, u, v);
    if constexpr (Smoothed) {
      if (f.penetration <= -smoothing_width_ / 2) return;
    }
    const contact::NormalForce force = this->normal_force(i, f.penetration, f.closing_speed);
    const double friction = this->coefficient(i, f) * force.spring_n;
    if (contact::linear(c.wall)) {
      acceleration += c.first_push * force.total_n + c.second_push * friction;
    } else {
      acceleration += c.first_push * (f.cosine * force.total_n - f.sine * friction) +
                      c.second_push * (f.sine * force.total_n + f.cosine * friction);
    }
  }

  /// Adds the derivatives of the acceleration by contact i: `by_u` by the displacement, `by_v` by the
  /// velocity. They follow from the force F(p, v) n + mu(s) S(p) t, where S is the spring force. The normal
  /// and the tangent turn by n' = t (t . d') / |d| and t' = -n (t . d') / |d|.
  void add_contact_slopes(std::size_t i, const Holding& holding, const ConstMap& u, const ConstMap& v,
                          Matrix& by_u, Matrix& by_v) const {
    const Contact& c = system_.contacts[i];
    const contact::ContactFrame f = contact_frame(c, u, v);
    const contact::ForceSlopes slopes = this->force_slopes(i, f.penetration, f.closing_speed);
    if (slopes.spring_by_p == 0 && slopes.total_by_v == 0) return;
    const contact::NormalForce force = this->normal_force(i, f.penetration, f.closing_speed);
    const double mu = this->coefficient(i, f), mu_by_v = this->coefficient_slope(i, f);
    const bool sticks = this->touches_dry(i) && slips_[i] == contact::Slip::sticking;
    const double friction_n = sticks ? holding.force_n(i) : mu * force.spring_n;
    const Eigen::Vector2d n(f.cosine, f.sine), t(-f.sine, f.cosine);
    Eigen::Matrix2d by_d =
        n * (slopes.total_by_p * n + slopes.total_by_v * f.sliding_speed * f.curvature * t).transpose();
    by_d += t * (mu * slopes.spring_by_p * n).transpose();
    by_d += f.curvature *
            (force.total_n * t - friction_n * n - mu_by_v * force.spring_n * f.closing_speed * t) *
            t.transpose();
    const Eigen::Matrix2d by_rate =
        slopes.total_by_v * n * n.transpose() + mu_by_v * force.spring_n * t * t.transpose();
    Eigen::Matrix<double, N, 2> push(by_u.rows(), 2);
    Eigen::Matrix<double, 2, N> rows(2, by_u.cols());
    push << c.first_push, c.second_push;
    rows << c.first_row, c.second_row;
    by_u += push * by_d * rows;
    by_v += push * by_rate * rows;
  }

  const run::PulseTimes* pulses_ = nullptr;
  mutable long rhs_calls_ = 0;
};

}  // namespace rubsweep::integrate::law
