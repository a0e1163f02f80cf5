#include "rubsweep/integrate/adaptive.hpp"

#include "rubsweep/error.hpp"

namespace rubsweep::integrate {

Cursor start_adaptive(const scene::Scene& scene, const SolverOptions& options) {
  switch (options.stepper) {
    case Stepper::automatic:
    case Stepper::dopri5:
      return detail::start_dopri5(scene, options);
    case Stepper::cash_karp54:
      return detail::start_cash_karp54(scene, options);
    case Stepper::rkf78:
      return detail::start_rkf78(scene, options);
    case Stepper::bulirsch_stoer:
      return detail::start_bulirsch_stoer(scene, options);
    case Stepper::rosenbrock4:
      return detail::start_rosenbrock4(scene, options);
  }
  throw SolverError("start_adaptive: unknown stepper");
}

}  // namespace rubsweep::integrate
