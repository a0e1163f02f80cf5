#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "rubsweep/measurement/diagnose/candidate.hpp"
#include "rubsweep/measurement/diagnose/drawn_machine.hpp"
#include "rubsweep/measurement/diagnose/features/described_motion.hpp"
#include "rubsweep/measurement/diagnose/observed_lines.hpp"
#include "rubsweep/measurement/diagnose/simulated_motion.hpp"

namespace rubsweep::diagnose::inference {

/// Everything that decides which motions are compared with a recording.
struct DiagnosisProblem {
  std::vector<Candidate> candidates{};  ///< candidates; their natural frequency and damping are the machine's
  std::vector<double> prior{};  ///< probability of each candidate if one of them is the cause; the sum is 1
  FixedNumbers fixed{};
  std::optional<Spread>
      eccentricity_m{};  ///< eccentricity of the unbalance, > 0, logarithmic; empty: not known
  double speed_hz = 0;   ///< speed of the shaft
  int turns = 0;         ///< turns of the shaft in the recording
  Measuring measuring{};
  std::uint64_t seed = 1;
};

inline features::View view_of(const Measuring& measuring) {
  return {measuring.probes == 2, measuring.directions, measuring.from_rest};
}

/// Largest order that the readings of a turn show without aliasing.
inline double seen_order(const Measuring& measuring) {
  constexpr double clean_share = 0.4;  // share as in scope::most_order_looked_at
  return std::min(most_order, clean_share * measuring.readings_per_turn);
}

/// One motion of one candidate. Without gravity all lengths are proportional to the clearance. The motion is
/// therefore simulated at one clearance and then scaled to a recording.
struct SimulatedCase {
  std::size_t candidate = 0;
  Point unit{};  ///< place of its unknowns in the unit cube
  LastingMotion motion{};
};

/// Clearance at which cases are simulated: geometric mean of the candidate's bounds, m.
double simulated_clearance_m(const Candidate& candidate);

/// Simulates a candidate at a point of the unit cube. Empty where the machine does not rub (for no_rub: where
/// it rubs), where it cannot be simulated, or where the penetration exceeds usual_penetration_ratio, which no
/// machine survives.
std::optional<SimulatedCase> simulate_case(const DiagnosisProblem& problem, std::size_t candidate,
                                           const Point& unit,
                                           response::spectrum::SpectrumWorkspace& workspace);

/// A case as the instrument measures it. It depends on the problem, the case and its index alone.
struct ObservedCase {
  features::DescribedMotion seen{};
  double probe_angle_rad = 0;  ///< angle of a single probe from the stop's direction
};
ObservedCase observe(const DiagnosisProblem& problem, const SimulatedCase& simulated, std::size_t index,
                     response::spectrum::SpectrumWorkspace& workspace);

}  // namespace rubsweep::diagnose::inference
