#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "rubsweep/core/contact/dry_friction.hpp"
#include "rubsweep/core/integrate/run/scaled_system.hpp"
#include "rubsweep/core/integrate/taylor/contact_directions.hpp"
#include "rubsweep/core/integrate/taylor/contact_tangent.hpp"
#include "rubsweep/core/integrate/taylor/creep.hpp"
#include "rubsweep/core/integrate/taylor/expansion.hpp"
#include "rubsweep/core/numerics/taylor_series.hpp"

namespace rubsweep::integrate::taylor {

/// Variation of the sliding speed of a creeping contact, found by sweeps like the sliding speed itself.
class CreepTangent {
 public:
  /// Starts with a constant variation, its value at the start of the expansion.
  void begin(double sliding) {
    for (int k = 0; k <= numerics::most_taylor_order + 1; ++k) sliding_.set(k, k == 0 ? sliding : 0);
  }

  /// Sets the variation of the slip to the value that the varied friction requires, up to `order` terms.
  /// `holding(k)` and `load(k)` are the coefficients of the variations of this friction and of the spring
  /// force S. Friction is mu S, and the variation of mu is mu' times that of the sliding speed.
  template <class Holding, class Load>
  void sweep(const Creep& creep, int order, const Holding& holding, const Load& load) {
    for (int k = 0; k < order; ++k) {
      load_.set(k, load(k));
      double rest = holding(k) - creep.coefficient()[0] * load_[k];
      if (k > 0) {
        rest -= creep.coefficient()[k] * load_[0] + inner_sum(creep.coefficient(), load_, k) +
                creep.load()[k] * coefficient_[0] + inner_sum(creep.load(), coefficient_, k);
      }
      coefficient_.set(k, rest / creep.load()[0]);
      rest = coefficient_[k];
      if (k > 0) rest -= creep.slope()[k] * sliding_[0] + inner_sum(creep.slope(), sliding_, k);
      const double sliding = rest / creep.slope()[0];
      change_[k] = sliding - sliding_[k];
      sliding_.set(k, sliding);
    }
    order_ = order;
  }

  const numerics::Series& sliding() const { return sliding_; }
  /// Largest term of the change by the latest sweep, within `duration_rad`.
  double change(double duration_rad) const {
    double largest = 0, power = 1;
    for (int k = 0; k < order_; ++k, power *= duration_rad)
      largest = std::max(largest, power * std::abs(change_[k]));
    return largest;
  }

 private:
  int order_ = 0;
  numerics::Series sliding_, load_, coefficient_;
  double change_[numerics::most_taylor_order + 1];
};

/// Variation, along a tangent vector, of the friction that holds contacts that stick or creep, as power
/// series.
class TangentHolding {
 public:
  /// Makes room for these numbers of contacts and terms; no terms are needed where nothing can be held.
  TangentHolding(std::size_t contacts, std::size_t terms) : terms_(terms), creeps_(contacts) {}

  /// Variation of the sliding speed of a contact that creeps.
  CreepTangent& creep(std::size_t contact) { return creeps_[contact]; }
  /// Coefficient k of the variation of the friction at contact `Expansion::stuck(stuck)`.
  double term(int k, Eigen::Index stuck) const {
    return terms_[static_cast<std::size_t>(k)].force[static_cast<std::size_t>(stuck)];
  }

  /// Computes coefficient k of the variations of the holding forces and adds their accelerations to that of
  /// the vector. `which`: index of the vector within the variations `contacts`. Small changes obey the
  /// derivative of d1 d2'' - d2 d1'' = (s r)' (at a flat stop d2'' = s'). The sliding speed s is constant in
  /// sticking contacts and varies in creeping ones.
  template <int N, int Count, class Column>
  void hold(const Expansion<N>& motion, const run::ScaledSystem<N>& system,
            const std::vector<ContactTangents<Count>>& contacts, std::size_t which, int k,
            Column acceleration) {
    const StickingContacts<N>& sticking = motion.sticking();
    const auto stuck = static_cast<Eigen::Index>(sticking.count());
    for (Eigen::Index j = 0; j < stuck; ++j) {
      const std::size_t i = sticking[j];
      if (!motion.contact(i).law().annular) continue;
      const numerics::Twin turned = turned_term(motion.contact(i), j, k);
      acceleration += system.contacts[i].first_push * turned[0];
      acceleration += system.contacts[i].second_push * turned[1];
    }
    contact::StickVector rest(stuck);
    for (Eigen::Index j = 0; j < stuck; ++j) {
      const std::size_t i = sticking[j];
      rest(j) = sticking.row(i, motion.contact(i)).dot(acceleration.transpose()) -
                keeping_term(motion.contact(i), contacts[i], which, creeps_[i], j, k);
    }
    const contact::StickVector force = contact::holding_forces(sticking.mobility(), rest);
    for (Eigen::Index j = 0; j < stuck; ++j)
      acceleration += force(j) * sticking.push(sticking[j], motion.contact(sticking[j]));
    Term& now = terms_[static_cast<std::size_t>(k)];
    for (Eigen::Index j = 0; j < stuck; ++j) {
      const auto at = static_cast<std::size_t>(j);
      now.force[at] = force(j);
      now.acceleration[at] = at_contact(system.contacts[sticking[j]], acceleration);
    }
  }

 private:
  /// Coefficients of all sticking contacts: the friction, and the relative acceleration.
  struct Term {
    std::array<double, contact::most_sticking> force{};
    std::array<numerics::Twin, contact::most_sticking> acceleration{};
  };

  /// Variation of the friction along the turning tangent, from the coefficients known so far.
  numerics::Twin turned_term(const ContactSeries& contact, Eigen::Index stuck, int k) const {
    numerics::Twin sum{};
    for (int j = 0; j < k; ++j) sum += numerics::both(term(j, stuck)) * contact.normal()[k - j];
    return numerics::quarter_turned(sum);
  }

  /// Coefficient k of (tangent at the start) . (change of d'') for which the slip stays constant, or follows
  /// its change in a creeping contact.
  template <int Count>
  double keeping_term(const ContactSeries& contact, const ContactTangents<Count>& changes, std::size_t which,
                      const CreepTangent& creep, Eigen::Index stuck, int k) const {
    if (!contact.law().annular) return contact.creep() ? (k + 1) * creep.sliding()[k + 1] : 0;
    const numerics::PlaneSeries& d = contact.distance();
    const auto w = changes.displacement().member(which);
    double sum = 0;
    if (contact.creep()) {
      sum = (k + 1) * creeping_term(contact, changes, which, creep, k + 1);
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
      const numerics::Twin b =
          terms_[static_cast<std::size_t>(k - j)].acceleration[static_cast<std::size_t>(stuck)];
      sum -= d[j][0] * b[1] - d[j][1] * b[0];
    }
    return sum * contact.inverse_length();
  }

  /// Coefficient k of the variation of s r, the product of sliding speed and distance.
  template <int Count>
  static double creeping_term(const ContactSeries& contact, const ContactTangents<Count>& changes,
                              std::size_t which, const CreepTangent& creep, int k) {
    const numerics::Series &own = creep.sliding(), &of_motion = contact.creep()->sliding();
    double sum = 0;
    for (int j = 0; j <= k; ++j)
      sum += changes.length_term(which, j) * of_motion[k - j] + contact.length().number(j) * own[k - j];
    return sum;
  }

  std::vector<Term> terms_;
  std::vector<CreepTangent> creeps_;  ///< creep of each contact
};

}  // namespace rubsweep::integrate::taylor
