#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "rubsweep/core/contact/dry_friction.hpp"
#include "rubsweep/core/integrate/law/settle_slips.hpp"

namespace rubsweep::integrate::taylor {

/// Slips of dry friction that are zero where a piece begins. Each is a power series whose first coefficients
/// are then zero, and its next root lies behind that one.
class SlipZeros {
 public:
  explicit SlipZeros(std::size_t contacts) : terms_(contacts, 0) {}

  /// Number of leading coefficients that are zero, per contact (as of `SlipStart`).
  const std::vector<int>& terms() const { return terms_; }

  /// No slip is zero, or those that are hold: a piece was moved, or all contacts were entered anew.
  void clear() { std::ranges::fill(terms_, 0); }

  /// The slip of contact `i` has come to zero: decides which contacts stick from here on. Those that slip on
  /// do so from zero. `scratch` takes a rate of the state.
  template <class Dynamics, class State>
  void stop(Dynamics& dynamics, std::size_t i, const State& state, State& scratch, double phase) {
    law::settle_slips(dynamics, state, scratch, phase, [i](std::size_t j) { return j == i; });
    for (std::size_t j = 0; j < terms_.size(); ++j) {
      if (!dynamics.touches_dry(j) || (j != i && !law::stands(dynamics, j, state))) continue;
      terms_[j] = dynamics.slips()[j] == contact::Slip::sticking || dynamics.poised(j) ? 0 : 1;
    }
  }

  /// Contact `i`, which sticks, is let go in the direction of `slip`. It starts with its friction, and so
  /// does its slip's rate: two coefficients are zero, also of others that begin to slip with it. Where its
  /// friction jumps, the rates do, too.
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
