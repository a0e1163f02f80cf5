#pragma once

#include <string>
#include <vector>

#include "rubsweep/ring/changes.hpp"
#include "rubsweep/ring/closed_forms.hpp"
#include "rubsweep/ring/track.hpp"

namespace rubsweep::ring {

/// Change of stability at one speed. Kinds: divergence_begin, divergence_end (a real root crosses zero);
/// flutter_begin, flutter_end (the real part of a pair crosses zero); coupling_begin, coupling_end (two
/// neutral pairs merge or separate again, without friction); real_split (a pair becomes two real roots),
/// real_merger (the reverse); veering (closest approach of two frequencies that do not merge); stable_from,
/// stable_to.
struct Onset {
  std::string kind;
  double speed_rad_per_s = 0;
  std::vector<std::string> modes;
  std::string note;
};

/// Adds the onsets of changes of the signature, or only those of coupling modes, with the names of their
/// modes (no names without a track).
void add_onsets(const std::vector<Change>& changes, const Track& track, bool has_friction,
                std::vector<Onset>& onsets, bool only_couplings = false);

/// Range of speeds in which the same modes are unstable in the same way.
struct Regime {
  double from_rad_per_s = 0, to_rad_per_s = 0;
  std::string text;  ///< "stable", or "divergence of ...; flutter of ..."
  bool stable = false;
};

/// Stability of one system over one range of speeds.
struct Analysis {
  Track track;
  std::vector<Onset> onsets;    ///< ascending speed
  std::vector<Regime> regimes;  ///< ascending speed, without gaps
  std::vector<CriticalSpeed> critical_speeds;
};

/// Analyses a system at `speeds_rad_per_s`, ascending and at least one. Onsets are sought between these
/// speeds and further speeds that mode tracking adds. Two onsets between the same two speeds may be missed.
/// With friction, pairs do not couple. Coupling ranges and veerings are therefore those of the same system
/// without friction, and are marked so.
Analysis analyse(const System& system, const std::vector<double>& speeds_rad_per_s);

}  // namespace rubsweep::ring
