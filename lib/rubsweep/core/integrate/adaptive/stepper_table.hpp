#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "rubsweep/core/integrate/adaptive/step_method.hpp"
#include "rubsweep/core/integrate/run/options.hpp"

namespace rubsweep::integrate::adaptive {

/// Properties of one stepper. The configuration, the tables of rubbench, `--explain` and make_step_method
/// read them here.
struct StepperRow {
  run::Stepper stepper = run::Stepper::automatic;
  std::string_view word;         ///< name in the configuration and in tables
  std::string_view description;  ///< name, order and how states inside a step are made, for --explain
  std::unique_ptr<StepMethod> (*make)(const run::SolverOptions&) = nullptr;  ///< see make_step_method
};

/// One row for each value of Stepper, in the order of the enumeration: `automatic` first.
std::span<const StepperRow> stepper_table();

/// The row of `stepper`. Throws SolverError for a number that is no value of Stepper.
const StepperRow& row_of(run::Stepper stepper);

/// The steppers that take every step by one method: all but `automatic`, which is one of them at each step.
std::span<const run::Stepper> single_steppers();

}  // namespace rubsweep::integrate::adaptive
