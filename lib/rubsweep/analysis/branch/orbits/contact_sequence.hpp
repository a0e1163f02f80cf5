#pragma once

#include <optional>
#include <span>
#include <string>

#include "rubsweep/analysis/branch/orbits/orbit_problem.hpp"
#include "rubsweep/core/integrate/run/turn.hpp"

namespace rubsweep::branch::orbits {

using Switches = std::span<const integrate::run::ModeSwitch>;

/// Whether two closed orbits go through the same contact modes, contact by contact, wherever on the orbit its
/// first turn begins.
bool same_sequence(Switches a, Switches b);

/// The same of two orbits, whose contacts that never change their mode are open or touch alike.
bool same_contact(const OrbitFacts& a, const OrbitFacts& b);

/// The sequence with more hits, and of two with as many the one with more changes.
bool is_richer(Switches a, Switches b);

/// Where the sequence of the richer one of two closed orbits differs from that of the other, at one contact:
/// all changes but those of one stretch agree.
struct SequenceChange {
  enum class Kind {
    hit,           ///< the stretch is a hit, without which the orbits agree
    interruption,  ///< the stretch leads from a touching mode back to it
    parting,       ///< the stretch is a flight that parts one hit of the other orbit into two
    even,  ///< contact all along on one orbit and nowhere on the other: no stretch, but all of it at once
  };
  Kind kind = Kind::hit;
  int contact = 0;
  contact::Mode from = contact::Mode::open;  ///< the mode that is interrupted, or that the flight begins in
  contact::Mode to = contact::Mode::open;    ///< first mode of the stretch
  /// Duration of the stretch, in shaft rotation: zero at the graze, and grows as the square root of the
  /// distance to it.
  double duration_rad = 0;
  double middle_rad = 0;  ///< middle of the stretch, in phases of the richer orbit
};

/// The shortest such stretch; empty where the sequences differ otherwise. `period_rad`: of the orbits.
std::optional<SequenceChange> sequence_change(Switches richer, Switches poorer, double period_rad);

/// "hit at stop 0", "clamped interrupted at stop 1", "flight within a hit at stop 0".
std::string describe(const SequenceChange& change);

}  // namespace rubsweep::branch::orbits
