#pragma once

#include <string>
#include <vector>

#include "rubsweep/ring/closed_forms.hpp"
#include "rubsweep/ring/onsets.hpp"
#include "rubsweep/ring/track.hpp"

namespace rubsweep::ring {

/// A range of speeds over which the same modes are unstable in the same way.
struct Regime {
  double from_rad_per_s = 0, to_rad_per_s = 0;
  std::string text;  ///< "stable", or "divergence of ...; flutter of ..."
  bool stable = false;
};

/// Everything about one system over one range of speeds.
struct Analysis {
  Track track;
  std::vector<Onset> onsets;    ///< ascending speed
  std::vector<Regime> regimes;  ///< ascending speed, without gaps
  std::vector<CriticalSpeed> critical_speeds;
};

/// `speeds_rad_per_s`: ascending, at least one. Onsets are sought between them and between the speeds that
/// the tracking of modes adds; a pair of onsets so close that neither sees it goes unnoticed. With friction
/// the couplings of pairs unfold: their ranges and the veerings are those of the same system without
/// friction, and say so.
Analysis analyse(const System& system, const std::vector<double>& speeds_rad_per_s);

}  // namespace rubsweep::ring
