#pragma once

#include <array>
#include <variant>

#include "rubsweep/model/range.hpp"

namespace rubsweep::model {

struct NoFriction {};

/// mu(v) = coefficient for every slip speed: never reverses. A run whose slip would reverse says so in its
/// status.
struct ConstantFriction {
  double coefficient = required;
  static constexpr Range coefficient_range{.low = 0, .high = 10};
};

/// mu(v) = g1 (tanh g2 v - tanh g3 v) + g4 tanh g5 v + g6 v (Ishibashi & Kawai eq. 17; Makkar et al. 2005).
/// gamma[0..5] = g1 [-], g2 [s/m], g3 [s/m], g4 [-], g5 [s/m], g6 [s/m]; v slip speed in m/s.
struct StribeckFriction {
  std::array<double, 6> gamma{};
};

using Friction = std::variant<NoFriction, ConstantFriction, StribeckFriction>;

}  // namespace rubsweep::model
