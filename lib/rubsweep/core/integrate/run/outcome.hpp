#pragma once

#include <string_view>

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

constexpr std::string_view to_string(Outcome outcome) {
  switch (outcome) {
    case Outcome::ok:
      return "ok";
    case Outcome::step_limit:
      return "step_limit";
    case Outcome::step_too_small:
      return "step_too_small";
    case Outcome::non_finite:
      return "non_finite";
    case Outcome::friction_unsettled:
      return "friction_unsettled";
    case Outcome::no_closed_form:
      return "no_closed_form";
    case Outcome::unsaturated:
      return "unsaturated";
  }
  return "";
}

}  // namespace rubsweep::integrate::run
