#include "rubsweep/bench/reference.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "rubsweep/error.hpp"
#include "rubsweep/integrate/start.hpp"

namespace rubsweep::bench {
namespace {

integrate::Turn turn_after(const scene::Scene& scene, int turns, const integrate::SolverOptions& options) {
  integrate::ExactPlans plans;
  const integrate::Run run = integrate::start(scene, options, plans);
  integrate::Turn turn;
  for (int k = 0; k < turns; ++k) {
    const integrate::Outcome outcome = run.advance(turn);
    if (outcome != integrate::Outcome::ok) {
      throw ConfigError("this cell has no reference for the state error, choose another: " +
                        std::string(integrate::to_string(outcome)));
    }
  }
  return turn;
}

integrate::SolverOptions adaptive(integrate::SolverOptions options, integrate::Stepper stepper) {
  options.method = integrate::Method::adaptive;
  options.stepper = stepper;
  return options;
}

}  // namespace

integrate::SolverOptions reference_options(integrate::SolverOptions base, double relative_tolerance) {
  base.method = integrate::Method::automatic;
  base.stepper = integrate::Stepper::rkf78;
  base.contact = integrate::ContactHandling::located;
  base.relative_tolerance = relative_tolerance;
  // A limit that is there to stop the variants is none for what they are measured against.
  base.max_steps_per_revolution =
      std::max(base.max_steps_per_revolution, integrate::SolverOptions{}.max_steps_per_revolution);
  return base;
}

Reference reference_section(const scene::Scene& scene, int turns, const integrate::SolverOptions& base) {
  const integrate::SolverOptions options = reference_options(base);
  const integrate::Turn best = turn_after(scene, turns, options);
  const auto against = [&](integrate::Stepper stepper) {
    return section_difference(best.section, turn_after(scene, turns, adaptive(options, stepper)).section);
  };
  return {.section = best.section,
          .against_rkf78 = against(integrate::Stepper::rkf78),
          .against_dopri5 = against(integrate::Stepper::dopri5),
          .closed_forms = integrate::solver_of(scene, options) == integrate::Solver::exact &&
                          best.effort.adaptive_turns == 0};
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
