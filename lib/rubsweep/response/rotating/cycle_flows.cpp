#include "rubsweep/response/rotating/cycle_flows.hpp"

#include <algorithm>

namespace rubsweep::response::rotating {
namespace {

using Eigen::VectorXd;

constexpr double first_tolerance = 1e-4, rough_tolerance = 1e-6, tolerance_of_a_cycle = 1e-8;

}  // namespace

CycleFlows::CycleFlows(const scene::Scene& scene, const integrate::run::SolverOptions& solver,
                       int samples_per_revolution)
    : exactly(RotatingFlow(scene, solver, samples_per_revolution)
                  .with(std::min(solver.relative_tolerance, tolerance_of_a_cycle), samples_per_revolution)),
      roughly(exactly.with(rough_tolerance, 0)),
      at_first(exactly.with(first_tolerance, 0)) {}

RotatingMotion CycleFlows::motion(const RotatingField& field) const {
  const auto from = [](const RotatingFlow& flow) {
    return [&flow](const VectorXd& state, double angle_rad) { return flow.from(state, angle_rad); };
  };
  return {[&field](const VectorXd& state) { return field.rate(state); }, from(at_first), from(roughly),
          from(exactly),
          [this](const VectorXd& state, double angle_rad) { return roughly.end_from(state, angle_rad); }};
}

}  // namespace rubsweep::response::rotating
