#include "rubsweep/measurement/diagnose/inference/simulated_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

#include "rubsweep/core/error.hpp"
#include "rubsweep/measurement/diagnose/random_stream.hpp"

namespace rubsweep::diagnose::inference {
namespace {

/// Rub of a candidate's machine; empty where it does not rub.
std::optional<LastingMotion> rub_of(const Candidate& asked, const Point& values,
                                    const model::Machine& machine, double speed_hz, int turns,
                                    const scene::Unbalance& unbalance,
                                    response::spectrum::SpectrumWorkspace& workspace) {
  // Whirls far deeper than a machine survives take most time where the contact has an exponent.
  constexpr double hopeless = 4;
  std::optional<double> most_force_n;
  if (value_of(values, Unknown::exponent) > 1)
    most_force_n = force_at_penetration_n(asked.cause, values, simulated_clearance_m(asked),
                                          hopeless * usual_penetration_ratio);
  return rubbing_motion(machine, speed_hz, unbalance, turns, workspace, most_force_n);
}

/// Whether a machine survives this motion. The penetration scales with the clearance, as all lengths do, so
/// the ratio does not change.
bool survives(const Candidate& asked, const Point& values, const LastingMotion& motion) {
  return penetration_ratio(asked.cause, values, simulated_clearance_m(asked),
                           motion.contact.peak_contact_force_n) <= usual_penetration_ratio;
}

/// Whirl of an unbalance, over its eccentricity, at this speed and this natural frequency. Near the
/// resonance, where it depends on the damping, 1 / (2 damping ratio) is taken to be 20.
double quiet_whirl(double speed, double natural_frequency) {
  const double squared = std::pow(speed / natural_frequency, 2);
  return natural_frequency > 0 ? squared / std::max(std::abs(1 - squared), 0.05) : 1;
}

}  // namespace

Measuring at_speed(Measuring measuring, double factor) {
  measuring.readings_per_turn /= factor;
  measuring.natural_order /= factor;
  return measuring;
}

double simulated_clearance_m(const Candidate& candidate) {
  return std::sqrt(candidate.clearance_m.low * candidate.clearance_m.high);
}

std::optional<LastingMotion> run_again(const DiagnosisProblem& problem, const SimulatedCase& one,
                                       double speed_hz, int turns, bool kicked,
                                       response::spectrum::SpectrumWorkspace& workspace) {
  const Candidate& asked = problem.candidates[one.candidate];
  const bool rubs = asked.cause != Cause::no_rub;
  const scene::Eccentricity unbalance{one.motion.eccentricity_m};
  const Point values = values_at(asked, one.unit);
  // Without rub, any stop that is far enough leaves the motion as it is.
  const double clearance_m = (rubs ? 1 : 1e3) * simulated_clearance_m(asked);
  try {
    model::Machine machine = drawn_machine(asked.cause, values, clearance_m, problem.fixed);
    if (!kicked) machine.kick.reset();
    if (rubs)
      if (auto motion = rub_of(asked, values, machine, speed_hz, turns, unbalance, workspace))
        return survives(asked, values, *motion) ? motion : std::nullopt;
    machine.kick.reset();
    return motion_without_contact(machine, speed_hz, unbalance, turns, workspace);
  } catch (const ConfigError&) {
    return std::nullopt;
  }
}

std::optional<SimulatedCase> simulate_case(const DiagnosisProblem& problem, std::size_t candidate,
                                           const Point& unit,
                                           response::spectrum::SpectrumWorkspace& workspace) {
  const Candidate& asked = problem.candidates[candidate];
  const Point values = values_at(asked, unit);
  const scene::WhirlRatio unbalance{value_of(values, Unknown::whirl_ratio)};
  SimulatedCase simulated{.candidate = candidate, .unit = unit};
  try {
    const model::Machine machine =
        drawn_machine(asked.cause, values, simulated_clearance_m(asked), problem.fixed);
    auto motion = asked.cause == Cause::no_rub
                      ? motion_without_contact(machine, problem.speed_hz, unbalance, problem.turns, workspace)
                      : rub_of(asked, values, machine, problem.speed_hz, problem.turns, unbalance, workspace);
    if (!motion || !survives(asked, values, *motion)) return std::nullopt;
    simulated.motion = *std::move(motion);
  } catch (const ConfigError&) {
    // Each of these numbers is allowed, but the machine that they make together is not.
    return std::nullopt;
  }
  for (std::size_t k = 0; k < problem.further_speeds_hz.size(); ++k) {
    RandomStream random(problem.seed, std::bit_cast<std::uint64_t>(unit.front()) + k,
                        DrawPurpose::of_further_speed);
    const bool kicked = random.uniform() < 0.5;
    auto motion =
        run_again(problem, simulated, problem.further_speeds_hz[k], problem.turns, kicked, workspace);
    if (!motion) return std::nullopt;
    simulated.further.push_back(std::move(motion->lines));
  }
  return simulated;
}

void add_further(const DiagnosisProblem& problem, std::size_t stretch,
                 const features::DescribedMotion& further, features::DescribedMotion& seen) {
  const double speed_hz = problem.further_speeds_hz[stretch], order = problem.measuring.natural_order,
               grown = std::log10(further.size_m / seen.size_m),
               as_quiet = std::log10(quiet_whirl(speed_hz / problem.speed_hz, order) / quiet_whirl(1, order));
  const std::string at = fmt::format(" at {:.4g} Hz", speed_hz);
  features::add(seen.features, "size" + at, grown);
  features::add(seen.features, "size off the resonance" + at, std::abs(grown - as_quiet));
  for (const features::Feature& feature : further.features)
    features::add(seen.features, feature.name + at, feature.value);
}

void observe_further(const DiagnosisProblem& problem, std::size_t stretch, const MotionLines& lines,
                     double usual_size_m, RandomStream& random, ObservedCase& observation,
                     response::spectrum::SpectrumWorkspace& workspace) {
  const double speed_hz = problem.further_speeds_hz[stretch];
  Measuring there = at_speed(problem.measuring, speed_hz / problem.speed_hz);
  // A single probe stays where it is.
  there.directions = true;
  there.probe_angle_rad = observation.probe_angle_rad;
  const MotionLines further =
      observed(up_to(lines, seen_order(there)), there, random, observation.probe_angle_rad, usual_size_m);
  add_further(problem, stretch, features::describe(further, view_of(problem.measuring), workspace),
              observation.seen);
}

ObservedCase observe(const DiagnosisProblem& problem, const SimulatedCase& simulated, std::size_t index,
                     response::spectrum::SpectrumWorkspace& workspace) {
  RandomStream random(problem.seed, index, DrawPurpose::of_observation);
  ObservedCase observation;
  const MotionLines lines = observed(up_to(simulated.motion.lines, seen_order(problem.measuring)),
                                     problem.measuring, random, observation.probe_angle_rad);
  observation.seen = features::describe(lines, view_of(problem.measuring), workspace);
  for (std::size_t k = 0; k < problem.further_speeds_hz.size(); ++k)
    observe_further(problem, k, simulated.further[k], size_of(simulated.motion.lines), random, observation,
                    workspace);
  return observation;
}

}  // namespace rubsweep::diagnose::inference
