#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>

#include "rubsweep/integrate/run/scaled_system.hpp"
#include "rubsweep/integrate/taylor/contact_series.hpp"
#include "rubsweep/integrate/taylor/contact_tangent.hpp"
#include "rubsweep/integrate/taylor/state_pairs.hpp"
#include "rubsweep/integrate/taylor/state_series.hpp"
#include "rubsweep/integrate/taylor/tangent_convergence.hpp"
#include "rubsweep/numerics/plane_series.hpp"
#include "rubsweep/numerics/taylor_series.hpp"

namespace rubsweep::integrate::taylor {

/// A diagonal structure and one stop of it. Where it touches no other one and slips there, which is the usual
/// step, what an expansion waits for is the contact, whose next coefficient comes from what the structure
/// does of itself and from the force alone.
template <int N>
struct TouchedStructure {
  using Pairs = StatePairs<N>;

  TouchedStructure(const run::ScaledSystem<N>& system, std::size_t contact)
      : stiffness(system.stiffness_diagonal),
        damping(system.damping_diagonal),
        first_push(system.contacts[contact].first_push),
        second_push(system.contacts[contact].second_push),
        first_row(system.contacts[contact].first_row),
        second_row(system.contacts[contact].second_row) {
    const auto& c = system.contacts[contact];
    by_first = numerics::Twin{c.first_row.dot(c.first_push), c.second_row.dot(c.first_push)};
    by_second = numerics::Twin{c.first_row.dot(c.second_push), c.second_row.dot(c.second_push)};
  }

  Pairs stiffness, damping, first_push, second_push, first_row, second_row;
  /// What a newton along either of the contact's directions accelerates of the contact itself.
  numerics::Twin by_first, by_second;
};

/// A force on a casing, each of its components twice.
struct TwiceForce {
  explicit TwiceForce(numerics::Twin force)
      : first(numerics::first_twice(force)), second(numerics::second_twice(force)) {}
  numerics::Twin first, second;
};

/// All coefficients of a motion from where `series` and `contact` start, by drives cosine * system.cosine +
/// sine * system.sine; no pulse acts.
template <int N>
void expand_in_registers(const run::ScaledSystem<N>& system, const TouchedStructure<N>& structure,
                         double cosine, double sine, ContactSeries& contact, StateSeries<N>& series) {
  using numerics::both, numerics::Twin;
  using Pairs = StatePairs<N>;
  const Pairs cosines(system.cosine), sines(system.sine), constant(system.constant);
  Pairs u(series.u(0)), v(series.v(0));
  Twin by_cosine = both(cosine), by_sine = both(sine);
  for (int k = 0; k < series.order(); ++k) {
    const Twin next = both(numerics::one_over(k + 1)), after = both(numerics::one_over(k + 2));
    Pairs a;
    Twin along_first{}, along_second{};
    for (std::size_t h = 0; h < Pairs::count; ++h) {
      a[h] = (cosines[h] * by_cosine + sines[h] * by_sine) -
             (structure.stiffness[h] * u[h] + structure.damping[h] * v[h]);
      if (k == 0) a[h] += constant[h];
      along_first += structure.first_row[h] * a[h];
      along_second += structure.second_row[h] * a[h];
    }
    const Twin turned = by_cosine;
    by_cosine = -(next * by_sine);
    by_sine = next * turned;
    const TwiceForce force(contact.force_term(k));
    contact.set_velocity(k + 1, (numerics::sums_of(along_first, along_second) +
                                 structure.by_first * force.first + structure.by_second * force.second) *
                                    next);
    double *to_u = series.u(k + 2).data(), *to_v = series.v(k + 1).data();
    for (std::size_t h = 0; h < Pairs::count; ++h) {
      u[h] = v[h] * next;
      v[h] = (a[h] + structure.first_push[h] * force.first + structure.second_push[h] * force.second) * next;
      numerics::store(to_v + 2 * h, v[h]);
      numerics::store(to_u + 2 * h, v[h] * after);
    }
  }
}

/// The same of `Count` tangent vectors side by side, whose displacements are columns k Count + i of `w` and
/// rates of `rate`, until they have converged over `duration_rad` or for `most` terms. The contact's changes
/// have begun; `speed` is the change of its relative velocity.
template <int N, int Count, class Terms>
void expand_in_registers(const TouchedStructure<N>& structure, int most, double duration_rad,
                         ContactTangents<Count>& contact, typename ContactTangents<Count>::Term speed,
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
    const Twin next = both(numerics::one_over(k + 1));
    const auto forces = contact.force_term(k, speed);
    power *= duration_rad;
    for (std::size_t i = 0; i < moved.size(); ++i) {
      const auto column = static_cast<Eigen::Index>(i), place = Eigen::Index{k + 1} * Count + column;
      const TwiceForce force(forces[i]);
      Twin along_first{}, along_second{}, largest{}, largest_rate{};
      double *to_w = w.col(place).data(), *to_rate = rate.col(place).data();
      for (std::size_t h = 0; h < Pairs::count; ++h) {
        const Twin free = -(structure.stiffness[h] * moved[i][h] + structure.damping[h] * changed[i][h]);
        along_first += structure.first_row[h] * free;
        along_second += structure.second_row[h] * free;
        moved[i][h] = changed[i][h] * next;
        changed[i][h] =
            (free + structure.first_push[h] * force.first + structure.second_push[h] * force.second) * next;
        numerics::store(to_w + 2 * h, moved[i][h]);
        numerics::store(to_rate + 2 * h, changed[i][h]);
        largest = numerics::larger(largest, numerics::magnitudes(moved[i][h]));
        largest_rate = numerics::larger(largest_rate, numerics::magnitudes(changed[i][h]));
      }
      speed[i] = (numerics::sums_of(along_first, along_second) + structure.by_first * force.first +
                  structure.by_second * force.second) *
                 next;
      size[column] = power * std::max(largest[0], largest[1]);
      rate_size[column] = power * std::max(largest_rate[0], largest_rate[1]);
    }
    convergence.add(k + 1, size, rate_size);
  }
}

}  // namespace rubsweep::integrate::taylor
