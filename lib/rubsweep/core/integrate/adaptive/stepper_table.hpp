#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "rubsweep/core/integrate/adaptive/step_method.hpp"
#include "rubsweep/core/integrate/run/options.hpp"

namespace rubsweep::integrate::adaptive {

/// Properties of one stepper. The configuration, the tables of rubbench, `--explain` and make_step_method use
/// this table.
struct StepperRow {
  run::Stepper stepper = run::Stepper::automatic;
  std::string_view word;         ///< name in the configuration and in tables
  std::string_view description;  ///< name, order and interpolation inside a step, for --explain
  std::unique_ptr<StepMethod> (*make)(const run::SolverOptions&) = nullptr;  ///< see make_step_method
};

/// One row for each value of Stepper, in the order of the enumeration: `automatic` first.
std::span<const StepperRow> stepper_table();

/// Row of `stepper`. Throws SolverError for a number that is not a Stepper.
const StepperRow& row_of(run::Stepper stepper);

/// Steppers that use one method for all steps: all except `automatic`, which chooses a method for each step.
std::span<const run::Stepper> single_steppers();

}  // namespace rubsweep::integrate::adaptive
