#pragma once

#include <optional>
#include <span>
#include <string>

#include "rubsweep/analysis/branch/orbits/orbit_problem.hpp"
#include "rubsweep/core/integrate/run/turn.hpp"

namespace rubsweep::branch::orbits {

using Switches = std::span<const integrate::run::ModeSwitch>;

/// Whether two closed orbits go through the same contact modes, contact by contact. Their first turns may
/// start at different places.
bool same_sequence(Switches a, Switches b);

/// Whether two orbits have the same sequence, and the contacts without a change of mode are open on both or
/// touch on both.
bool same_contact(const OrbitFacts& a, const OrbitFacts& b);

/// Whether `a` is richer than `b`: it has more hits, or as many hits and more changes.
bool is_richer(Switches a, Switches b);

/// Difference between the sequences of two closed orbits at one contact: one stretch of the richer sequence
/// is missing in the other sequence, and all other changes agree.
struct SequenceChange {
  enum class Kind {
    hit,           ///< the stretch is a hit, missing on the other orbit
    interruption,  ///< the stretch leaves a touching mode and returns to it
    parting,       ///< the stretch is a flight that divides a hit of the other orbit into two
    even,          ///< one orbit touches along its whole period and the other one nowhere
  };
  Kind kind = Kind::hit;
  int contact = 0;
  contact::Mode from = contact::Mode::open;  ///< mode that is interrupted, or in which the flight begins
  contact::Mode to = contact::Mode::open;    ///< first mode of the stretch
  /// Duration of the stretch, in shaft rotation. It is zero at the graze, and grows as the square root of the
  /// distance from it.
  double duration_rad = 0;
  double middle_rad = 0;  ///< middle of the stretch, as a phase of the richer orbit
};

/// Shortest stretch that differs; empty where the sequences differ otherwise. `period_rad`: period of the
/// orbits.
std::optional<SequenceChange> sequence_change(Switches richer, Switches poorer, double period_rad);

/// Description such as "hit at stop 0", "clamped interrupted at stop 1", "flight within a hit at stop 0".
std::string describe(const SequenceChange& change);

}  // namespace rubsweep::branch::orbits
