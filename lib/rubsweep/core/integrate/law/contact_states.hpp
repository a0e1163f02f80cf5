#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "rubsweep/core/contact/contact_mode.hpp"
#include "rubsweep/core/contact/dry_friction.hpp"
#include "rubsweep/core/contact/friction_law.hpp"
#include "rubsweep/core/contact/wall.hpp"
#include "rubsweep/core/integrate/run/scaled_system.hpp"
#include "rubsweep/core/numerics/dense/factors.hpp"

namespace rubsweep::integrate::law {

/// Motion of the rotor relative to the casing at one contact, from the coordinates `u` and their rates `v`.
template <int N>
contact::RelativeMotion relative_motion(const run::ScaledContact<N>& c,
                                        const Eigen::Map<const Eigen::Matrix<double, N, 1>>& u,
                                        const Eigen::Map<const Eigen::Matrix<double, N, 1>>& v) {
  return {c.first_row.dot(u.transpose()) + c.offset[0], c.second_row.dot(u.transpose()) + c.offset[1],
          c.first_row.dot(v.transpose()), c.second_row.dot(v.transpose())};
}

/// Contact frame, seen from the wall, of the motion with coordinates `u` and rates `v`.
template <int N>
contact::ContactFrame contact_frame(const run::ScaledContact<N>& c,
                                    const Eigen::Map<const Eigen::Matrix<double, N, 1>>& u,
                                    const Eigen::Map<const Eigen::Matrix<double, N, 1>>& v) {
  return contact::frame(c.wall, relative_motion(c, u, v), c.clearance);
}

template <int N>
double slip_m_per_s(const run::ScaledContact<N>& c, const contact::ContactFrame& f) {
  return c.slip_scale_m_per_s * f.sliding_speed + c.surface_speed_m_per_s;
}

/// Row that maps the rates of the coordinates to the sliding speed.
template <int N>
Eigen::Matrix<double, 1, N> tangential_row(const run::ScaledContact<N>& c, const contact::ContactFrame& f) {
  return f.cosine * c.second_row - f.sine * c.first_row;
}

/// Scaled accelerations of the coordinates per newton of friction on the casing.
template <int N>
Eigen::Matrix<double, N, 1> tangential_push(const run::ScaledContact<N>& c, const contact::ContactFrame& f) {
  return f.cosine * c.second_push - f.sine * c.first_push;
}

/// Discrete states of a system's contacts. Each contact has a mode. With dry friction, which jumps where the
/// slip reverses, it also has a slip state: forward, backward, or sticking. A sticking contact keeps its
/// present slip by a holding force, whose derivatives by the state are available. A smoothed law has neither
/// modes nor slips.
template <int N, bool Smoothed>
class ContactStates {
 public:
  using Vector = Eigen::Matrix<double, N, 1>;
  using Matrix = Eigen::Matrix<double, N, N>;
  using ConstMap = Eigen::Map<const Vector>;
  using Map = Eigen::Map<Vector>;

  explicit ContactStates(const run::ScaledSystem<N>& system)
      : system_(system),
        modes_(system.contacts.size(), contact::Mode::open),
        slips_(system.contacts.size(), contact::Slip::forward),
        poised_(system.contacts.size(), false) {
    for (const Contact& c : system.contacts) {
      dry_.push_back(contact::friction_terms(c.friction));
      any_dry_ = any_dry_ || dry_.back().holding > 0;
    }
  }

  const run::ScaledSystem<N>& system() const { return system_; }
  std::vector<contact::Mode>& modes() { return modes_; }
  const std::vector<contact::Mode>& modes() const { return modes_; }
  /// Slip states for dry friction; undefined for contacts that are open or have other friction.
  std::vector<contact::Slip>& slips() { return slips_; }
  const std::vector<contact::Slip>& slips() const { return slips_; }

  /// Indices of touching contacts with dry friction.
  struct Stuck {
    std::array<std::size_t, contact::most_sticking> list{};
    std::size_t count = 0;
  };

  /// Contacts that stick at present.
  Stuck stuck_contacts() const {
    Stuck stuck;
    for (std::size_t i = 0; i < slips_.size() && stuck.count < stuck.list.size(); ++i) {
      if (touches_dry(i) && slips_[i] == contact::Slip::sticking) stuck.list[stuck.count++] = i;
    }
    return stuck;
  }

  /// Whether contact `i` touches with a friction that jumps where its slip reverses.
  bool touches_dry(std::size_t i) const {
    return !Smoothed && dry_[i].holding > 0 && modes_[i] != contact::Mode::open;
  }
  /// Whether static friction exceeds sliding friction. The second function: whether friction drops when the
  /// slip begins.
  bool holds_harder(std::size_t i) const { return dry_[i].holding > dry_[i].dry; }
  bool jumps(std::size_t i) const { return dry_[i].jumps(); }
  bool any_dry() const { return !Smoothed && any_dry_; }

  /// Whether contact `i` has its largest friction while other sticking contacts keep its slip at zero.
  bool poised(std::size_t i) const { return poised_[i]; }
  const std::vector<bool>& poised() const { return poised_; }
  void poise(std::size_t i, bool so) { poised_[i] = so; }
  bool any_poised() const { return std::ranges::find(poised_, true) != poised_.end(); }

  /// Sets whether the search for friction that obeys the law failed; the run must then end.
  void leave_unsettled(bool so) { unsettled_ = so; }
  bool unsettled() const { return unsettled_; }

  /// Holding friction of a sticking contact, in newtons along its tangent, and the second derivative of its
  /// distance along the normal.
  struct Held {
    double force_n = 0, normal_acceleration = 0;
  };

  /// Holding frictions of the sticking contacts, in the order of `stuck`.
  struct Holding {
    Stuck stuck;
    std::array<Held, contact::most_sticking> held{};

    /// Holding friction of a contact; zero if it does not stick.
    double force_n(std::size_t contact) const {
      for (std::size_t k = 0; k < stuck.count; ++k)
        if (stuck.list[k] == contact) return held[k].force_n;
      return 0;
    }
  };

  /// Adds to a rate the friction that holds the sticking contacts.
  template <class State>
  Holding hold(const State& state, State& rate) const {
    Holding holding;
    if (Smoothed || !any_dry_) return holding;
    holding.stuck = stuck_contacts();
    const Stuck& stuck = holding.stuck;
    if (stuck.count == 0) return holding;
    const Eigen::Index n = system_.coordinates();
    const contact::StickVector force =
        contact::holding_forces(mobility(stuck, state), accelerations(stuck, state, rate));
    Map acceleration(&rate[0] + n, n);
    for (std::size_t k = 0; k < stuck.count; ++k) {
      const std::size_t i = stuck.list[k];
      holding.held[k].force_n = force(static_cast<Eigen::Index>(k));
      acceleration += holding.held[k].force_n * tangential_push(system_.contacts[i], frame_at(i, state));
    }
    for (std::size_t k = 0; k < stuck.count; ++k) {
      const std::size_t i = stuck.list[k];
      const contact::ContactFrame f = frame_at(i, state);
      holding.held[k].normal_acceleration =
          f.cosine * system_.contacts[i].first_row.dot(acceleration.transpose()) +
          f.sine * system_.contacts[i].second_row.dot(acceleration.transpose());
    }
    return holding;
  }

  /// Contact frame of contact `i`.
  template <class State>
  contact::ContactFrame frame_at(std::size_t i, const State& state) const {
    const Eigen::Index n = system_.coordinates();
    return contact_frame(system_.contacts[i], ConstMap(&state[0], n), ConstMap(&state[0] + n, n));
  }

  /// Slip of contact `i` in scaled units. The second function gives its time derivative for a given rate of
  /// the state.
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
  /// Derivative of the slip by the state.
  template <class State>
  Eigen::RowVectorXd slip_gradient(std::size_t i, const State& state) const {
    const contact::ContactFrame f = frame_at(i, state);
    const auto along = tangential_row(system_.contacts[i], f);
    Eigen::RowVectorXd row(2 * along.size());
    row << -f.closing_speed * f.curvature * along, along;
    return row;
  }

  /// Mobility of the surfaces of these contacts. The second function gives the accelerations of their slips
  /// for a given rate.
  template <class State>
  contact::StickMobility mobility(const Stuck& stuck, const State& state) const {
    const auto count = static_cast<Eigen::Index>(stuck.count);
    contact::StickMobility mobility(count, count);
    for (Eigen::Index j = 0; j < count; ++j) {
      const std::size_t b = stuck.list[static_cast<std::size_t>(j)];
      const Vector push = tangential_push(system_.contacts[b], frame_at(b, state));
      for (Eigen::Index i = 0; i < count; ++i) {
        const std::size_t a = stuck.list[static_cast<std::size_t>(i)];
        mobility(i, j) = -tangential_row(system_.contacts[a], frame_at(a, state)).dot(push.transpose());
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

  /// Projects small changes of a state, one per column, onto the sticking constraint.
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
            force(static_cast<Eigen::Index>(k)) * tangential_push(system_.contacts[i], frame_at(i, state));
      }
    }
  }

 protected:
  using Contact = run::ScaledContact<N>;

  /// Derivatives of the holding forces by u and by u', one contact per row, from the derivatives of the
  /// acceleration without these forces. They follow from the sticking constraint of small changes: with the
  /// tangent t and the sliding speed s = t . d', a sticking contact has t . d'' = s r' / r.
  template <class State>
  std::pair<Eigen::MatrixXd, Eigen::MatrixXd> holding_slopes(const State& state, const Holding& holding,
                                                             const Matrix& by_u, const Matrix& by_v) const {
    const Stuck& stuck = holding.stuck;
    const auto count = static_cast<Eigen::Index>(stuck.count);
    Eigen::MatrixXd need_u(count, by_u.cols()), need_v(count, by_u.cols());
    for (Eigen::Index k = 0; k < count; ++k) {
      const std::size_t i = stuck.list[static_cast<std::size_t>(k)];
      const double normal_acceleration = holding.held[static_cast<std::size_t>(k)].normal_acceleration;
      const Contact& c = system_.contacts[i];
      const contact::ContactFrame f = frame_at(i, state);
      const auto along = tangential_row(system_.contacts[i], f);
      const Eigen::Matrix<double, 1, N> across = f.cosine * c.first_row + f.sine * c.second_row;
      const double q = f.curvature, s = f.sliding_speed, v = f.closing_speed;
      // Derivatives of s: t . w' - v q t . w; of r': n . w' + s q t . w; of the tangent: -q (t . w) n.
      need_u.row(k) =
          along * by_u - (normal_acceleration * q + (s * s - v * v) * q * q) * along + s * v * q * q * across;
      need_v.row(k) = along * by_v - v * q * along - s * q * across;
    }
    const Eigen::MatrixXd mobility_of_all = mobility(stuck, state);
    return {numerics::dense::least_norm_solution(mobility_of_all, need_u),
            numerics::dense::least_norm_solution(mobility_of_all, need_v)};
  }

  template <class State>
  void hold_slopes(const State& state, const Holding& holding, Matrix& by_u, Matrix& by_v) const {
    const Stuck& stuck = holding.stuck;
    if (stuck.count == 0) return;
    const auto [force_by_u, force_by_v] = holding_slopes(state, holding, by_u, by_v);
    Eigen::MatrixXd push(by_u.rows(), static_cast<Eigen::Index>(stuck.count));
    for (std::size_t k = 0; k < stuck.count; ++k)
      push.col(static_cast<Eigen::Index>(k)) =
          tangential_push(system_.contacts[stuck.list[k]], frame_at(stuck.list[k], state));
    by_u += push * force_by_u;
    by_v += push * force_by_v;
  }

  const run::ScaledSystem<N>& system_;
  std::vector<contact::Mode> modes_;
  std::vector<contact::Slip> slips_;
  std::vector<contact::FrictionTerms> dry_;
  std::vector<bool> poised_;
  /// Growth rate of the surface speeds relative to themselves; zero at a steady speed.
  double surface_growth_ = 0;

 private:
  bool any_dry_ = false, unsettled_ = false;
};

}  // namespace rubsweep::integrate::law
