#include "support/long_double_reference.hpp"

#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

namespace rubsweep::test {
namespace {

using Real = long double;
using State = OneSideState<Real>;

/// One step within the present piece of the force law.
State stepped(const OneSideEquations<Real>& equations, const State& from, Real t, Real h) {
  boost::numeric::odeint::runge_kutta_fehlberg78<State, Real, State, Real> stepper;
  State to = from;
  stepper.do_step(equations, from, t, to, h);
  return to;
}

/// Largest part of `h` after which the state still belongs to `piece`, by bisection.
Real part_in_piece(const OneSideEquations<Real>& equations, const State& from, Real t, Real h) {
  Real inside = 0, outside = h;
  for (int i = 0; i < 64; ++i) {
    const Real middle = (inside + outside) / 2;
    const bool stays = equations.piece_of(stepped(equations, from, t, middle)) == equations.piece;
    (stays ? inside : outside) = middle;
  }
  return outside;
}

}  // namespace

std::vector<State> long_double_sections(const OneSideRotor& rotor, int turns, int steps_per_turn) {
  OneSideEquations<Real> equations(rotor);
  State state = equations.start();
  std::vector<State> sections{state};
  const Real period = 1 / Real(rotor.speed_hz);
  Real t = 0;
  equations.piece = equations.piece_of(state);
  for (int turn = 0; turn < turns; ++turn) {
    const Real end = (turn + 1) * period;
    while (t < end) {
      Real h = std::min(period / steps_per_turn, end - t);
      const bool last = h == end - t;
      const bool to_kick_end = t < equations.kick_s && t + h > equations.kick_s;
      if (to_kick_end) h = equations.kick_s - t;
      State next = stepped(equations, state, t, h);
      const bool leaves = equations.piece_of(next) != equations.piece;
      if (leaves) {
        h = part_in_piece(equations, state, t, h);
        next = stepped(equations, state, t, h);
        equations.piece = equations.piece_of(next);
      }
      t = to_kick_end && !leaves ? equations.kick_s : last && !leaves && !to_kick_end ? end : t + h;
      state = next;
    }
    sections.push_back(state);
  }
  return sections;
}

}  // namespace rubsweep::test
