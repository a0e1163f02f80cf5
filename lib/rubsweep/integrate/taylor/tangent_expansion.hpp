#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "rubsweep/contact/friction_law.hpp"
#include "rubsweep/integrate/taylor/contact_tangent.hpp"
#include "rubsweep/integrate/taylor/creep_tangent.hpp"
#include "rubsweep/integrate/taylor/expansion.hpp"

namespace rubsweep::integrate::taylor {

/// Tangent vectors of a motion, small changes of its state, moved along its expansions: w'' = -stiffness w -
/// damping w' + change of the contacts' forces. At a change of mode they go on without a jump, as the force
/// does. Where a contact sticks, they keep its slip, too.
template <int N>
class TangentExpansion {
 public:
  /// Highest order: one less than the motion's, which has to be known one further.
  static constexpr int order = numerics::most_taylor_order - 1;

  explicit TangentExpansion(const run::ScaledSystem<N>& system)
      : system_(system),
        w_(system.coordinates(), order + 1),
        rate_(system.coordinates(), order + 1),
        acceleration_(system.coordinates()),
        contacts_(system.contacts.size()),
        creeps_(system.contacts.size()) {
    if (std::ranges::any_of(system.contacts, [](const auto& c) {
          return contact::dry_coefficient(c.friction) > 0 || contact::depends_on_slip(c.friction);
        }))
      sticking_.resize(order + 1);
  }

  /// One per column, as TurnRequest::tangent_vectors.
  void begin(const Eigen::MatrixXd& tangents) { tangents_ = tangents; }
  Eigen::Index count() const { return tangents_.cols(); }

  /// Moves them over `duration_rad` of the motion as it was expanded. Each is expanded until its last two
  /// terms are `accuracy` of its largest ones, in displacements and in rates. False, and nothing moved, where
  /// contacts creep and a vector still has a start of its own in their slips.
  bool pass(Expansion<N>& motion, double duration_rad, double accuracy) {
    if (count() == 0) return true;
    const int most = std::min(order, motion.order() - 1);
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      if (touches(motion, i)) contacts_[i].follow(motion.contact(i), most);
    }
    const bool creeps = any_creeps(motion);
    if (creeps) before_ = tangents_;
    for (Eigen::Index column = 0; column < count(); ++column) {
      begin_column(motion, column);
      if (!creeps) {
        sum_up(expand(motion, most, duration_rad, accuracy), duration_rad, column);
      } else if (settle_creep(motion, most, duration_rad, accuracy)) {
        sum_up(most, duration_rad, column);
      } else {
        tangents_ = before_;
        return false;
      }
    }
    return true;
  }

  void put(Eigen::MatrixXd& tangents) const { tangents = tangents_; }

 private:
  using Vector = Eigen::Matrix<double, N, 1>;
  using Terms = Eigen::Matrix<double, N, Eigen::Dynamic>;

  static bool touches(Expansion<N>& motion, std::size_t i) {
    return motion.contact(i).mode() != contact::Mode::open;
  }

  static bool any_creeps(Expansion<N>& motion) {
    for (std::size_t j = 0; j < motion.sticking(); ++j) {
      if (motion.contact(motion.stuck(static_cast<Eigen::Index>(j))).creep()) return true;
    }
    return false;
  }

  /// Sweeps as of `taylor::settle_creep`, of the vector that has begun.
  bool settle_creep(Expansion<N>& motion, int most, double duration_rad, double accuracy) {
    const Vector start = rate_.col(0);
    const double size =
        std::max(w_.col(0).template lpNorm<Eigen::Infinity>(), start.template lpNorm<Eigen::Infinity>());
    contact::StickVector by(static_cast<Eigen::Index>(motion.sticking()));
    for (Eigen::Index j = 0; j < by.size(); ++j) {
      if (motion.contact(motion.stuck(j)).creep()) creeps_[motion.stuck(j)].begin(sliding(motion, j));
    }
    for (int sweep = 0; sweep < most_creep_sweeps; ++sweep) {
      expand(motion, most, duration_rad, 0);
      double change = 0;
      for (Eigen::Index j = 0; j < by.size(); ++j) {
        const std::size_t i = motion.stuck(j);
        by(j) = 0;
        if (!motion.contact(i).creep()) continue;
        creeps_[i].sweep(
            *motion.contact(i).creep(), most,
            [&](int k) { return stuck_at(k).holding[static_cast<std::size_t>(j)]; },
            [&](int k) { return contacts_[i].load_term(k); });
        change = std::max(change, creeps_[i].change(duration_rad));
        by(j) = creeps_[i].sliding()[0] - sliding(motion, j);
      }
      if (change <= share_of_sweeps * accuracy * size) break;
      change_.resize(2 * w_.rows());
      change_ << w_.col(0), rate_.col(0);
      motion.change_slips(by, change_.data());
      rate_.col(0) = change_.tail(w_.rows());
      if (sweep + 1 == most_creep_sweeps) return false;
    }
    return (rate_.col(0) - start).template lpNorm<Eigen::Infinity>() <= accuracy * size;
  }

  /// Change of the sliding speed of contact `stuck` with the vector where it starts.
  double sliding(Expansion<N>& motion, Eigen::Index stuck) const {
    const std::size_t i = motion.stuck(stuck);
    const ContactSeries& contact = motion.contact(i);
    const numerics::Twin w = contacts_[i].displacement()[0], rate = at_contact(i, rate_.col(0));
    if (!contact.law().annular) return rate[1];
    const numerics::Twin d = contact.distance()[0], v = contact.velocity()[0];
    // Of |d| times the sliding speed, which is d1 d2' - d2 d1'.
    const double product = w[0] * v[1] - w[1] * v[0] + d[0] * rate[1] - d[1] * rate[0];
    return (product - contacts_[i].length().number(0) * contact.creep()->sliding()[0]) *
           contact.inverse_length();
  }

  template <class Direction>
  numerics::Twin at_contact(std::size_t i, const Direction& of) const {
    const auto& c = system_.contacts[i];
    return numerics::Twin{c.first_row.dot(of), c.second_row.dot(of)};
  }

  void begin_column(Expansion<N>& motion, Eigen::Index column) {
    const Eigen::Index n = system_.coordinates();
    w_.col(0) = tangents_.col(column).head(n);
    rate_.col(0) = tangents_.col(column).tail(n);
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      if (touches(motion, i)) contacts_[i].begin(at_contact(i, w_.col(0)));
    }
  }

  /// Returns the order reached: with an accuracy of zero the highest.
  int expand(Expansion<N>& motion, int most, double duration_rad, double accuracy) {
    double power = 1, length = w_.col(0).template lpNorm<Eigen::Infinity>(),
           speed = rate_.col(0).template lpNorm<Eigen::Infinity>();
    int small = 0;
    for (int k = 0; k < most; ++k) {
      accelerate(motion, k);
      w_.col(k + 1) = rate_.col(k) * numerics::one_over(k + 1);
      rate_.col(k + 1) = acceleration_ * numerics::one_over(k + 1);
      power *= duration_rad;
      const double w = power * w_.col(k + 1).template lpNorm<Eigen::Infinity>(),
                   rate = power * rate_.col(k + 1).template lpNorm<Eigen::Infinity>();
      length = std::max(length, w);
      speed = std::max(speed, rate);
      small = accuracy > 0 && w <= accuracy * length && rate <= accuracy * speed ? small + 1 : 0;
      if (small == 2) return k + 1;
    }
    return most;
  }

  /// Coefficient k of the acceleration.
  void accelerate(Expansion<N>& motion, int k) {
    if (system_.diagonal) {
      acceleration_ = -system_.stiffness_diagonal.cwiseProduct(w_.col(k)) -
                      system_.damping_diagonal.cwiseProduct(rate_.col(k));
    } else {
      acceleration_.noalias() = -system_.stiffness * w_.col(k);
      acceleration_.noalias() -= system_.damping * rate_.col(k);
    }
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      if (!touches(motion, i)) continue;
      const numerics::Twin force = contacts_[i].force_term(k, at_contact(i, rate_.col(k)));
      push(i, force);
    }
    if (motion.sticking() > 0) hold(motion, k);
  }

  void push(std::size_t i, numerics::Twin force) {
    acceleration_ += system_.contacts[i].first_push * force[0];
    acceleration_ += system_.contacts[i].second_push * force[1];
  }

  /// What is kept of a contact that sticks.
  struct Sticking {
    std::array<double, contact::most_sticking> holding{};
    std::array<numerics::Twin, contact::most_sticking> acceleration{};
  };

  /// Coefficient k of what holds the contacts that stick: of d1 d2'' - d2 d1'' = (s r)' (at a flat stop d2''
  /// = s') small changes obey the derivative, with the sliding speed s as it is where they stick, and with
  /// its change where they creep.
  void hold(Expansion<N>& motion, int k) {
    const auto count = static_cast<Eigen::Index>(motion.sticking());
    Sticking& now = sticking_[static_cast<std::size_t>(k)];
    for (Eigen::Index j = 0; j < count; ++j) turn_holding(motion, j, k);
    contact::StickVector rest(count);
    for (Eigen::Index j = 0; j < count; ++j) {
      const std::size_t i = motion.stuck(j);
      rest(j) = motion.tangential_row(i).dot(acceleration_.transpose());
      if (motion.contact(i).law().annular) {
        rest(j) -= keeping_term(motion, j, k);
      } else if (motion.contact(i).creep()) {
        rest(j) -= (k + 1) * creeps_[i].sliding()[k + 1];
      }
    }
    const contact::StickVector force = contact::holding_forces(motion.mobility(), rest);
    for (Eigen::Index j = 0; j < count; ++j) {
      acceleration_ += force(j) * motion.tangential_push(motion.stuck(j));
      now.holding[static_cast<std::size_t>(j)] = force(j);
    }
    for (Eigen::Index j = 0; j < count; ++j)
      now.acceleration[static_cast<std::size_t>(j)] = at_contact(motion.stuck(j), acceleration_);
  }

  const Sticking& stuck_at(int k) const { return sticking_[static_cast<std::size_t>(k)]; }

  /// The change of the holding force, as far as it is known, along the tangent as it turns.
  void turn_holding(Expansion<N>& motion, Eigen::Index stuck, int k) {
    const std::size_t i = motion.stuck(stuck);
    if (!motion.contact(i).law().annular) return;
    numerics::Twin sum{};
    for (int j = 0; j < k; ++j)
      sum += numerics::both(stuck_at(j).holding[static_cast<std::size_t>(stuck)]) *
             motion.contact(i).normal()[k - j];
    push(i, numerics::quarter_turned(sum));
  }

  double keeping_term(Expansion<N>& motion, Eigen::Index stuck, int k) const {
    const std::size_t i = motion.stuck(stuck);
    const ContactSeries& contact = motion.contact(i);
    const numerics::PlaneSeries &d = contact.distance(), &w = contacts_[i].displacement();
    double sum = 0;
    if (contact.creep()) {
      const numerics::Series &own = creeps_[i].sliding(), &of_motion = contact.creep()->sliding();
      for (int j = 0; j <= k + 1; ++j)
        sum += contacts_[i].length().number(j) * of_motion[k + 1 - j] +
               contact.length().number(j) * own[k + 1 - j];
      sum *= k + 1;
    } else {
      const double sliding = contact.normal()[0][0] * contact.velocity()[0][1] -
                             contact.normal()[0][1] * contact.velocity()[0][0];
      sum = sliding * (k + 1) * numerics::sum_of(numerics::product_term(contact.normal(), w, k + 1))[0];
    }
    for (int j = 0; j <= k; ++j) {
      const numerics::Twin a = contact.acceleration()[k - j];
      sum -= w[j][0] * a[1] - w[j][1] * a[0];
    }
    for (int j = 1; j <= k; ++j) {
      const numerics::Twin b = stuck_at(k - j).acceleration[static_cast<std::size_t>(stuck)];
      sum -= d[j][0] * b[1] - d[j][1] * b[0];
    }
    return sum * contact.inverse_length();
  }

  void sum_up(int highest, double duration_rad, Eigen::Index column) {
    const Eigen::Index n = system_.coordinates();
    Vector w = w_.col(highest), rate = rate_.col(highest);
    for (int k = highest - 1; k >= 0; --k) {
      w = w * duration_rad + w_.col(k);
      rate = rate * duration_rad + rate_.col(k);
    }
    tangents_.col(column).head(n) = w;
    tangents_.col(column).tail(n) = rate;
  }

  const run::ScaledSystem<N>& system_;
  Eigen::MatrixXd tangents_;
  Terms w_, rate_;  ///< of one of them, by order
  Vector acceleration_;
  static constexpr double share_of_sweeps = 0.01;  ///< of the accuracy asked for
  std::vector<ContactTangent> contacts_;
  std::vector<CreepTangent> creeps_;
  Eigen::MatrixXd before_;
  Eigen::VectorXd change_;
  std::vector<Sticking> sticking_;  ///< by order
};

}  // namespace rubsweep::integrate::taylor
