#pragma once

#include <string_view>

#include "rubsweep/core/vocabulary.hpp"

namespace rubsweep::integrate::run {

/// End of a stretch of integration, for all solvers. It is a value and not an exception, because a cell that
/// cannot be integrated is a normal result.
enum class Outcome {
  ok,
  step_limit,          ///< more steps in one revolution than allowed
  step_too_small,      ///< the step control needs a step below the rounding of the phase
  non_finite,          ///< the state is no longer finite
  friction_unsettled,  ///< no friction obeys the law at all contacts with slip zero
  // Results of closed forms only. Another solver then makes the revolution, so that no run ends with them.
  no_closed_form,  ///< touching an annular stop, or an undamped resonance
  /// closed form up to this point, where the friction of a touching contact leaves saturation
  unsaturated,
};

constexpr std::string_view to_string(Outcome outcome) { return enumerator_word(outcome); }

}  // namespace rubsweep::integrate::run
