#include "rubsweep/measurement/fit/fit_problem.hpp"

#include <cstddef>
#include <variant>

#include "rubsweep/core/scene/prepared_machine.hpp"

namespace rubsweep::fit {

double value_named(const MachineFit& problem, const Eigen::VectorXd& values, const char* name,
                   double otherwise) {
  for (std::size_t i = 0; i < problem.parameters.size(); ++i)
    if (problem.parameters[i].name == name) return values(static_cast<Eigen::Index>(i));
  return otherwise;
}

scene::PreparedMachine prepare_again(const model::Machine& machine, const scene::PreparedMachine& first) {
  if (!std::holds_alternative<model::RotorKit>(machine.rotor) || !first.reduction)
    return scene::prepare_machine(machine);
  return scene::prepare_with_modes(machine, first.reduction->modes);
}

}  // namespace rubsweep::fit
