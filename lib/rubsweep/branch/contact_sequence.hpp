#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "rubsweep/integrate/run/turn.hpp"

namespace rubsweep::branch {

using Switches = std::span<const integrate::run::ModeSwitch>;

/// Whether two closed orbits go through the same contact modes, contact by contact, wherever on the orbit its
/// first turn begins.
bool same_sequence(Switches a, Switches b);

/// Changes of contact mode that the richer one of two orbits has and the other has not: one block of the richer
/// one's sequence at one contact, from a mode back to the same mode, without which the sequences agree.
struct ExtraBlock {
  int contact = 0;
  contact::Mode from = contact::Mode::open;  ///< the mode that it interrupts: open, and it is a hit
  double duration_rad = 0;                   ///< of shaft rotation: zero at the graze, and grows as the square
                                             ///< root of the distance to it
};

/// The shortest such block; empty where the sequences differ otherwise. `period_rad`: of the orbits.
std::optional<ExtraBlock> extra_block(Switches richer, Switches poorer, double period_rad);

/// "hit at stop 0" or "clamped interrupted at stop 1".
std::string describe(const ExtraBlock& block);

}  // namespace rubsweep::branch
