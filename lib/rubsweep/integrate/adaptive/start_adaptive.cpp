#include "rubsweep/integrate/adaptive/start_adaptive.hpp"

#include "rubsweep/error.hpp"

namespace rubsweep::integrate::adaptive {

run::Cursor start_adaptive(const scene::Scene& scene, const run::SolverOptions& options) {
  switch (options.stepper) {
    case run::Stepper::automatic:
    case run::Stepper::dopri5:
      return detail::start_dopri5(scene, options);
    case run::Stepper::cash_karp54:
      return detail::start_cash_karp54(scene, options);
    case run::Stepper::rkf78:
      return detail::start_rkf78(scene, options);
    case run::Stepper::bulirsch_stoer:
      return detail::start_bulirsch_stoer(scene, options);
    case run::Stepper::rosenbrock4:
      return detail::start_rosenbrock4(scene, options);
  }
  throw SolverError("start_adaptive: unknown stepper");
}

}  // namespace rubsweep::integrate::adaptive
