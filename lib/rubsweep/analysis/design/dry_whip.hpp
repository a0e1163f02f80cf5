#pragma once

#include <complex>
#include <cstddef>
#include <optional>

#include "rubsweep/core/model/friction.hpp"
#include "rubsweep/core/scene/prepared_machine.hpp"

namespace rubsweep::design {

/// Friction coefficient mu that a backward circular whirl at w > 0 needs in an annular stop (H. F. Black, J.
/// Mech. Eng. Sci. 10, 1968, 1-12; here with the wall's stiffness). The receptance G of the rotor against its
/// casing is the sum of the receptances of both: z = G f e^{-i w t}, in metres per newton. The stop acts on
/// the rotor with -N (1 + i mu) along the whirl, so that Im (1 + i mu) G = 0 and mu = -Im G / Re G. Empty
/// where a wall of this stiffness allows no such whirl: -Re (1 + i mu) G >= 1 / stiffness is needed. A result
/// < 0 means that the rotor whirls backward without friction.
std::optional<double> friction_of_dry_whip(std::complex<double> receptance_m_per_n, double stiffness_n_per_m);

/// Dry whip with the least friction in an annular stop.
struct DryWhip {
  double least_friction = 0;  ///< dry whip is impossible with less friction
  double whirl_hz = 0;        ///< frequency of the backward whirl, > 0
  double speed_hz = 0;        ///< speed of the shaft
};

/// Dry whip with the least friction at one shaft speed W. `stop` is the index of an annular stop, which is
/// treated as centred. Covers all whirls not faster than rolling, w clearance <= contact radius W. For a
/// Jeffcott rotor in a rigid stop of stiffness ratio b the least friction is 2 zeta sqrt(1 + b) / b, at
/// sqrt(1 + b) times the natural frequency. If a kit differs in x and y, the mean of both is used. Empty
/// where no friction leads to dry whip.
std::optional<DryWhip> least_dry_whip(const scene::PreparedMachine& prepared, std::size_t stop,
                                      double speed_hz);

/// Largest coefficient, >= 0, that a friction law has up to a slip speed.
double largest_friction(const model::Friction& friction, double slip_m_per_s);

}  // namespace rubsweep::design
