#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "rubsweep/core/contact/dry_friction.hpp"
#include "rubsweep/core/integrate/law/settle_slips.hpp"

namespace rubsweep::integrate::taylor {

/// Slips of dry friction that are zero at the start of a piece. The first coefficients of their power series
/// are then zero, and only the next root is an event.
class SlipZeros {
 public:
  explicit SlipZeros(std::size_t contacts) : terms_(contacts, 0) {}

  /// Number of leading zero coefficients per contact (as in `SlipStart`).
  const std::vector<int>& terms() const { return terms_; }

  /// Clears all: after a piece, or after entering all contacts anew, no slip starts from zero.
  void clear() { std::ranges::fill(terms_, 0); }

  /// Sets them after all contacts have entered their modes and slips by `state`.
  template <class Dynamics, class State>
  void enter(const Dynamics& dynamics, const State& state) {
    for (std::size_t i = 0; i < terms_.size(); ++i) terms_[i] = begins_to_slip(dynamics, i, state) ? 1 : 0;
  }

  /// Handles contact `i` whose slip has reached zero: decides which contacts stick from now on. The slips of
  /// contacts that continue to slip start from zero. `scratch` takes a rate of the state.
  template <class Dynamics, class State>
  void stop(Dynamics& dynamics, std::size_t i, const State& state, State& scratch, double phase) {
    law::settle_slips(dynamics, state, scratch, phase, [i](std::size_t j) { return j == i; });
    for (std::size_t j = 0; j < terms_.size(); ++j) {
      if (!dynamics.touches_dry(j) || (j != i && !law::stands(dynamics, j, state))) continue;
      terms_[j] = dynamics.slips()[j] == contact::Slip::sticking || dynamics.poised(j) ? 0 : 1;
    }
  }

  /// Releases the sticking contact `i` in the direction of `slip`. Its slip and the rate of its slip start
  /// from zero, so that two coefficients are zero; this also holds for other contacts that begin to slip with
  /// it. If its friction jumps, the rates jump, too, and only one coefficient is zero.
  template <class Dynamics, class State>
  void let_go(Dynamics& dynamics, std::size_t i, contact::Slip slip, const State& state, State& scratch,
              double phase) {
    const bool others = law::let_go(dynamics, i, slip, state, scratch, phase);
    for (std::size_t j = 0; j < terms_.size(); ++j) {
      if (j == i || (others && begins_to_slip(dynamics, j, state))) terms_[j] = zeros_of(dynamics, i, j);
    }
  }

 private:
  template <class Dynamics>
  static int zeros_of(const Dynamics& dynamics, std::size_t let_go, std::size_t j) {
    if (dynamics.poised(j) || dynamics.slips()[j] == contact::Slip::sticking) return 0;
    return dynamics.jumps(let_go) ? 1 : 2;
  }

  template <class Dynamics, class State>
  static bool begins_to_slip(const Dynamics& dynamics, std::size_t i, const State& state) {
    return dynamics.touches_dry(i) && dynamics.slips()[i] != contact::Slip::sticking && !dynamics.poised(i) &&
           law::stands(dynamics, i, state);
  }

  std::vector<int> terms_;
};

}  // namespace rubsweep::integrate::taylor
