#pragma once

#include "rubsweep/core/integrate/run/scaled_system.hpp"

namespace rubsweep::integrate::law {

/// A copy that a right-hand side may change as it goes, for a base of it that refers to one: it must be there
/// before that base is.
template <int N>
struct OwnSystem {
  explicit OwnSystem(const run::ScaledSystem<N>& system) : own(system) {}
  run::ScaledSystem<N> own;
};

}  // namespace rubsweep::integrate::law
