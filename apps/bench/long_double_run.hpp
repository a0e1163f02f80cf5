#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "rubsweep/core/contact/contact_mode.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::bench {

/// Integrates a scene turn by turn in long double with simple, slow code; the errors of the solvers in double
/// are measured against it. It uses Runge-Kutta-Fehlberg 7(8) from Boost.Odeint inside each contact mode, and
/// locates the ends of modes and pulses by a bracketing search over the step length. States are those of
/// integrate::run::TurnReport::section. Matrices and contacts come from the scene. To check the scene as
/// well, a test compares one rotor that it computes from the parameters alone.
class LongDoubleRun {
 public:
  using Real = long double;
  using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
  using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
  using State = std::vector<Real>;

  /// Whether the scene can be run: false with dry friction, torsion or impulse trains.
  static bool applies(const scene::Scene& scene);

  /// Throws std::invalid_argument where `applies` is false. `tolerance`: bound on the stepper's error
  /// estimate of one step, in units of the section.
  LongDoubleRun(const scene::Scene& scene, Real tolerance);

  const State& section() const { return state_; }
  /// Sets the state to `section` at the start of turn `turn`.
  void restart(const State& section, int turn);
  /// Advances by one turn. Throws SolverError where this would take an unreasonable number of steps.
  void advance_turn();

 private:
  struct Contact {
    scene::Contact law;
    Matrix relative;  ///< 2 x n: from displacements to (rotor - casing) / length scale
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
  /// Computes the state after a step of `length`; returns the largest component of its error estimate.
  Real step(Real length, State& end) const;
  Real guard(const Contact& contact, const contact::GuardForm& form, const State& state) const;
  Real guard_rate(const Contact& contact, const contact::GuardForm& form, const State& state,
                  Real phase) const;
  /// Length within (0, length] at which the guard rises to zero; empty where it does not.
  std::optional<Real> length_to_zero(const Contact& contact, const contact::GuardForm& form, Real length,
                                     const State& end) const;
  void choose_modes();
  void advance_piece(Real phase_end);

  std::vector<Contact> contacts_;
  std::vector<Pulse> pulses_;
  Matrix inverse_mass_, damping_, stiffness_;  ///< damping_ and stiffness_ are multiplied by inverse_mass_
  Vector harmonic_cosine_, harmonic_sine_, constant_;
  Vector second_cosine_, second_sine_;  ///< empty without a second harmonic
  Real length_m_, speed_, tolerance_;
  Real phase_ = 0, usual_length_ = Real(0.01);
  State state_;
};

/// Monodromy matrix d (section after the turn) / d (section before it) by fourth-order differences. It is
/// accurate to about 1e-11 where mode changes are more than 4e-6 apart.
LongDoubleRun::Matrix monodromy(LongDoubleRun& run, const LongDoubleRun::State& section, int turn);

}  // namespace rubsweep::bench
