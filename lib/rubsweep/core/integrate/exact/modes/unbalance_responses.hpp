#pragma once

#include <deque>
#include <vector>

#include "rubsweep/core/integrate/exact/modes/mode_change.hpp"

namespace rubsweep::integrate::exact::modes {

/// Responses of a machine's contact modes to its unbalance, and the changes between these modes. Each is made
/// when first needed.
template <int N>
struct UnbalanceResponses {
  struct OfMode {
    bool made = false, usable = false;  ///< `usable`: result of make_harmonic_response
    HarmonicResponse<N> response;
  };
  struct Transition {
    const ModeChange<N>* change = nullptr;  ///< null: not yet made
    HarmonicChange<N> unbalance;
  };

  Eigen::VectorXcd acceleration;  ///< force of make_harmonic_response
  double rate_rad_per_s = 0;
  std::deque<OfMode> modes{};                          ///< by LinearMode::index; a deque keeps their places
  std::vector<std::vector<Transition>> transitions{};  ///< by the indices of both modes

  OfMode& of(const LinearMode<N>& mode) {
    while (modes.size() <= mode.index) modes.emplace_back();
    OfMode& found = modes[mode.index];
    if (!found.made)
      found.usable = make_harmonic_response(mode, acceleration, rate_rad_per_s, found.response);
    found.made = true;
    return found;
  }
};

}  // namespace rubsweep::integrate::exact::modes
