#pragma once

#include <string_view>

#include "rubsweep/core/vocabulary.hpp"

namespace rubsweep::integrate::run {

/// How a stretch of integration ended, by any solver. A cell that cannot be integrated is a result like any
/// other, so that this is a value and not an exception.
enum class Outcome {
  ok,
  step_limit,          ///< more steps in one revolution than allowed
  step_too_small,      ///< the step control asked for a step below rounding of the phase
  non_finite,          ///< the state left the finite numbers
  friction_unsettled,  ///< no friction was found that obeys the law at all contacts with slip zero
  // Endings of closed forms alone, which leave the revolution to another solver: no run ends with them.
  no_closed_form,  ///< touching an annular stop, an undamped resonance
  unsaturated,     ///< up to here there was one: the friction of a touching contact leaves saturation
};

constexpr std::string_view to_string(Outcome outcome) { return enumerator_word(outcome); }

}  // namespace rubsweep::integrate::run
