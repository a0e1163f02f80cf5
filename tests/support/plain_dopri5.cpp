#include "support/plain_dopri5.hpp"

#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

namespace rubsweep::test {

PlainRun run_plain_dopri5(const OneSideRotor& rotor, int turns, double relative_tolerance) {
  namespace odeint = boost::numeric::odeint;
  using State = OneSideState<double>;
  const OneSideEquations<double> equations(rotor);
  PlainRun run{equations.start(), 0};
  const auto counted = [&](const State& x, State& rate, double t) {
    ++run.rhs_calls;
    equations(x, rate, t);
  };
  auto stepper = odeint::make_controlled(1e-3 * relative_tolerance, relative_tolerance,
                                         odeint::runge_kutta_dopri5<State>());
  const double end = turns / rotor.speed_hz;
  odeint::integrate_adaptive(stepper, counted, run.state, 0.0, end, 1e-6);
  return run;
}

}  // namespace rubsweep::test
