#pragma once

#include <complex>
#include <memory>
#include <vector>

#include "rubsweep/core/integrate/exact/drives.hpp"
#include "rubsweep/core/integrate/exact/modes/harmonic_response.hpp"
#include "rubsweep/core/integrate/exact/modes/machine_modes.hpp"
#include "rubsweep/core/integrate/exact/modes/mode_change.hpp"
#include "rubsweep/core/integrate/exact/modes/mode_flow.hpp"
#include "rubsweep/core/integrate/exact/tangent_vectors.hpp"
#include "rubsweep/core/integrate/run/pulse_times.hpp"
#include "rubsweep/core/numerics/exponential_series.hpp"

namespace rubsweep::integrate::exact {

/// State of an exact run: the free vibration in the present contact mode and the phasors of the forces.
/// Propagation has no truncation error; the caller finds the end of each mode. Time is in seconds, lengths
/// are scaled.
template <int N>
class ExactMotion {
 public:
  using State = typename modes::ExactTypes<N>::State;

  /// A guard function (or a smooth substitute), its rate, and a bound on its second derivative within the
  /// mode's longest step.
  struct GuardValue {
    double value = 0, rate = 0, curvature = 0;
  };

  ExactMotion(const scene::Scene& scene, std::shared_ptr<modes::MachineModes<N>> modes);

  /// Enters a joint mode with a state (u, u'). False where the mode has no closed form here: no equilibrium,
  /// or a harmonic force at an undamped resonance.
  bool enter(std::size_t joint, const State& physical);
  /// Changes to another joint mode at the present state. If no pulse acts and N is a compile-time constant,
  /// the change does not go through displacements (ModeChange). False as for `enter`.
  bool change(std::size_t joint);
  /// Number of modes entered so far, repeated ones included.
  long visits() const { return visits_; }

  /// Sets the phasors as Drives::start.
  void set_phases(double phase_rad) { drives_.start(phase_rad, now_.phasors); }
  void set_phases(double phase_rad, const run::PulseTimes& pulses, double time_s) {
    drives_.start(phase_rad, pulses, time_s, now_.phasors);
  }

  /// Variables within a mode: the free vibration and the phasors of the forces.
  struct Instant {
    State free;
    Phasors phasors;
  };
  const Instant& here() const { return now_; }
  /// Moves an instant within the present mode, which must have a modal form; the motion itself does not move.
  void ahead(Instant& instant, double duration_s) const;
  void ahead_by_table(Instant& instant, int k) const;  ///< Moves an instant by step `k` of the mode's table.
  /// Moves an instant by one sampling interval, whose flow is cached.
  void ahead_by_interval(Instant& instant, double interval_s);

  State physical() const { return physical(here()); }
  State physical(const Instant& instant) const {
    return forced(*mode_, *cell_, instant) + mode_->from_free(instant.free);
  }
  State rate_of(const State& physical) const;
  /// Second derivative p'' of the penetration of flat contact `i` by the law of the present mode.
  double closing_acceleration(std::size_t i, const State& physical) const;

  /// Factors of the bounds. With a modal form: the length of each pair of the free vibration (n numbers, then
  /// n zeros). Otherwise: the magnitude of each of its 2n components.
  State sizes() const;
  GuardValue guard(std::size_t e) const {
    const modes::LinearGuard<N>& guard = mode_->guards[e];
    return whole_guard(guard,
                       guard.terms.slow_count > 0 ? with_fast(guard, slow_sum(guard)) : fast_sum(guard),
                       forced_guard(e));
  }

  // A guard is the sum of three parts: the terms of slow pairs of the free vibration, the terms of fast
  // pairs, and the part forced by unbalance and pulses. Most steps can be certified with only some of these
  // parts, so that each part can be computed separately.

  /// The forced part of a guard.
  struct Forced {
    GuardValue shaft, pulses;
    bool pulsed = false;

    GuardValue with(double value, const modes::ModalSum& free) const {
      GuardValue guard{value, free.rate(), free.curvature()};
      add(shaft, guard);
      if (pulsed) add(pulses, guard);
      return guard;
    }

    static void add(const GuardValue& part, GuardValue& guard) {
      guard.value += part.value;
      guard.rate += part.rate;
      guard.curvature += part.curvature;
    }
  };
  Forced forced_guard(std::size_t e) const;
  /// Sums of terms. slow_sum: the slow pairs; with_fast: adds the fast pairs to it; fast_sum: only the fast
  /// pairs. The first two are for guards with slow pairs (`guard.terms.slow_count` > 0); in other guards all
  /// pairs count as fast. Only a mode with a modal form distinguishes slow and fast pairs.
  modes::ModalSum slow_sum(const modes::LinearGuard<N>& guard) const {
    return modes::sum_of(guard.terms.slow(), now_.free.data(), true);
  }
  modes::ModalSum with_fast(const modes::LinearGuard<N>& guard, modes::ModalSum slow) const;
  modes::ModalSum fast_sum(const modes::LinearGuard<N>& guard) const {
    return modes::sum_of(guard.terms.fast(), now_.free.data(), mode_->paired);
  }
  /// The guard with every fast pair at the maximum of its envelope instead of its present value. This
  /// function is never below the guard and moves as slowly as the slow pairs. A step over which it stays
  /// negative is certified without the fast pairs, however often they oscillate.
  GuardValue slow_guard(const modes::LinearGuard<N>& guard, const modes::ModalSum& slow,
                        const Forced& forced) const;
  GuardValue whole_guard(const modes::LinearGuard<N>& guard, const modes::ModalSum& all,
                         const Forced& forced) const {
    return forced.with(guard.constant + all.value(), all);
  }

  /// Smooth guard of an open annular stop: (|d|^2 - C^2) / (2 C), d being the offset of the rotor and C the
  /// clearance. It crosses zero together with |d| - C and is smooth at the centre, where |d| is not.
  GuardValue annular(std::size_t r, const State& sizes) const;

  /// Normal force in newtons of touch `t`, which must push, at an instant of the present mode.
  GuardValue force(std::size_t t, const Instant& instant) const;

  /// Displacement and velocity of casing `c`, as in `physical`.
  struct CasingMotion {
    Eigen::Vector2d displacement, velocity;
  };
  CasingMotion casing(std::size_t c, const Instant& instant) const;

  /// Rate of the sliding speed of touch `t`, scaled length per second squared, and a bound of its second
  /// derivative within the mode's longest step.
  struct SlidingRate {
    double rate = 0, curvature = 0;
  };
  SlidingRate sliding_rate(std::size_t t) const;

  void step_by_table(int k);
  void step_by(double duration_s);  ///< Moves by any duration up to the mode's longest step.

  /// Longest duration that `land` can cover.
  double reach_s() const { return numerics::longest_series / fastest_rad_per_s(); }
  /// Moves to the instant where guard `e`, monotone up to there, rises through zero. It must lie at most
  /// `within_s` <= reach_s() ahead. Returns the duration.
  double land(std::size_t e, double within_s);

  /// Bound on |d slip / dt| / length scale, without the contribution of friction, of a touching contact that
  /// has a `friction_rate`. The bound holds within the mode's longest step from `physical`, the present
  /// state.
  double sliding_rate_bound(const modes::TouchWatch<N>& touch, const State& physical) const;

  void carry_no_tangents() { tangents_.clear(); }
  /// Starts to carry tangent vectors of the state.
  void carry_tangents(const Eigen::MatrixXd& vectors) { tangents_.begin(*mode_, scale_, vectors); }
  /// Writes the tangent vectors at the present state: the first ones, one for each column of `vectors`.
  void put_tangents(Eigen::MatrixXd& vectors) { tangents_.put(*mode_, scale_, vectors); }

  /// Carries one more tangent vector, given as a change of (u, u').
  void carry_tangent_too(const State& vector) { tangents_.add(*mode_, vector); }
  /// Tangent vectors at the present state, in the coordinates of `free()`.
  std::vector<State> tangents() { return tangents_.now(*mode_); }
  /// Products of each tangent vector with a linear function of the free vibration, times `unit`.
  void put_tangent_sums(const modes::ModalTerms& terms, double unit, modes::ModalSums& sums) {
    tangents_.put_sums(*mode_, terms, unit, sums);
  }

  const modes::LinearMode<N>& mode() const { return *mode_; }
  std::size_t joint() const { return joint_; }
  modes::MachineModes<N>& machine() const { return *machine_; }
  const State& free() const { return now_.free; }

 private:
  using Complex = std::complex<double>;

  /// Flow of a mode with pairs over some duration, and the factors that advance the phasors by it.
  struct PairFlow {
    double duration_s = -1;
    typename modes::ExactTypes<N>::Pairs pairs;
    Phasors turns;
  };

  using ModeResponse = typename modes::UnbalanceResponses<N>::OfMode;

  struct ModeCell {
    ModeResponse* shaft = nullptr;       ///< null: not yet prepared
    std::vector<ModeResponse> pulses{};  ///< each made when first needed in the mode
    PairFlow interval;
  };

  /// Highest angular frequency of the free vibration and of the acting forces.
  double fastest_rad_per_s() const { return drives_.fastest_rad_per_s(mode_->fastest_rad_per_s); }
  bool prepare(const modes::LinearMode<N>& mode, ModeCell& cell);
  /// Transition from the present mode to `to`, whose cell must be prepared.
  const typename modes::UnbalanceResponses<N>::Transition& transition(const modes::LinearMode<N>& to);
  /// Calls `visit` with the response of `cell` to each acting force and its phasor.
  template <class Visit>
  void for_each_response(const ModeCell& cell, const Instant& instant, const Visit& visit) const {
    const auto& acting = drives_.acting();
    visit(cell.shaft->response, instant.phasors.shaft);
    for (std::size_t k = 0; k < acting.size(); ++k)
      visit(cell.pulses[acting[k]].response, instant.phasors.pulses[k]);
  }
  State forced(const modes::LinearMode<N>& mode, const ModeCell& cell, const Instant& instant) const;
  void turn_by_table(Phasors& phasors, std::size_t table_step) const;
  void step_by_series(double duration_s);

  std::shared_ptr<modes::MachineModes<N>> machine_;
  run::StateScale scale_;  ///< scale of sections
  Drives drives_;
  std::shared_ptr<modes::UnbalanceResponses<N>> responses_;
  std::vector<ModeCell> cells_;
  const modes::LinearMode<N>* mode_ = nullptr;
  ModeCell* cell_ = nullptr;
  std::size_t joint_ = 0;
  long visits_ = 0;
  Instant now_;
  TangentVectors<N> tangents_;
};

template <int N>
inline typename ExactMotion<N>::State ExactMotion<N>::sizes() const {
  if (!mode_->paired) return now_.free.cwiseAbs();
  const Eigen::Index n = mode_->rest.size();
  State sizes = State::Zero(2 * n);
  for (Eigen::Index j = 0; j < n; ++j) sizes(j) = modes::pair_size(now_.free(j), now_.free(n + j));
  return sizes;
}

template <int N>
inline typename ExactMotion<N>::Forced ExactMotion<N>::forced_guard(std::size_t e) const {
  const auto of = [e](const modes::HarmonicResponse<N>& response, Complex phasor) -> GuardValue {
    const Complex z = modes::product(response.at_guard[e], phasor);
    return {z.real(), -response.rate * z.imag(), response.curvature[e]};
  };
  const auto& acting = drives_.acting();
  Forced forced{
      .shaft = of(cell_->shaft->response, now_.phasors.shaft), .pulses = {}, .pulsed = !acting.empty()};
  for (std::size_t k = 0; k < acting.size(); ++k)
    Forced::add(of(cell_->pulses[acting[k]].response, now_.phasors.pulses[k]), forced.pulses);
  return forced;
}

template <int N>
inline modes::ModalSum ExactMotion<N>::with_fast(const modes::LinearGuard<N>& guard,
                                                 modes::ModalSum slow) const {
  for (const modes::ModalTerm& pair : guard.terms.fast())
    slow += modes::ModalSum(pair, now_.free.data(), true);
  return slow;
}

template <int N>
inline typename ExactMotion<N>::GuardValue ExactMotion<N>::slow_guard(const modes::LinearGuard<N>& guard,
                                                                      const modes::ModalSum& slow,
                                                                      const Forced& forced) const {
  double value = guard.constant + slow.value();
  for (const modes::ModalTerm& pair : guard.terms.fast())
    value += pair.envelope * modes::pair_size(now_.free(pair.u), now_.free(pair.v));
  return forced.with(value, slow);
}

template <int N>
inline void ExactMotion<N>::turn_by_table(Phasors& phasors, std::size_t table_step) const {
  const auto turn = [&](ModeResponse& of, Complex& phasor) {
    phasor = modes::product(phasor, of.response.turned_by(table_step, mode_->longest_step_s));
  };
  turn(*cell_->shaft, phasors.shaft);
  const auto& acting = drives_.acting();
  for (std::size_t k = 0; k < acting.size(); ++k) turn(cell_->pulses[acting[k]], phasors.pulses[k]);
}

template <int N>
inline void ExactMotion<N>::step_by_table(int k) {
  const auto index = static_cast<std::size_t>(k);
  if (mode_->paired) {
    modes::move_pairs(mode_->pair_steps[index], now_.free);
  } else {
    now_.free = numerics::product_of<State>(mode_->steps.of(k), now_.free);
  }
  tangents_.pass(mode_->longest_step_s * numerics::exact_step_sizes[index]);
  turn_by_table(now_.phasors, index);
}

extern template class ExactMotion<2>;
extern template class ExactMotion<4>;
extern template class ExactMotion<6>;
extern template class ExactMotion<Eigen::Dynamic>;

}  // namespace rubsweep::integrate::exact
