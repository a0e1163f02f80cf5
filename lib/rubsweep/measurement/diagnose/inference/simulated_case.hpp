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
  std::optional<Spread> eccentricity_m{};  ///< of the unbalance, > 0, logarithmic; empty: not known
  double speed_hz = 0;                     ///< speed of the shaft
  int turns = 0;                           ///< turns of the shaft in the recording
  Measuring measuring{};
  std::uint64_t seed = 1;
  /// Speeds of further stretches of a run-up, as many turns each. The machine and its unbalance are the same.
  std::vector<double> further_speeds_hz{};
};

/// The same instrument while the shaft turns `factor` times as fast.
Measuring at_speed(Measuring measuring, double factor);

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
  std::vector<MotionLines> further{};  ///< lines at DiagnosisProblem::further_speeds_hz
};

/// Clearance at which cases are simulated: geometric mean of the candidate's bounds, m.
double simulated_clearance_m(const Candidate& candidate);

/// Simulates a candidate at a point of the unit cube. Empty where the machine does not rub (for no_rub: where
/// it rubs), where it cannot be simulated, or where the penetration exceeds usual_penetration_ratio, which no
/// machine survives. At a further speed the kick acts again in every second case.
std::optional<SimulatedCase> simulate_case(const DiagnosisProblem& problem, std::size_t candidate,
                                           const Point& unit,
                                           response::spectrum::SpectrumWorkspace& workspace);

/// Motion of a case's machine at another speed or over more turns: its rub, or else its quiet whirl.
/// `kicked`: whether the kick acts again. Empty where it cannot be simulated or rubs too deep.
std::optional<LastingMotion> run_again(const DiagnosisProblem& problem, const SimulatedCase& one,
                                       double speed_hz, int turns, bool kicked,
                                       response::spectrum::SpectrumWorkspace& workspace);

/// Adds the features of a further stretch, and two of its size: over that at the first speed, and how far
/// this is from the growth of a quiet whirl.
void add_further(const DiagnosisProblem& problem, std::size_t stretch,
                 const features::DescribedMotion& further, features::DescribedMotion& seen);

/// A case as the instrument measures it. It depends on the problem, the case and its index alone.
struct ObservedCase {
  features::DescribedMotion seen{};
  double probe_angle_rad = 0;  ///< angle of a single probe from the stop's direction
};
/// Adds a further stretch with these lines as the instrument measures it; `usual_size_m` as in observed.
void observe_further(const DiagnosisProblem& problem, std::size_t stretch, const MotionLines& lines,
                     double usual_size_m, RandomStream& random, ObservedCase& observation,
                     response::spectrum::SpectrumWorkspace& workspace);

ObservedCase observe(const DiagnosisProblem& problem, const SimulatedCase& simulated, std::size_t index,
                     response::spectrum::SpectrumWorkspace& workspace);

}  // namespace rubsweep::diagnose::inference
