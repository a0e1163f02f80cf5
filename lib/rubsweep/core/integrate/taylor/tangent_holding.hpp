#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "rubsweep/core/contact/dry_friction.hpp"
#include "rubsweep/core/integrate/run/scaled_system.hpp"
#include "rubsweep/core/integrate/taylor/contact_directions.hpp"
#include "rubsweep/core/integrate/taylor/contact_tangent.hpp"
#include "rubsweep/core/integrate/taylor/creep_tangent.hpp"
#include "rubsweep/core/integrate/taylor/expansion.hpp"
#include "rubsweep/core/numerics/taylor_series.hpp"

namespace rubsweep::integrate::taylor {

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
    const auto stuck = static_cast<Eigen::Index>(motion.sticking());
    for (Eigen::Index j = 0; j < stuck; ++j) {
      const std::size_t i = motion.stuck(j);
      if (!motion.contact(i).law().annular) continue;
      const numerics::Twin turned = turned_term(motion.contact(i), j, k);
      acceleration += system.contacts[i].first_push * turned[0];
      acceleration += system.contacts[i].second_push * turned[1];
    }
    contact::StickVector rest(stuck);
    for (Eigen::Index j = 0; j < stuck; ++j) {
      const std::size_t i = motion.stuck(j);
      rest(j) = motion.tangential_row(i).dot(acceleration.transpose()) -
                keeping_term(motion.contact(i), contacts[i], which, creeps_[i], j, k);
    }
    const contact::StickVector force = contact::holding_forces(motion.mobility(), rest);
    for (Eigen::Index j = 0; j < stuck; ++j)
      acceleration += force(j) * motion.tangential_push(motion.stuck(j));
    Term& now = terms_[static_cast<std::size_t>(k)];
    for (Eigen::Index j = 0; j < stuck; ++j) {
      const auto at = static_cast<std::size_t>(j);
      now.force[at] = force(j);
      now.acceleration[at] = at_contact(system.contacts[motion.stuck(j)], acceleration);
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
