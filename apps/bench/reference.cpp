#include "bench/reference.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "bench/long_double_run.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/integrate/start.hpp"

namespace rubsweep::bench {
namespace {

integrate::run::TurnReport turn_after(const scene::Scene& scene, int turns,
                                      const integrate::run::SolverOptions& options) {
  integrate::exact::modes::ModeCache modes;
  const integrate::run::Run run = integrate::start(scene, options, modes);
  integrate::run::TurnReport turn;
  for (int k = 0; k < turns; ++k) {
    const integrate::run::Outcome outcome = run.advance({}, turn);
    if (outcome != integrate::run::Outcome::ok) {
      throw ConfigError("this cell has no reference for the state error, choose another: " +
                        std::string(integrate::run::to_string(outcome)));
    }
  }
  return turn;
}

integrate::run::SolverOptions adaptive(integrate::run::SolverOptions options,
                                       integrate::run::Stepper stepper) {
  options.method = integrate::run::Method::adaptive;
  options.stepper = stepper;
  return options;
}

LongDoubleRun::State long_double_section(const scene::Scene& scene, int turns, long double tolerance) {
  LongDoubleRun run(scene, tolerance);
  for (int k = 0; k < turns; ++k) run.advance_turn();
  return run.section();
}

/// Replaces the section in double by a section in long double, if one can be computed.
void use_long_double(const scene::Scene& scene, int turns, Reference& reference) {
  if (!LongDoubleRun::applies(scene) || scene.structure.coordinates() > most_long_double_coordinates) return;
  try {
    const auto best = long_double_section(scene, turns, long_double_tolerance),
               looser = long_double_section(scene, turns, 100 * long_double_tolerance);
    for (std::size_t k = 0; k < best.size(); ++k) {
      reference.section[k] = static_cast<double>(best[k]);
      const long double rounded = std::abs(best[k] - static_cast<long double>(reference.section[k]));
      reference.long_double_error =
          std::max(reference.long_double_error, static_cast<double>(std::abs(best[k] - looser[k]) + rounded));
    }
    reference.long_double = true;
  } catch (const SolverError&) {
    // Long double is too slow for this scene: the exact solver stays the reference.
  }
}

}  // namespace

integrate::run::SolverOptions reference_options(integrate::run::SolverOptions base,
                                                double relative_tolerance) {
  base.method = integrate::run::Method::automatic;
  base.stepper = integrate::run::Stepper::rkf78;
  base.contact = integrate::run::ContactHandling::located;
  base.relative_tolerance = relative_tolerance;
  // The reference may take more steps than the limit that stops the variants.
  base.max_steps_per_revolution =
      std::max(base.max_steps_per_revolution, integrate::run::SolverOptions{}.max_steps_per_revolution);
  return base;
}

Reference reference_section(const scene::Scene& scene, int turns, const integrate::run::SolverOptions& base) {
  const integrate::run::SolverOptions options = reference_options(base);
  const integrate::run::TurnReport best = turn_after(scene, turns, options);
  const auto against = [&](integrate::run::Stepper stepper) {
    return section_difference(best.section, turn_after(scene, turns, adaptive(options, stepper)).section);
  };
  Reference reference{.section = best.section,
                      .against_rkf78 = against(integrate::run::Stepper::rkf78),
                      .against_dopri5 = against(integrate::run::Stepper::dopri5),
                      .closed_forms = integrate::solver_of(scene, options) == integrate::Solver::exact &&
                                      best.effort.adaptive_turns == 0 && best.effort.taylor_turns == 0};
  use_long_double(scene, turns, reference);
  return reference;
}

double section_difference(std::span<const double> a, std::span<const double> b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double difference = std::abs(a[i] - b[i]);
    if (std::isnan(difference)) return difference;
    largest = std::max(largest, difference);
  }
  return largest;
}

}  // namespace rubsweep::bench
