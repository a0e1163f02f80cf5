#include "rubsweep/measurement/diagnose/inference/simulated_case.hpp"

#include <cmath>

#include "rubsweep/core/error.hpp"
#include "rubsweep/measurement/diagnose/random_stream.hpp"

namespace rubsweep::diagnose::inference {

double simulated_clearance_m(const Candidate& candidate) {
  return std::sqrt(candidate.clearance_m.low * candidate.clearance_m.high);
}

std::optional<SimulatedCase> simulate_case(const DiagnosisProblem& problem, std::size_t candidate,
                                           const Point& unit,
                                           response::spectrum::SpectrumWorkspace& workspace) {
  const Candidate& asked = problem.candidates[candidate];
  const Point values = values_at(asked, unit);
  const scene::WhirlRatio unbalance{value_of(values, Unknown::whirl_ratio)};
  try {
    const double clearance_m = simulated_clearance_m(asked);
    const model::Machine machine = drawn_machine(asked.cause, values, clearance_m, problem.fixed);
    // Whirls far deeper than a machine survives take most time where the contact has an exponent.
    constexpr double hopeless = 4;
    std::optional<double> most_force_n;
    if (value_of(values, Unknown::exponent) > 1)
      most_force_n =
          force_at_penetration_n(asked.cause, values, clearance_m, hopeless * usual_penetration_ratio);
    auto motion =
        asked.cause == Cause::no_rub
            ? motion_without_contact(machine, problem.speed_hz, unbalance, problem.turns, workspace)
            : rubbing_motion(machine, problem.speed_hz, unbalance, problem.turns, workspace, most_force_n);
    // The penetration scales with the clearance, as all lengths do, so the ratio does not change.
    if (!motion || penetration_ratio(asked.cause, values, clearance_m, motion->contact.peak_contact_force_n) >
                       usual_penetration_ratio)
      return std::nullopt;
    return SimulatedCase{.candidate = candidate, .unit = unit, .motion = *std::move(motion)};
  } catch (const ConfigError&) {
    // Each of these numbers is allowed, but the machine that they make together is not.
    return std::nullopt;
  }
}

ObservedCase observe(const DiagnosisProblem& problem, const SimulatedCase& simulated, std::size_t index,
                     response::spectrum::SpectrumWorkspace& workspace) {
  RandomStream random(problem.seed, index, DrawPurpose::of_observation);
  ObservedCase observation;
  const MotionLines lines = observed(up_to(simulated.motion.lines, seen_order(problem.measuring)),
                                     problem.measuring, random, observation.probe_angle_rad);
  observation.seen = features::describe(lines, view_of(problem.measuring), workspace);
  return observation;
}

}  // namespace rubsweep::diagnose::inference
