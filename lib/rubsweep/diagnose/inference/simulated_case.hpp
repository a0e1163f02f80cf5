#pragma once

#include <cstddef>
#include <optional>

#include "rubsweep/diagnose/features/described_motion.hpp"
#include "rubsweep/diagnose/inference/diagnosis_problem.hpp"
#include "rubsweep/diagnose/lasting_motion.hpp"

namespace rubsweep::diagnose::inference {

/// One motion of one candidate. Without gravity everything grows with the clearance, so that it is simulated
/// at one clearance for all, and scaled to a recording.
struct SimulatedCase {
  std::size_t candidate = 0;
  Point unit{};  ///< places of its unknowns in the unit cube
  LastingMotion motion{};
  bool proposed = false;  ///< drawn near cases that resemble a recording, not from the priors
};

/// Clearance that cases are simulated at: the geometric mean of the candidate's bounds, m.
double simulated_clearance_m(const Candidate& candidate);

/// Simulates a candidate with these numbers; empty where it does not rub (no_rub: where it does), or cannot
/// be run.
std::optional<SimulatedCase> simulate_case(const DiagnosisProblem& problem, std::size_t candidate,
                                           const Point& unit,
                                           response::spectrum::SpectrumWorkspace& workspace);

/// A case as the instrument shows it. Depends on problem, case and index alone.
struct ObservedCase {
  features::DescribedMotion seen{};
  double probe_angle_rad = 0;  ///< of one probe: from the stop's direction
};
ObservedCase observe(const DiagnosisProblem& problem, const SimulatedCase& simulated, std::size_t index,
                     response::spectrum::SpectrumWorkspace& workspace);

}  // namespace rubsweep::diagnose::inference
