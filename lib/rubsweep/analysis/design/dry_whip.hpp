#pragma once

#include <complex>
#include <cstddef>
#include <optional>

#include "rubsweep/core/model/friction.hpp"
#include "rubsweep/core/scene/prepared_machine.hpp"

namespace rubsweep::design {

/// Friction that a backward circular whirl at w > 0 in an annular stop needs, from the receptance G of the
/// rotor against its casing: z = G f e^{-i w t}, metres per newton, the sum of the receptances of both. The
/// stop presses the rotor with -N (1 + i mu) towards the whirl, so that Im (1 + i mu) G = 0 and mu = -Im G /
/// Re G. Empty where there is no such whirl against a wall of this stiffness: -Re (1 + i mu) G >= 1 /
/// stiffness is needed. Below 0: the rotor whirls backward by itself. (H. F. Black, J. Mech. Eng. Sci. 10,
/// 1968, 1-12; with the wall's stiffness.)
std::optional<double> friction_of_dry_whip(std::complex<double> receptance_m_per_n, double stiffness_n_per_m);

/// The dry whip of an annular stop that needs least friction.
struct DryWhip {
  double least_friction = 0;  ///< below it there is none
  double whirl_hz = 0;        ///< backward, > 0
  double speed_hz = 0;        ///< speed of the shaft
};

/// The least friction of dry whip of stop `stop`, an annular one that is taken as centred, at one speed of
/// the shaft: over all whirls that are not faster than rolling, w clearance <= contact radius W. Of a
/// Jeffcott rotor in a rigid stop of stiffness ratio b it is 2 zeta sqrt(1 + b) / b, at the whirl sqrt(1 + b)
/// times the natural frequency. Where a kit differs in x and y, its mean over both. Empty where there is no
/// dry whip at any friction.
std::optional<DryWhip> least_dry_whip(const scene::PreparedMachine& prepared, std::size_t stop,
                                      double speed_hz);

/// The largest coefficient that a friction may have up to a slip speed, >= 0.
double largest_friction(const model::Friction& friction, double slip_m_per_s);

}  // namespace rubsweep::design
