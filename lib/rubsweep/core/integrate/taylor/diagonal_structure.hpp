#pragma once

#include <cstddef>

#include "rubsweep/core/integrate/run/scaled_system.hpp"
#include "rubsweep/core/integrate/taylor/state_pairs.hpp"
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

}  // namespace rubsweep::integrate::taylor
