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
  Eigen::VectorXd end;         ///< state at its end, seen in the frame that turns with the shaft, 2n
  Eigen::MatrixXd transition;  ///< 2n x 2n: d(end) / d(start)
  double angle_rad = 0;        ///< length in rotation of the shaft
  int hits = 0;
  double contact_fraction = 0;
  bool slip_reversed = false;  ///< true: a slip reversed, as of a turn
  /// Changes of contact mode, phases from the start of the arc; none where contacts are smoothed.
  std::vector<integrate::run::ModeSwitch> switches;
  double peak_displacement_m = 0;  ///< like all that follows, only with samples
  double peak_contact_force_n = 0;
  double peak_casing_displacement_m = 0;
  Eigen::MatrixXd samples;  ///< 2n x count: states in the fixed frame at phases 2 pi k / N before the end
};

/// Outcome of an arc by Taylor pieces; `by_stepper`: a stepper has to make it.
enum class HowFollowed { made, by_stepper, failed };

/// Follows a rotationally symmetric scene, its pulses left out, and the derivative of the motion by its
/// start, from any state over any angle, by Taylor pieces, or by dopri5 where contacts are
/// smoothed or a stepper is named. In the frame that turns with the shaft such a scene does not depend on
/// time, so that every start is one at phase 0, where the two frames coincide.
class RotatingFlow {
 public:
  /// `samples_per_revolution`: N of RotatingArc::samples; 0: none.
  RotatingFlow(const scene::Scene& scene, const integrate::run::SolverOptions& options,
               int samples_per_revolution);

  /// Flow of the same scene to another tolerance and with other samples. Both share one run, so that they
  /// cannot be used at the same time.
  RotatingFlow with(double relative_tolerance, int samples_per_revolution) const;

  /// Empty when the solver fails. `state`: 2n scaled numbers; `angle_rad` > 0.
  std::optional<RotatingArc> from(const Eigen::VectorXd& state, double angle_rad) const;

  /// The end alone, without its derivative: several times cheaper.
  std::optional<Eigen::VectorXd> end_from(const Eigen::VectorXd& state, double angle_rad) const;

 private:
  struct Common;

  /// Up to the end of `arc`, its transition where it is asked for.
  HowFollowed by_series(const Eigen::VectorXd& state, int samples_per_revolution, bool transition,
                        RotatingArc& arc) const;
  scene::Scene scene_at(const Eigen::VectorXd& state) const;

  std::shared_ptr<Common> common_;
  integrate::run::SolverOptions options_;
  int samples_per_revolution_;
};

/// Variational equations: u, u', then the 2n columns of the derivative Phi of the state by the initial one,
/// Phi' = (d rate / d state) Phi from the identity. The saltation matrix of a change of contact mode is the
/// identity, because the force, and with it the rate, is continuous there. Where a slip with dry friction
/// comes to zero, the run takes `changes` across.
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

  /// Phi, one change of the state a column.
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
