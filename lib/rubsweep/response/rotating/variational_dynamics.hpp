#pragma once

#include <Eigen/Core>
#include <vector>

#include "rubsweep/integrate/law/dynamics.hpp"

namespace rubsweep::response::rotating {

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
