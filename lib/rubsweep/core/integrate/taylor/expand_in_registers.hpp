#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>

#include "rubsweep/core/integrate/run/scaled_system.hpp"
#include "rubsweep/core/integrate/taylor/contact_series.hpp"
#include "rubsweep/core/integrate/taylor/contact_tangent.hpp"
#include "rubsweep/core/integrate/taylor/state_pairs.hpp"
#include "rubsweep/core/integrate/taylor/state_series.hpp"
#include "rubsweep/core/integrate/taylor/tangent_convergence.hpp"
#include "rubsweep/core/numerics/taylor_series.hpp"
#include "rubsweep/core/numerics/twin.hpp"

namespace rubsweep::integrate::taylor {

/// A diagonal structure with its coordinates in pairs, and the forces on it.
template <int N>
struct DiagonalStructure {
  using Pairs = StatePairs<N>;

  explicit DiagonalStructure(const run::ScaledSystem<N>& system)
      : stiffness(system.stiffness_diagonal),
        damping(system.damping_diagonal),
        constant(system.constant),
        cosines(system.cosine),
        sines(system.sine) {}

  /// Deceleration of a pair by springs and dampers.
  numerics::Twin resistance(std::size_t pair, numerics::Twin moved, numerics::Twin rate) const {
    return stiffness[pair] * moved + damping[pair] * rate;
  }

  Pairs stiffness, damping, constant, cosines, sines;
};

/// Coefficients of the drives cosine * cosines + sine * sines, in order of k; each is stored twice.
struct DriveTerms {
  numerics::Twin cosine, sine;

  /// Advances to the next coefficient, with `next` = 1 / its order.
  void advance(numerics::Twin next) {
    const numerics::Twin turned = cosine;
    cosine = -(next * sine);
    sine = next * turned;
  }
};

/// Coefficient k of the acceleration of a pair, without contacts.
template <int N>
numerics::Twin free_term(const DiagonalStructure<N>& structure, const DriveTerms& drives, int k,
                         std::size_t pair, numerics::Twin moved, numerics::Twin rate) {
  const numerics::Twin term =
      (structure.cosines[pair] * drives.cosine + structure.sines[pair] * drives.sine) -
      structure.resistance(pair, moved, rate);
  return k == 0 ? term + structure.constant[pair] : term;
}

/// Computes all coefficients of a motion from the start of `series`, with `drives`, at most one touching
/// contact, which must slip, and no pulse. The series of motion and contact must have begun. This recurrence
/// is the critical path: coefficient k + 1 needs only the structural terms and the contact force.
template <int N, class Directions, class Contact>
void expand_in_registers(const DiagonalStructure<N>& structure, const Directions& directions,
                         DriveTerms drives, Contact& contact, StateSeries<N>& series) {
  using numerics::both, numerics::Twin;
  using Pairs = StatePairs<N>;
  Pairs u(series.u(0)), v(series.v(0));
  for (int k = 0; k < series.order(); ++k) {
    const Twin next = numerics::one_over_twice(k + 1), after = numerics::one_over_twice(k + 2);
    Pairs a;
    typename Directions::Seen seen{};
    for (std::size_t h = 0; h < Pairs::count; ++h) {
      a[h] = free_term(structure, drives, k, h, u[h], v[h]);
      directions.see(h, a[h], seen);
    }
    drives.advance(next);
    const typename Directions::Force force(contact.force_term(k));
    contact.set_velocity(k + 1, directions.total(seen, force) * next);
    double *to_u = series.u(k + 2).data(), *to_v = series.v(k + 1).data();
    for (std::size_t h = 0; h < Pairs::count; ++h) {
      u[h] = v[h] * next;
      v[h] = directions.pushed(h, a[h], force) * next;
      numerics::store(to_v + 2 * h, v[h]);
      numerics::store(to_u + 2 * h, v[h] * after);
    }
  }
}

/// Computes the coefficients of `Count` tangent vectors side by side, until they have converged over
/// `duration_rad` or for `most` terms. Displacements are columns k Count + i of `w`, rates are these columns
/// of `rate`. The contact's variations must have begun; `speed` is the variation of its relative velocity.
template <int N, class Directions, int Count, class Contact, class Terms>
void expand_in_registers(const DiagonalStructure<N>& structure, const Directions& directions, int most,
                         double duration_rad, Contact& contact, typename ContactTangents<Count>::Term speed,
                         Terms& w, Terms& rate, TangentConvergence<Count>& convergence) {
  using numerics::both, numerics::Twin;
  using Pairs = StatePairs<N>;
  std::array<Pairs, static_cast<std::size_t>(Count)> moved, changed;
  for (std::size_t i = 0; i < moved.size(); ++i) {
    moved[i] = Pairs(w.col(static_cast<Eigen::Index>(i)));
    changed[i] = Pairs(rate.col(static_cast<Eigen::Index>(i)));
  }
  typename TangentConvergence<Count>::Sizes size, rate_size;
  double power = 1;
  for (int k = 0; k < most && !convergence.all_converged(); ++k) {
    const Twin next = numerics::one_over_twice(k + 1);
    const auto forces = contact.force_term(k, speed);
    power *= duration_rad;
    for (std::size_t i = 0; i < moved.size(); ++i) {
      const auto column = static_cast<Eigen::Index>(i), place = Eigen::Index{k + 1} * Count + column;
      const typename Directions::Force force(forces[i]);
      typename Directions::Seen seen{};
      Twin largest{}, largest_rate{};
      double *to_w = w.col(place).data(), *to_rate = rate.col(place).data();
      for (std::size_t h = 0; h < Pairs::count; ++h) {
        const Twin free = -structure.resistance(h, moved[i][h], changed[i][h]);
        directions.see(h, free, seen);
        moved[i][h] = changed[i][h] * next;
        changed[i][h] = directions.pushed(h, free, force) * next;
        numerics::store(to_w + 2 * h, moved[i][h]);
        numerics::store(to_rate + 2 * h, changed[i][h]);
        largest = numerics::larger(largest, numerics::magnitudes(moved[i][h]));
        largest_rate = numerics::larger(largest_rate, numerics::magnitudes(changed[i][h]));
      }
      speed[i] = directions.total(seen, force) * next;
      size[column] = power * std::max(largest[0], largest[1]);
      rate_size[column] = power * std::max(largest_rate[0], largest_rate[1]);
    }
    convergence.add(k + 1, size, rate_size);
  }
}

}  // namespace rubsweep::integrate::taylor
