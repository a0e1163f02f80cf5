#pragma once

#include <utility>

#include "rubsweep/core/integrate/run/scaled_system.hpp"

namespace rubsweep::integrate::law {

/// Copy of a system that a right-hand side may change. It is a base class so that it exists before the base
/// that refers to it.
template <int N>
struct OwnSystem {
  explicit OwnSystem(run::ScaledSystem<N> system) : own(std::move(system)) {}
  run::ScaledSystem<N> own;
};

}  // namespace rubsweep::integrate::law
