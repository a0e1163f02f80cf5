#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

#include "rubsweep/core/contact/contact_mode.hpp"
#include "rubsweep/core/contact/dry_friction.hpp"
#include "rubsweep/core/contact/force_law.hpp"
#include "rubsweep/core/contact/friction_law.hpp"
#include "rubsweep/core/integrate/law/contact_states.hpp"
#include "rubsweep/core/integrate/law/curved_contacts.hpp"
#include "rubsweep/core/integrate/run/pulse_times.hpp"
#include "rubsweep/core/integrate/run/scaled_system.hpp"

namespace rubsweep::integrate::law {

/// Right-hand side of a scaled system as Odeint takes it, u then u' in one state. Located: every contact
/// obeys the law of its current mode, continued smoothly past the mode's end. Smoothed: the blended law,
/// whatever the mode, of linear contacts alone. Any state with contiguous doubles behind operator[] will do.
/// Dry friction, which jumps where the slip reverses, depends on `slips`: a contact that sticks keeps the
/// slip that it has.
template <int N, bool Smoothed>
class Dynamics : public ContactStates<N, Smoothed> {
  using States = ContactStates<N, Smoothed>;

 public:
  static constexpr bool smoothed = Smoothed;
  static constexpr int coordinates = N;
  using typename States::ConstMap;
  using typename States::Holding;
  using typename States::Map;
  using typename States::Matrix;
  using typename States::Vector;

  Dynamics(const run::ScaledSystem<N>& system, double smoothing_width)
      : States(system), curved_(system), smoothing_width_(smoothing_width) {}

  /// `phase` in [0, 2 pi]: the revolution is an integer kept elsewhere, so that phases stay exact for ever.
  template <class State>
  void operator()(const State& state, State& rate, double phase) const {
    loose(state, rate, phase);
    if (this->any_dry()) this->hold(state, rate);
  }

  /// The same without the friction that holds sticking contacts.
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

  /// Largest friction in newtons of contact `i`, which touches.
  template <class State>
  double largest_friction_n(std::size_t i, const State& state) const {
    const contact::ContactFrame f = this->frame_at(i, state);
    return dry_[i].holding * normal_force(i, f.penetration, f.closing_speed).spring_n;
  }
  /// The friction that it begins to slip with.
  template <class State>
  double sliding_friction_n(std::size_t i, const State& state) const {
    const contact::ContactFrame f = this->frame_at(i, state);
    const double coefficient = dry_[i].jumps() ? dry_[i].dry : dry_[i].holding;
    return coefficient * normal_force(i, f.penetration, f.closing_speed).spring_n;
  }

  /// Penetration of contact `i` and its two rates, scaled, from a state and its rate; as
  /// contact::open_kinematics while it is open.
  template <class State>
  contact::Kinematics kinematics(std::size_t i, const State& state, const State& rate) const {
    const Eigen::Index n = system_.coordinates();
    const auto& c = system_.contacts[i];
    const ConstMap acceleration(&rate[0] + n, n);
    const contact::RelativeMotion m = relative_motion(c, ConstMap(&state[0], n), ConstMap(&state[0] + n, n));
    const double a1 = c.first_row.dot(acceleration.transpose());
    const double a2 = c.second_row.dot(acceleration.transpose());
    return !Smoothed && modes_[i] == contact::Mode::open
               ? contact::open_kinematics(c.wall, m, a1, a2, c.clearance)
               : contact::kinematics(c.wall, m, a1, a2, c.clearance);
  }

  /// Puts contact `i` into the mode that a state has by itself, its rate being that of the modes before. A
  /// start exactly at the wall and moving into it is in contact from the first instant.
  template <class State>
  void enter_by_state(std::size_t i, const State& state, const State& rate) {
    const Contact& c = system_.contacts[i];
    const bool begins = modes_[i] == contact::Mode::open;
    contact::Kinematics k = kinematics(i, state, rate);
    if (k.penetration > 0) {
      // The guard of an open annular stop is in squares; the modes are separated by the penetration itself.
      modes_[i] = contact::Mode::sprung;
      k = kinematics(i, state, rate);
    }
    if (begins) curved_.begin_inside(i, k);
    const contact::Mode mode = c.law
                                   ? contact::curved_mode(impact_damping(i), k.penetration, k.closing_speed)
                                   : contact::mode_of(c.stiffness, c.damping, k.penetration, k.closing_speed);
    modes_[i] = mode_after(i, mode, k);
  }

  /// The guards armed in the mode of contact `i`, and the mode just after an instant at which `mode` may have
  /// ended.
  contact::Guards guards(std::size_t i, const contact::Kinematics& k) const {
    return guards(i, modes_[i], k);
  }
  contact::Mode mode_after(std::size_t i, contact::Mode mode, const contact::Kinematics& k) const {
    return contact::mode_after(mode, k, [&](contact::Mode of) { return guards(i, of, k); });
  }

  /// Contact `i` begins to touch with this closing speed: its law may damp it by that.
  void begin_impact(std::size_t i, double closing_speed) { curved_.begin_impact(i, closing_speed); }
  double impact_damping(std::size_t i) const { return curved_.impact_damping(i); }

  /// Normal force in newtons by the law this object integrates.
  contact::NormalForce normal_force(std::size_t i, double penetration, double closing_speed) const {
    const auto& c = system_.contacts[i];
    if constexpr (Smoothed) {
      return contact::smoothed_elastogap(c.stiffness, c.damping, penetration, closing_speed,
                                         smoothing_width_);
    } else {
      if (c.law) return curved_.force(i, modes_[i], penetration, closing_speed);
      return contact::force_in_mode(modes_[i], c.stiffness, c.damping, penetration, closing_speed);
    }
  }

  template <class State>
  double slip_m_per_s(std::size_t i, const State& state) const {
    return law::slip_m_per_s(system_.contacts[i], this->frame_at(i, state));
  }

  /// Friction force of contact `i` on the casing, in newtons along the tangent.
  template <class State>
  double friction_n(std::size_t i, const State& state) const {
    if (!Smoothed && modes_[i] == contact::Mode::open) return 0;
    const contact::ContactFrame f = this->frame_at(i, state);
    if (Smoothed && f.penetration <= -smoothing_width_ / 2) return 0;
    return coefficient(i, f) * normal_force(i, f.penetration, f.closing_speed).spring_n;
  }

  /// Rate at which friction alone changes the slip at contact `i`, over the angular frequency of that
  /// contact's spring between the masses it joins. Zero where friction does not depend on the slip, and in a
  /// contact that is open.
  template <class State>
  double friction_ratio(std::size_t i, const State& state) const {
    const Eigen::Index n = system_.coordinates();
    const ConstMap u(&state[0], n), v(&state[0] + n, n);
    const Contact& c = system_.contacts[i];
    if (!Smoothed && modes_[i] == contact::Mode::open) return 0;
    const contact::ContactFrame f = contact_frame(c, u, v);
    const double slope = coefficient_slope(i, f);
    if (slope <= 0) return 0;
    const double spring_n = normal_force(i, f.penetration, f.closing_speed).spring_n;
    return slope * spring_n * std::sqrt(c.mobility() / c.stiffness);
  }

  /// The largest of all contacts that touch.
  template <class State>
  double friction_ratio(const State& state) const {
    double largest = 0;
    for (std::size_t i = 0; i < system_.contacts.size(); ++i)
      largest = std::max(largest, friction_ratio(i, state));
    return largest;
  }

  /// Derivatives of the acceleration by u and by u', n x n, by the law in force; `holding` is what `hold`
  /// returned at this state.
  template <class State>
  void slopes(const State& state, const Holding& holding, Matrix& by_u, Matrix& by_v) const {
    given_slopes(state, holding, by_u, by_v);
    this->hold_slopes(state, holding, by_u, by_v);
  }

  /// Derivative by the state of the distance from its bound of the friction that holds contact `i`, in the
  /// direction of `slip`; `rate` is scratch.
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
    const double bound = dry_[i].holding * force_slopes(i, f.penetration, f.closing_speed).spring_by_p;
    Eigen::RowVectorXd gradient(2 * by_u.cols());
    gradient << bound * (f.cosine * c.first_row + f.sine * c.second_row) -
                    contact::sign_of(slip) * force_by_u.row(row),
        -contact::sign_of(slip) * force_by_v.row(row);
    return gradient;
  }

  /// d(rate)/d(state), 2n x 2n, and d(rate)/d(phase), by the law in force. `j(row, column)` is a reference to
  /// one entry.
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
  }

  /// State that a run starts with at `section`.
  std::vector<double> whole_state(std::vector<double> section) const { return section; }

  double smoothing_width() const { return smoothing_width_; }
  long rhs_calls() const { return rhs_calls_; }

  /// Sets the pulses of the system that act from here on, in radians; `pulses` must outlive this. Before,
  /// the second harmonic alone acts.
  void follow(const run::PulseTimes& pulses) { pulses_ = &pulses; }

 private:
  /// As `slopes`, with the friction that holds as it is.
  template <class State>
  void given_slopes(const State& state, const Holding& holding, Matrix& by_u, Matrix& by_v) const {
    const Eigen::Index n = system_.coordinates();
    const ConstMap u(&state[0], n), v(&state[0] + n, n);
    by_u = -system_.stiffness;
    by_v = -system_.damping;
    for (std::size_t i = 0; i < system_.contacts.size(); ++i)
      add_contact_slopes(i, holding, u, v, by_u, by_v);
  }

  using States::dry_;
  using States::modes_;
  using States::slips_;
  using States::system_;
  using typename States::Contact;

  template <class Visit>
  void for_each_acting_pulse(const Visit& visit) const {
    if (pulses_ != nullptr) {
      for (const std::size_t i : pulses_->acting()) visit(system_.pulses[i], pulses_->elapsed(i));
      return;
    }
    for (const auto& pulse : system_.pulses)
      if (pulse.always_elapsed) visit(pulse, *pulse.always_elapsed);
  }

  /// Friction over spring force, which is none of a contact that sticks, and its derivative by the scaled
  /// slip. A smoothed law takes dry friction over from one way to the other within one smoothing width a
  /// radian.
  double coefficient(std::size_t i, const contact::ContactFrame& f) const {
    const Contact& c = system_.contacts[i];
    const contact::FrictionTerms& dry = dry_[i];
    if (dry.holding == 0) return contact::friction_coefficient(c.friction, law::slip_m_per_s(c, f));
    if constexpr (Smoothed)
      return dry.dry * std::tanh(law::slip_m_per_s(c, f) / (c.slip_scale_m_per_s * smoothing_width_));
    const double way = contact::sign_of(slips_[i]);
    if (this->poised(i)) return dry.holding * way;
    if (dry.falling.height == 0) return dry.dry * way;
    return way * (dry.dry + dry.falling.at(way * law::slip_m_per_s(c, f)));
  }
  double coefficient_slope(std::size_t i, const contact::ContactFrame& f) const {
    const Contact& c = system_.contacts[i];
    const contact::FrictionTerms& dry = dry_[i];
    if (dry.holding == 0)
      return contact::friction_slope(c.friction, law::slip_m_per_s(c, f)) * c.slip_scale_m_per_s;
    if constexpr (!Smoothed) {
      const double way = contact::sign_of(slips_[i]);
      if (way == 0 || dry.falling.height == 0 || this->poised(i)) return 0;
      return dry.falling.slope(way * law::slip_m_per_s(c, f)) * c.slip_scale_m_per_s;
    }
    const double share = std::tanh(law::slip_m_per_s(c, f) / (c.slip_scale_m_per_s * smoothing_width_));
    return dry.dry * (1 - share * share) / smoothing_width_;
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
    const contact::NormalForce force = normal_force(i, f.penetration, f.closing_speed);
    const double friction = coefficient(i, f) * force.spring_n;
    if (contact::linear(c.wall)) {
      acceleration += c.first_push * force.total_n + c.second_push * friction;
    } else {
      acceleration += c.first_push * (f.cosine * force.total_n - f.sine * friction) +
                      c.second_push * (f.sine * force.total_n + f.cosine * friction);
    }
  }

  contact::ForceSlopes force_slopes(std::size_t i, double p, double v) const {
    const auto& c = system_.contacts[i];
    if constexpr (Smoothed) {
      return contact::smoothed_elastogap_slopes(c.stiffness, c.damping, p, v, smoothing_width_);
    } else {
      if (!c.law) return contact::slopes_in_mode(modes_[i], c.stiffness, c.damping);
      return curved_.slopes(i, modes_[i], p, v);
    }
  }

  contact::Guards guards(std::size_t i, contact::Mode mode, const contact::Kinematics& k) const {
    const Contact& c = system_.contacts[i];
    return c.law ? curved_.guards(i, mode, k) : contact::guards_of(mode, c.stiffness, c.damping, k);
  }

  /// f = F(p, v) n + mu(s) S(p) t with n' = t (t . d') / |d| and t' = -n (t . d') / |d|.
  void add_contact_slopes(std::size_t i, const Holding& holding, const ConstMap& u, const ConstMap& v,
                          Matrix& by_u, Matrix& by_v) const {
    const Contact& c = system_.contacts[i];
    const contact::ContactFrame f = contact_frame(c, u, v);
    const contact::ForceSlopes slopes = force_slopes(i, f.penetration, f.closing_speed);
    if (slopes.spring_by_p == 0 && slopes.total_by_v == 0) return;
    const contact::NormalForce force = normal_force(i, f.penetration, f.closing_speed);
    const double mu = coefficient(i, f), mu_by_v = coefficient_slope(i, f);
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

  CurvedContacts<N> curved_;
  double smoothing_width_;
  const run::PulseTimes* pulses_ = nullptr;
  mutable long rhs_calls_ = 0;
};

}  // namespace rubsweep::integrate::law
