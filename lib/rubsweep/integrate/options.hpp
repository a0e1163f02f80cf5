#pragma once

#include "rubsweep/model/range.hpp"

namespace rubsweep::integrate {

enum class Method { automatic, adaptive };
enum class Stepper { dopri5, cash_karp54, rkf78, bulirsch_stoer, rosenbrock4 };

/// How a stepper meets a change of contact mode.
enum class ContactHandling {
  located,   ///< stops at every mode switch, found to rounding
  smoothed,  ///< integrates through, with a C1 blend of the law over `smoothing_m`
};

struct SolverOptions {
  Method method = Method::automatic;
  Stepper stepper = Stepper::dopri5;
  ContactHandling contact = ContactHandling::located;
  double relative_tolerance = 1e-8;  ///< absolute tolerance is this times (clearance, clearance omega)
  double smoothing_m = 1e-7;         ///< penetration width of the blend, `smoothed` only
  long max_steps_per_revolution = 1'000'000;  ///< accepted and refused steps; more ends the run as step_limit

  static constexpr model::Range relative_tolerance_range{.low = 1e-14, .high = 1e-2};
  static constexpr model::Range smoothing_range = model::positive;
  static constexpr long max_steps_low = 1000;
};

}  // namespace rubsweep::integrate
