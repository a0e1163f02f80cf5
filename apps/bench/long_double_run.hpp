#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "rubsweep/core/contact/contact_mode.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::bench {

/// Any scene that it applies to, turn by turn in long double by a route of its own, slow and readable: what
/// the errors of solvers in double are measured against. Runge-Kutta-Fehlberg 7(8) from Boost.Odeint inside
/// each contact mode, the ends of modes and pulses met by a bracketing search over the length of the step.
/// States are those of integrate::run::TurnReport::section. It takes matrices and contacts from the scene;
/// a test beside it has one rotor from its parameters alone, and so checks the scene too.
class LongDoubleRun {
 public:
  using Real = long double;
  using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
  using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
  using State = std::vector<Real>;

  /// False beside dry friction, torsion and impulse trains.
  static bool applies(const scene::Scene& scene);

  /// Throws std::invalid_argument where it does not apply. `tolerance`: bound on the stepper's estimate of
  /// one step's error, in sections.
  LongDoubleRun(const scene::Scene& scene, Real tolerance);

  const State& section() const { return state_; }
  /// Puts the run at the start of turn `turn`.
  void restart(const State& section, int turn);
  /// Throws SolverError after more steps than anybody would wait for.
  void advance_turn();

 private:
  struct Contact {
    scene::Contact law;
    Matrix relative;  ///< 2 x n: to rotor - casing, in units of length
    Eigen::Matrix<Real, 2, 1> offset;
    Real clearance, spring_n, damper_n;
    contact::Mode mode = contact::Mode::open;
  };
  struct Motion {
    Eigen::Matrix<Real, 2, 1> normal;
    Real penetration, closing_speed, sliding_speed;
  };
  struct Pulse {
    Vector force;
    Real start, end;
  };
  struct Ended {
    std::size_t contact;
    contact::Mode next;
  };

  Motion motion(const Contact& contact, const State& state) const;
  Vector force_n(const Contact& contact, const State& state) const;
  void derivative(const State& state, State& slope, Real phase, Real middle) const;
  /// State after a step of `length`, and the largest entry of its error.
  Real step(Real length, State& end) const;
  Real guard(const Contact& contact, const contact::GuardForm& form, const State& state) const;
  Real guard_rate(const Contact& contact, const contact::GuardForm& form, const State& state,
                  Real phase) const;
  /// Length within (0, length] at which the guard rises to zero, where it does.
  std::optional<Real> length_to_zero(const Contact& contact, const contact::GuardForm& form, Real length,
                                     const State& end) const;
  void choose_modes();
  void advance_piece(Real phase_end);

  std::vector<Contact> contacts_;
  std::vector<Pulse> pulses_;
  Matrix inverse_mass_, damping_, stiffness_;  ///< the last two premultiplied by the first
  Vector harmonic_cosine_, harmonic_sine_, constant_;
  Vector second_cosine_, second_sine_;  ///< empty without a second harmonic
  Real length_m_, speed_, tolerance_;
  Real phase_ = 0, usual_length_ = Real(0.01);
  State state_;
};

/// d (section after the turn) / d (section before it), by differences of fourth order: to about 1e-11 where
/// no change of mode lies within 4e-6 of another.
LongDoubleRun::Matrix monodromy(LongDoubleRun& run, const LongDoubleRun::State& section, int turn);

}  // namespace rubsweep::bench
