#pragma once

#include <array>
#include <optional>

namespace rubsweep::numerics {

/// Control ordinates of a polynomial of degree 4 over [0, 1] (Bernstein form): the curve stays inside their
/// hull, which turns "no root here" from a guess by sampling into a proof.
using Quartic = std::array<double, 5>;

/// The quartic with the given end values, end slopes (per unit of the interval) and middle value.
Quartic quartic_through(double start, double start_slope, double middle, double end, double end_slope);

/// True when a cubic with these end values and slopes clears zero from below by a quarter of its hull's
/// height, so that a guard function with this cubic Hermite interpolant needs no closer look.
bool clearly_below_zero(double start, double start_slope, double end, double end_slope);

/// Smallest argument in (0, 1] at which the quartic rises from below zero to zero or above; empty when it
/// never does. A quartic that starts at or above zero must first fall below. Resolution 1e-12.
std::optional<double> bernstein_root(const Quartic& quartic);

}  // namespace rubsweep::numerics
