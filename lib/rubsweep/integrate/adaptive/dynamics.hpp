#pragma once

#include <Eigen/Core>
#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "rubsweep/contact/contact_mode.hpp"
#include "rubsweep/contact/dry_friction.hpp"
#include "rubsweep/contact/force_law.hpp"
#include "rubsweep/contact/friction_law.hpp"
#include "rubsweep/integrate/run/pulse_times.hpp"
#include "rubsweep/integrate/run/scaled_system.hpp"

namespace rubsweep::integrate::adaptive {

/// Right-hand side of a scaled system as Odeint wants it, u then u' in one state. Located: every contact
/// obeys the law of its current mode, continued smoothly past the mode's end. Smoothed: the blended law,
/// whatever the mode. Any state with contiguous doubles behind operator[] will do. Dry friction, which jumps
/// where the slip reverses, goes by what `slips` says: a contact that sticks keeps the slip that it has.
template <int N, bool Smoothed>
class Dynamics {
 public:
  static constexpr bool smoothed = Smoothed;
  using Vector = Eigen::Matrix<double, N, 1>;
  using Matrix = Eigen::Matrix<double, N, N>;
  using ConstMap = Eigen::Map<const Vector>;
  using Map = Eigen::Map<Vector>;

  Dynamics(const run::ScaledSystem<N>& system, double smoothing_width)
      : system_(system),
        smoothing_width_(smoothing_width),
        modes_(system.contacts.size(), contact::Mode::open),
        slips_(system.contacts.size(), contact::Slip::forward),
        held_(system.contacts.size()) {
    for (const Contact& c : system.contacts) {
      dry_.push_back(contact::dry_coefficient(c.friction));
      any_dry_ = any_dry_ || dry_.back() > 0;
    }
  }

  /// `phase` in [0, 2 pi]: the revolution is an integer kept elsewhere, so that phases stay exact for ever.
  template <class State>
  void operator()(const State& state, State& rate, double phase) const {
    loose(state, rate, phase);
    hold(state, rate);
  }

  /// The same without what holds the contacts that stick.
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

  /// Adds the friction that holds the contacts that stick to a rate without it.
  template <class State>
  void hold(const State& state, State& rate) const {
    if (Smoothed || !any_dry_) return;
    const Stuck stuck = stuck_contacts();
    if (stuck.count == 0) return;
    const Eigen::Index n = system_.coordinates();
    const contact::StickVector force =
        contact::holding_forces(mobility(stuck, state), accelerations(stuck, state, rate));
    Map acceleration(&rate[0] + n, n);
    for (std::size_t k = 0; k < stuck.count; ++k) {
      const std::size_t i = stuck.list[k];
      held_[i].force_n = force(static_cast<Eigen::Index>(k));
      acceleration += held_[i].force_n * tangential_push(i, frame_at(i, state));
    }
    for (std::size_t k = 0; k < stuck.count; ++k) {
      const std::size_t i = stuck.list[k];
      const contact::ContactFrame f = frame_at(i, state);
      held_[i].normal_acceleration = f.cosine * system_.contacts[i].first_row.dot(acceleration.transpose()) +
                                     f.sine * system_.contacts[i].second_row.dot(acceleration.transpose());
    }
  }

  /// Contacts with dry friction that touch, by their numbers.
  struct Stuck {
    std::array<std::size_t, contact::most_sticking> list{};
    std::size_t count = 0;
  };

  /// Those that stick.
  Stuck stuck_contacts() const {
    Stuck stuck;
    for (std::size_t i = 0; i < slips_.size() && stuck.count < stuck.list.size(); ++i) {
      if (touches_dry(i) && slips_[i] == contact::Slip::sticking) stuck.list[stuck.count++] = i;
    }
    return stuck;
  }

  /// Whether contact `i` touches with a friction that jumps where its slip reverses.
  bool touches_dry(std::size_t i) const {
    return !Smoothed && dry_[i] > 0 && modes_[i] != contact::Mode::open;
  }
  bool any_dry() const { return !Smoothed && any_dry_; }

  /// Says that what holds the contacts that stick is not determined one by one: the run is to end.
  void leave_undetermined() { undetermined_ = true; }
  bool undetermined() const { return undetermined_; }

  /// Largest friction in newtons of contact `i`, which touches.
  template <class State>
  double largest_friction_n(std::size_t i, const State& state) const {
    const contact::ContactFrame f = frame_at(i, state);
    return dry_[i] * normal_force(i, f.penetration, f.closing_speed).spring_n;
  }

  /// Friction that held contact `i`, which sticks, where the rate was last asked for; newtons along its
  /// tangent.
  double holding_force_n(std::size_t i) const { return held_[i].force_n; }

  /// Slip of contact `i` in scaled units, and how fast it changes at a rate of the state.
  template <class State>
  double slip(std::size_t i, const State& state) const {
    const Contact& c = system_.contacts[i];
    return frame_at(i, state).sliding_speed + c.surface_speed_m_per_s / c.slip_scale_m_per_s;
  }
  template <class State>
  double slip_rate(std::size_t i, const State& state, const State& rate) const {
    const Eigen::Index n = system_.coordinates();
    const Contact& c = system_.contacts[i];
    const ConstMap acceleration(&rate[0] + n, n);
    const contact::ContactFrame f = frame_at(i, state);
    return f.cosine * c.second_row.dot(acceleration.transpose()) -
           f.sine * c.first_row.dot(acceleration.transpose()) -
           f.sliding_speed * f.closing_speed * f.curvature +
           surface_growth_ * c.surface_speed_m_per_s / c.slip_scale_m_per_s;
  }
  /// Its derivative by the state.
  template <class State>
  Eigen::RowVectorXd slip_gradient(std::size_t i, const State& state) const {
    const contact::ContactFrame f = frame_at(i, state);
    const auto along = tangential_row(i, f);
    Eigen::RowVectorXd row(2 * along.size());
    row << -f.closing_speed * f.curvature * along, along;
    return row;
  }

  /// Mobility of the surfaces of these contacts, and the accelerations of their slips at a rate.
  template <class State>
  contact::StickMobility mobility(const Stuck& stuck, const State& state) const {
    const auto count = static_cast<Eigen::Index>(stuck.count);
    contact::StickMobility mobility(count, count);
    for (Eigen::Index j = 0; j < count; ++j) {
      const std::size_t b = stuck.list[static_cast<std::size_t>(j)];
      const Vector push = tangential_push(b, frame_at(b, state));
      for (Eigen::Index i = 0; i < count; ++i) {
        const std::size_t a = stuck.list[static_cast<std::size_t>(i)];
        mobility(i, j) = -tangential_row(a, frame_at(a, state)).dot(push.transpose());
      }
    }
    return mobility;
  }
  template <class State>
  contact::StickVector accelerations(const Stuck& stuck, const State& state, const State& rate) const {
    contact::StickVector result(static_cast<Eigen::Index>(stuck.count));
    for (std::size_t k = 0; k < stuck.count; ++k)
      result(static_cast<Eigen::Index>(k)) = slip_rate(stuck.list[k], state, rate);
    return result;
  }

  /// Takes out of small changes of a state, one per column, what would let a contact slip that sticks.
  template <class State, class Changes>
  void keep_sticking(const State& state, Changes&& changes) const {
    const Stuck stuck = any_dry() ? stuck_contacts() : Stuck{};
    if (stuck.count == 0) return;
    const Eigen::Index n = system_.coordinates();
    const contact::StickMobility all = mobility(stuck, state);
    for (Eigen::Index column = 0; column < changes.cols(); ++column) {
      contact::StickVector slips(static_cast<Eigen::Index>(stuck.count));
      for (std::size_t k = 0; k < stuck.count; ++k)
        slips(static_cast<Eigen::Index>(k)) = slip_gradient(stuck.list[k], state).dot(changes.col(column));
      const contact::StickVector force = contact::holding_forces(all, slips);
      for (std::size_t k = 0; k < stuck.count; ++k) {
        const std::size_t i = stuck.list[k];
        changes.col(column).segment(n, n) +=
            force(static_cast<Eigen::Index>(k)) * tangential_push(i, frame_at(i, state));
      }
    }
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
    contact::Kinematics k = kinematics(i, state, rate);
    if (k.penetration > 0) {
      // An open annular stop measures by squares; what tells the modes apart is the penetration itself.
      modes_[i] = contact::Mode::sprung;
      k = kinematics(i, state, rate);
    }
    const contact::Mode mode = contact::mode_of(c.stiffness, c.damping, k.penetration, k.closing_speed);
    modes_[i] = contact::mode_after(mode, c.stiffness, c.damping, k);
  }

  /// Normal force in newtons by the law this object integrates.
  contact::NormalForce normal_force(std::size_t i, double penetration, double closing_speed) const {
    const auto& c = system_.contacts[i];
    if constexpr (Smoothed) {
      return contact::smoothed_elastogap(c.stiffness, c.damping, penetration, closing_speed,
                                         smoothing_width_);
    } else {
      return contact::force_in_mode(modes_[i], c.stiffness, c.damping, penetration, closing_speed);
    }
  }

  template <class State>
  double slip_m_per_s(std::size_t i, const State& state) const {
    const Eigen::Index n = system_.coordinates();
    const auto& c = system_.contacts[i];
    return slip(c, frame(c, ConstMap(&state[0], n), ConstMap(&state[0] + n, n)));
  }

  /// Friction force of contact `i` on the casing, in newtons along the tangent.
  template <class State>
  double friction_n(std::size_t i, const State& state) const {
    if (!Smoothed && modes_[i] == contact::Mode::open) return 0;
    const Eigen::Index n = system_.coordinates();
    const Contact& c = system_.contacts[i];
    const contact::ContactFrame f = frame(c, ConstMap(&state[0], n), ConstMap(&state[0] + n, n));
    if (Smoothed && f.penetration <= -smoothing_width_ / 2) return 0;
    return contact::friction_coefficient(c.friction, slip(c, f)) *
           normal_force(i, f.penetration, f.closing_speed).spring_n;
  }

  /// Rate at which friction alone changes the slip at a contact, over the angular frequency of that contact's
  /// spring between the masses it joins; the largest of all contacts that touch. Zero where friction does not
  /// depend on the slip.
  template <class State>
  double friction_ratio(const State& state) const {
    const Eigen::Index n = system_.coordinates();
    const ConstMap u(&state[0], n), v(&state[0] + n, n);
    double largest = 0;
    for (std::size_t i = 0; i < system_.contacts.size(); ++i) {
      const Contact& c = system_.contacts[i];
      if (!Smoothed && modes_[i] == contact::Mode::open) continue;
      const contact::ContactFrame f = frame(c, u, v);
      const double slope = coefficient_slope(i, f);
      if (slope <= 0) continue;
      const double spring_n = normal_force(i, f.penetration, f.closing_speed).spring_n;
      largest = std::max(largest, slope * spring_n * std::sqrt(c.mobility() / c.stiffness));
    }
    return largest;
  }

  /// Derivatives of the acceleration by u and by u', n x n, by the law in force. Where a contact sticks, the
  /// rate has been asked for at this state before.
  template <class State>
  void slopes(const State& state, Matrix& by_u, Matrix& by_v) const {
    const Eigen::Index n = system_.coordinates();
    const ConstMap u(&state[0], n), v(&state[0] + n, n);
    by_u = -system_.stiffness;
    by_v = -system_.damping;
    for (std::size_t i = 0; i < system_.contacts.size(); ++i) add_contact_slopes(i, u, v, by_u, by_v);
    if (any_dry()) hold_slopes(state, by_u, by_v);
  }

  /// d(rate)/d(state), 2n x 2n, and d(rate)/d(phase), by the law in force. `j(row, column)` is a reference to
  /// one entry.
  template <class State, class Jacobian>
  void jacobian(const State& state, Jacobian&& j, double phase, State& phase_rate) const {
    const Eigen::Index n = system_.coordinates();
    Matrix by_u, by_v;
    if (any_dry()) (*this)(state, phase_rate, phase);
    slopes(state, by_u, by_v);
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

  const run::ScaledSystem<N>& system() const { return system_; }
  std::vector<contact::Mode>& modes() { return modes_; }
  const std::vector<contact::Mode>& modes() const { return modes_; }
  /// What dry friction goes by; of no meaning in contacts that are open or have another friction.
  std::vector<contact::Slip>& slips() { return slips_; }
  const std::vector<contact::Slip>& slips() const { return slips_; }
  double smoothing_width() const { return smoothing_width_; }
  long rhs_calls() const { return rhs_calls_; }

  /// From here on those pulses of the system act that `pulses` says, in radians; it must outlive this. No
  /// pulse acts before.
  void follow(const run::PulseTimes& pulses) { pulses_ = &pulses; }

 protected:
  /// Rate of the surface speeds over these themselves; zero at a steady speed.
  double surface_growth_ = 0;

 private:
  using Contact = run::ScaledContact<N>;

  template <class Visit>
  void for_each_acting_pulse(const Visit& visit) const {
    if (pulses_ == nullptr) return;
    for (const std::size_t i : pulses_->acting()) visit(system_.pulses[i], pulses_->elapsed(i));
  }

  static contact::RelativeMotion relative_motion(const Contact& c, const ConstMap& u, const ConstMap& v) {
    return {c.first_row.dot(u.transpose()) + c.offset[0], c.second_row.dot(u.transpose()) + c.offset[1],
            c.first_row.dot(v.transpose()), c.second_row.dot(v.transpose())};
  }

  template <class State>
  contact::ContactFrame frame_at(std::size_t i, const State& state) const {
    const Eigen::Index n = system_.coordinates();
    return frame(system_.contacts[i], ConstMap(&state[0], n), ConstMap(&state[0] + n, n));
  }

  auto tangential_row(std::size_t i, const contact::ContactFrame& f) const {
    const Contact& c = system_.contacts[i];
    return Eigen::Matrix<double, 1, N>(f.cosine * c.second_row - f.sine * c.first_row);
  }
  Vector tangential_push(std::size_t i, const contact::ContactFrame& f) const {
    const Contact& c = system_.contacts[i];
    return f.cosine * c.second_push - f.sine * c.first_push;
  }

  /// Friction over spring force, which is none of a contact that sticks, and its derivative by the scaled
  /// slip. A smoothed law takes dry friction over from one way to the other within one smoothing width a
  /// radian.
  double coefficient(std::size_t i, const contact::ContactFrame& f) const {
    const Contact& c = system_.contacts[i];
    if (dry_[i] == 0) return contact::friction_coefficient(c.friction, slip(c, f));
    if constexpr (Smoothed)
      return dry_[i] * std::tanh(slip(c, f) / (c.slip_scale_m_per_s * smoothing_width_));
    return dry_[i] * contact::sign_of(slips_[i]);
  }
  double coefficient_slope(std::size_t i, const contact::ContactFrame& f) const {
    const Contact& c = system_.contacts[i];
    if (dry_[i] == 0) return contact::friction_slope(c.friction, slip(c, f)) * c.slip_scale_m_per_s;
    if constexpr (!Smoothed) return 0;
    const double share = std::tanh(slip(c, f) / (c.slip_scale_m_per_s * smoothing_width_));
    return dry_[i] * (1 - share * share) / smoothing_width_;
  }

  static contact::ContactFrame frame(const Contact& c, const ConstMap& u, const ConstMap& v) {
    const contact::RelativeMotion m = relative_motion(c, u, v);
    return contact::frame(c.wall, m, c.clearance);
  }

  static double slip(const Contact& c, const contact::ContactFrame& f) {
    return c.slip_scale_m_per_s * f.sliding_speed + c.surface_speed_m_per_s;
  }

  void add_contact(std::size_t i, const ConstMap& u, const ConstMap& v, Map& acceleration) const {
    if constexpr (!Smoothed) {
      if (modes_[i] == contact::Mode::open) return;
    }
    const Contact& c = system_.contacts[i];
    const contact::ContactFrame f = frame(c, u, v);
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
      return contact::slopes_in_mode(modes_[i], c.stiffness, c.damping);
    }
  }

  /// f = F(p, v) n + mu(s) S(p) t with n' = t (t . d') / |d| and t' = -n (t . d') / |d|.
  void add_contact_slopes(std::size_t i, const ConstMap& u, const ConstMap& v, Matrix& by_u,
                          Matrix& by_v) const {
    const Contact& c = system_.contacts[i];
    const contact::ContactFrame f = frame(c, u, v);
    const contact::ForceSlopes slopes = force_slopes(i, f.penetration, f.closing_speed);
    if (slopes.spring_by_p == 0 && slopes.total_by_v == 0) return;
    const contact::NormalForce force = normal_force(i, f.penetration, f.closing_speed);
    const double mu = coefficient(i, f), mu_by_v = coefficient_slope(i, f);
    const bool sticks = touches_dry(i) && slips_[i] == contact::Slip::sticking;
    const double friction_n = sticks ? held_[i].force_n : mu * force.spring_n;
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

  /// With t the tangent and s = t . d' the sliding speed, a contact that sticks has t . d'' = s r' / r. Small
  /// changes obey the derivative of that, by the forces that it takes.
  template <class State>
  void hold_slopes(const State& state, Matrix& by_u, Matrix& by_v) const {
    const Stuck stuck = stuck_contacts();
    if (stuck.count == 0) return;
    const auto count = static_cast<Eigen::Index>(stuck.count);
    Eigen::MatrixXd need_u(count, by_u.cols()), need_v(count, by_u.cols()), push(by_u.rows(), count);
    for (Eigen::Index k = 0; k < count; ++k) {
      const std::size_t i = stuck.list[static_cast<std::size_t>(k)];
      const Contact& c = system_.contacts[i];
      const contact::ContactFrame f = frame_at(i, state);
      const auto along = tangential_row(i, f);
      const Eigen::Matrix<double, 1, N> across = f.cosine * c.first_row + f.sine * c.second_row;
      const double q = f.curvature, s = f.sliding_speed, v = f.closing_speed;
      // Of s: t . w' - v q t . w. Of r': n . w' + s q t . w. Of the tangent: -q (t . w) n.
      need_u.row(k) = along * by_u - (held_[i].normal_acceleration * q + (s * s - v * v) * q * q) * along +
                      s * v * q * q * across;
      need_v.row(k) = along * by_v - v * q * along - s * q * across;
      push.col(k) = tangential_push(i, f);
    }
    const Eigen::MatrixXd mobility_of_all = mobility(stuck, state);
    const auto solver = mobility_of_all.completeOrthogonalDecomposition();
    by_u += push * solver.solve(need_u);
    by_v += push * solver.solve(need_v);
  }

  /// What holds a contact that sticks, and the second derivative of its distance along the normal.
  struct Held {
    double force_n = 0, normal_acceleration = 0;
  };

  const run::ScaledSystem<N>& system_;
  double smoothing_width_;
  std::vector<contact::Mode> modes_;
  std::vector<contact::Slip> slips_;
  std::vector<double> dry_;  ///< coefficients
  bool any_dry_ = false, undetermined_ = false;
  mutable std::vector<Held> held_;
  const run::PulseTimes* pulses_ = nullptr;
  mutable long rhs_calls_ = 0;
};

}  // namespace rubsweep::integrate::adaptive
