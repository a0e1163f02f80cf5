#pragma once

#include "rubsweep/core/integrate/adaptive/start_adaptive.hpp"

namespace rubsweep::integrate::adaptive {

inline run::SolverOptions with(run::Stepper stepper, double tolerance,
                               run::ContactHandling contact = run::ContactHandling::located) {
  run::SolverOptions options;
  options.stepper = stepper;
  options.relative_tolerance = tolerance;
  options.contact = contact;
  return options;
}

}  // namespace rubsweep::integrate::adaptive
