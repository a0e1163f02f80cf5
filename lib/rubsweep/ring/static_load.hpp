#pragma once

#include <vector>

#include "rubsweep/ring/system.hpp"

namespace rubsweep::ring {

/// Premises of the linear model at one speed, one entry per load.
struct StaticLoad {
  std::vector<double> normal_n;  ///< force of the load on the ring in the steady state; positive: it presses
  std::vector<double> slip_m_per_s;  ///< speed of the tip over the ring's surface in the steady state

  /// Whether every load presses and slips forward, as the model assumes of contact and friction.
  bool valid() const;
};

/// Steady state under preload and centrifugal force. Where K is singular the forces are not finite. Needs the
/// radius of the ring.
StaticLoad static_load(const System& system, double speed_rad_per_s);

}  // namespace rubsweep::ring
