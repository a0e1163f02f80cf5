#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <variant>
#include <vector>

#include "rubsweep/core/contact/friction_law.hpp"
#include "rubsweep/core/integrate/taylor/contact_directions.hpp"
#include "rubsweep/core/integrate/taylor/contact_tangent.hpp"
#include "rubsweep/core/integrate/taylor/expand_in_registers.hpp"
#include "rubsweep/core/integrate/taylor/expansion.hpp"
#include "rubsweep/core/integrate/taylor/tangent_convergence.hpp"
#include "rubsweep/core/integrate/taylor/tangent_holding.hpp"

namespace rubsweep::integrate::taylor {

/// `Count` tangent vectors of a motion side by side: w'' = -stiffness w - damping w' + variation of the
/// contacts' forces. They also keep the slip of sticking contacts.
template <int N, int Count>
class TangentBundle {
 public:
  /// Highest order: one below that of the motion, which must be known to one order more.
  static constexpr int order = numerics::most_taylor_order - 1;

  explicit TangentBundle(const run::ScaledSystem<N>& system)
      : system_(system),
        w_(system.coordinates(), Count * (order + 1)),
        rate_(system.coordinates(), Count * (order + 1)),
        acceleration_(system.coordinates(), Count),
        contacts_(system.contacts.size()) {
    const bool holds = std::ranges::any_of(system.contacts, [](const auto& c) {
      return contact::holding_coefficient(c.friction) > 0 || contact::depends_on_slip(c.friction);
    });
    holding_.assign(count, TangentHolding(system.contacts.size(), holds ? order + 1 : 0));
  }

  /// Moves columns `first` to `first` + Count - 1 over `duration_rad` of the expanded motion. Each vector is
  /// expanded until its last two terms are at most `accuracy` times its largest terms, in displacements and
  /// in rates.
  void pass(Expansion<N>& motion, double duration_rad, double accuracy, Eigen::MatrixXd& tangents,
            Eigen::Index first) {
    const int most = begin(motion, tangents, first);
    expand(motion, most, duration_rad, accuracy);
    for (Eigen::Index i = 0; i < Count; ++i) sum_up(i, duration_rad, tangents.col(first + i));
  }

  /// Moves one vector where contacts creep. False where the vector's slips still contain a transient.
  bool pass_creeping(Expansion<N>& motion, double duration_rad, double accuracy, Eigen::MatrixXd& tangents,
                     Eigen::Index column) requires(Count == 1) {
    if (!settle_creep(motion, begin(motion, tangents, column), duration_rad, accuracy)) return false;
    sum_up(0, duration_rad, tangents.col(column));
    return true;
  }

  /// Number of expansions by `pass_creeping` since the last call.
  long take_sweeps() { return std::exchange(sweeps_, 0); }

 private:
  using Vector = Eigen::Matrix<double, N, 1>;
  using Terms = Eigen::Matrix<double, N, Eigen::Dynamic>;

  /// Sets the vectors at the start of the expansion; returns the highest order.
  int begin(Expansion<N>& motion, const Eigen::MatrixXd& tangents, Eigen::Index first) {
    const int most = std::min(order, motion.order() - 1);
    const Eigen::Index n = system_.coordinates();
    for (Eigen::Index i = 0; i < Count; ++i) {
      w(0, i) = tangents.col(first + i).head(n);
      rate(0, i) = tangents.col(first + i).tail(n);
    }
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      if (!touches(motion, i)) continue;
      contacts_[i].follow(motion.contact(i), motion.jacobian(i), most);
      contacts_[i].begin(seen_by(i, 0, w_));
    }
    return most;
  }

  /// Sweeps as in `taylor::settle_creep`, for a vector that has begun.
  bool settle_creep(Expansion<N>& motion, int most, double duration_rad, double accuracy) {
    const Vector start = rate(0, 0);
    const double size =
        std::max(w(0, 0).template lpNorm<Eigen::Infinity>(), start.template lpNorm<Eigen::Infinity>());
    const StickingContacts<N>& sticking = motion.sticking();
    contact::StickVector by(static_cast<Eigen::Index>(sticking.count()));
    for (Eigen::Index j = 0; j < by.size(); ++j) {
      if (motion.contact(sticking[j]).creep()) holding_[0].creep(sticking[j]).begin(sliding(motion, j));
    }
    for (int sweep = 0; sweep < most_creep_sweeps; ++sweep) {
      expand(motion, most, duration_rad, 0);
      ++sweeps_;
      double change = 0;
      for (Eigen::Index j = 0; j < by.size(); ++j) {
        by(j) = 0;
        if (!motion.contact(sticking[j]).creep()) continue;
        change = std::max(change, swept(motion, j, most, duration_rad));
        by(j) = holding_[0].creep(sticking[j]).sliding()[0] - sliding(motion, j);
      }
      if (change <= share_of_sweeps * accuracy * size)
        return (rate(0, 0) - start).template lpNorm<Eigen::Infinity>() <= accuracy * size;
      change_.resize(2 * w_.rows());
      change_ << w(0, 0), rate(0, 0);
      motion.change_slips(by, change_.data());
      rate(0, 0) = change_.tail(w_.rows());
    }
    return false;
  }

  /// Makes one sweep of a creeping contact; returns its change.
  double swept(Expansion<N>& motion, Eigen::Index stuck, int most, double duration_rad) {
    const std::size_t i = motion.sticking()[stuck];
    CreepTangent& creep = holding_[0].creep(i);
    creep.sweep(
        *motion.contact(i).creep(), most, [&](int k) { return holding_[0].term(k, stuck); },
        [&](int k) { return contacts_[i].load_term(0, k); });
    return creep.change(duration_rad);
  }

  /// Variation of the sliding speed of contact `stuck` with the vector at the start of the expansion.
  double sliding(Expansion<N>& motion, Eigen::Index stuck) {
    const std::size_t i = motion.sticking()[stuck];
    const ContactSeries& contact = motion.contact(i);
    const numerics::Twin moved = at_contact(system_.contacts[i], w(0, 0)),
                         speed = at_contact(system_.contacts[i], rate(0, 0));
    if (!contact.law().annular) return speed[1];
    const numerics::Twin d = contact.distance()[0], v = contact.velocity()[0];
    // The variation of |d| times the sliding speed follows from this product, d1 d2' - d2 d1'.
    const double product = moved[0] * v[1] - moved[1] * v[0] + d[0] * speed[1] - d[1] * speed[0];
    return (product - contacts_[i].length_term(0, 0) * contact.creep()->sliding()[0]) *
           contact.inverse_length();
  }

  static bool touches(Expansion<N>& motion, std::size_t i) {
    return motion.contact(i).mode() != contact::Mode::open;
  }

  static constexpr auto count = static_cast<std::size_t>(Count);
  using Tangents = ContactTangents<Count>;
  using Term = typename Tangents::Term;

  // Column of coefficient k of vector i.
  static Eigen::Index place_of(int k, Eigen::Index i) { return Eigen::Index{k} * Count + i; }
  auto w(int k, Eigen::Index i) { return w_.col(place_of(k, i)); }
  auto rate(int k, Eigen::Index i) { return rate_.col(place_of(k, i)); }

  Term seen_by(std::size_t contact, int k, const Terms& of) const {
    Term all;
    for (std::size_t i = 0; i < count; ++i)
      all[i] = at_contact(system_.contacts[contact], of.col(place_of(k, static_cast<Eigen::Index>(i))));
    return all;
  }

  static auto sizes(const Terms& of, int k) {
    return of.template middleCols<Count>(place_of(k, 0)).cwiseAbs().colwise().maxCoeff().array();
  }

  /// Expands until each vector has converged (accuracy 0: to the highest order); sets the reached orders.
  void expand(Expansion<N>& motion, int most, double duration_rad, double accuracy) {
    TangentConvergence<Count> convergence(accuracy, sizes(w_, 0), sizes(rate_, 0));
    if constexpr (N != Eigen::Dynamic) {
      if (const auto contact = motion.only_slip()) {
        std::visit(
            [&](const auto& directions) {
              expand_in_registers(motion.structure(), directions, most, duration_rad, contacts_[*contact],
                                  seen_by(*contact, 0, rate_), w_, rate_, convergence);
            },
            motion.directions(*contact));
        return note_orders(convergence, most);
      }
      if (motion.flies()) {
        NoContact none;
        expand_in_registers(motion.structure(), none, most, duration_rad, none, Term{}, w_, rate_,
                            convergence);
        return note_orders(convergence, most);
      }
    }
    double power = 1;
    for (int k = 0; k < most && !convergence.all_converged(); ++k) {
      accelerate(motion, k);
      w_.template middleCols<Count>(place_of(k + 1, 0)) =
          rate_.template middleCols<Count>(place_of(k, 0)) * numerics::one_over(k + 1);
      rate_.template middleCols<Count>(place_of(k + 1, 0)) = acceleration_ * numerics::one_over(k + 1);
      if (accuracy == 0) continue;
      power *= duration_rad;
      convergence.add(k + 1, power * sizes(w_, k + 1), power * sizes(rate_, k + 1));
    }
    note_orders(convergence, most);
  }

  void note_orders(const TangentConvergence<Count>& convergence, int most) {
    for (std::size_t i = 0; i < count; ++i) reached_[i] = convergence.order(i, most);
  }

  /// Computes coefficient k of the accelerations.
  void accelerate(Expansion<N>& motion, int k) {
    for (Eigen::Index i = 0; i < Count; ++i) {
      auto a = acceleration_.col(i);
      if (system_.diagonal) {
        a = -system_.stiffness_diagonal.cwiseProduct(w(k, i)) -
            system_.damping_diagonal.cwiseProduct(rate(k, i));
      } else {
        a.noalias() = -system_.stiffness * w(k, i);
        a.noalias() -= system_.damping * rate(k, i);
      }
    }
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      if (!touches(motion, i)) continue;
      const Term force = contacts_[i].force_term(k, seen_by(i, k, rate_));
      for (std::size_t j = 0; j < count; ++j) {
        auto a = acceleration_.col(static_cast<Eigen::Index>(j));
        a += system_.contacts[i].first_push * force[j][0];
        a += system_.contacts[i].second_push * force[j][1];
      }
    }
    if (motion.sticking().count() == 0) return;
    for (std::size_t i = 0; i < count; ++i)
      holding_[i].hold(motion, system_, contacts_, i, k, acceleration_.col(static_cast<Eigen::Index>(i)));
  }

  /// Sets `tangent` to the sum of the series of vector i.
  template <class Column>
  void sum_up(Eigen::Index i, double duration_rad, Column&& tangent) {
    const Eigen::Index n = system_.coordinates();
    const int highest = reached_[static_cast<std::size_t>(i)];
    Vector sum = w(highest, i), rate_sum = rate(highest, i);
    for (int k = highest - 1; k >= 0; --k) {
      sum = sum * duration_rad + w(k, i);
      rate_sum = rate_sum * duration_rad + rate(k, i);
    }
    tangent.head(n) = sum;
    tangent.tail(n) = rate_sum;
  }

  const run::ScaledSystem<N>& system_;
  Terms w_, rate_;  ///< terms of one order are neighbours
  Eigen::Matrix<double, N, Count> acceleration_;
  std::array<int, count> reached_{};
  std::vector<Tangents> contacts_;
  std::vector<TangentHolding> holding_;            ///< for each vector
  static constexpr double share_of_sweeps = 0.01;  ///< share of the wanted accuracy
  Eigen::VectorXd change_;
  long sweeps_ = 0;
};

}  // namespace rubsweep::integrate::taylor
