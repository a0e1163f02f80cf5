#pragma once

#include "rubsweep/core/numerics/taylor_series.hpp"

namespace rubsweep::integrate::taylor {

/// Relation of a regular time s and the phase: the pace d phase / ds > 0 as a power series of s, up to one
/// order below the highest.
struct RegularTime {
  numerics::Series pace;

  double pace_at(double s) const;
  /// Advance of the phase in radians from s = 0 on.
  double phase_after(double s) const;
  /// The s of an advance of the phase, from 0 to `end`.
  double parameter_at(double advance_rad, double end) const;
};

}  // namespace rubsweep::integrate::taylor
