#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "rubsweep/core/integrate/law/dynamics.hpp"
#include "rubsweep/core/integrate/run/options.hpp"
#include "rubsweep/core/integrate/run/turn.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::response::rotating {

/// A stretch of a motion of a rotationally symmetric scene.
struct RotatingArc {
  Eigen::VectorXd end;         ///< state at its end in the rotating frame, 2n
  Eigen::MatrixXd transition;  ///< 2n x 2n: d(end) / d(start)
  double angle_rad = 0;        ///< length in rotation of the shaft
  int hits = 0;
  double contact_fraction = 0;
  bool slip_reversed = false;  ///< true: a slip reversed, as in TurnReport
  /// Changes of contact mode with phases from the start of the arc; none where contacts are smoothed.
  std::vector<integrate::run::ModeSwitch> switches;
  double peak_displacement_m = 0;  ///< this member and all below: only with samples
  double peak_contact_force_n = 0;
  double peak_casing_displacement_m = 0;
  Eigen::MatrixXd samples;  ///< 2n x count: states in the fixed frame at 2 pi k / N before the end
};

/// Outcome of an arc by Taylor pieces; `by_stepper`: a stepper must compute it instead.
enum class HowFollowed { made, by_stepper, failed };

/// Follows a rotationally symmetric scene, without its pulses, from any state over any angle, with the
/// derivative of the motion by its start. It uses Taylor pieces, or dopri5 where contacts are smoothed or a
/// stepper is chosen. In the rotating frame such a scene does not depend on time; each start therefore counts
/// as phase 0, where the two frames coincide.
class RotatingFlow {
 public:
  /// `samples_per_revolution`: N of RotatingArc::samples; 0: no samples.
  RotatingFlow(const scene::Scene& scene, const integrate::run::SolverOptions& options,
               int samples_per_revolution);

  /// Flow of the same scene with another tolerance and number of samples. Both share one run, so that they
  /// cannot be used at the same time.
  RotatingFlow with(double relative_tolerance, int samples_per_revolution) const;

  /// Arc from a state of 2n scaled numbers over `angle_rad` > 0. Empty when the solver fails.
  std::optional<RotatingArc> from(const Eigen::VectorXd& state, double angle_rad) const;

  /// End state without its derivative: several times cheaper.
  std::optional<Eigen::VectorXd> end_from(const Eigen::VectorXd& state, double angle_rad) const;

 private:
  struct Common;

  /// Follows to the end of `arc`, with its transition matrix if requested.
  HowFollowed by_series(const Eigen::VectorXd& state, int samples_per_revolution, bool transition,
                        RotatingArc& arc) const;
  scene::Scene scene_at(const Eigen::VectorXd& state) const;

  std::shared_ptr<Common> common_;
  integrate::run::SolverOptions options_;
  int samples_per_revolution_;
};

/// Variational equations: u, u', then the 2n columns of the derivative Phi of the state by the initial state,
/// Phi' = (d rate / d state) Phi, Phi(0) = identity. The saltation matrix of a change of contact mode is the
/// identity, because the force, and so the rate, is continuous there. Where the slip of dry friction reaches
/// zero, the run applies the jump to `changes`.
template <int N, bool Smoothed>
class VariationalDynamics : public integrate::law::Dynamics<N, Smoothed> {
  static constexpr int states = N == Eigen::Dynamic ? Eigen::Dynamic : 2 * N;
  using Base = integrate::law::Dynamics<N, Smoothed>;
  using Transition = Eigen::Matrix<double, states, states>;

 public:
  using Base::Base;

  template <class State>
  void operator()(const State& state, State& rate, double phase) const {
    this->loose(state, rate, phase);
    const typename Base::Holding holding = this->hold(state, rate);
    const Eigen::Index n = this->system().coordinates();
    typename Base::Matrix by_u, by_v;
    this->slopes(state, holding, by_u, by_v);
    const Eigen::Map<const Transition> phi(&state[0] + 2 * n, 2 * n, 2 * n);
    Eigen::Map<Transition> phi_rate(&rate[0] + 2 * n, 2 * n, 2 * n);
    phi_rate.template topRows<N>(n) = phi.template bottomRows<N>(n);
    phi_rate.template bottomRows<N>(n).noalias() = by_u * phi.template topRows<N>(n);
    phi_rate.template bottomRows<N>(n).noalias() += by_v * phi.template bottomRows<N>(n);
  }

  /// Phi; each column is the change of the state by one initial number.
  template <class State>
  auto changes(State& state) const {
    const Eigen::Index n = this->system().coordinates();
    return Eigen::Map<Transition>(&state[0] + 2 * n, 2 * n, 2 * n);
  }

  std::vector<double> whole_state(std::vector<double> section) const {
    const std::size_t states_here = section.size();
    section.resize(states_here * (states_here + 1), 0.0);
    for (std::size_t i = 0; i < states_here; ++i) section[states_here + i * (states_here + 1)] = 1;
    return section;
  }
};

}  // namespace rubsweep::response::rotating
