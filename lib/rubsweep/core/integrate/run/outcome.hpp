#pragma once

#include <string_view>

namespace rubsweep::integrate::run {

/// End of a stretch of integration, for all solvers. A cell that cannot be integrated is a normal result, so
/// that this is a value and not an exception.
enum class Outcome {
  ok,
  step_limit,          ///< more steps in one revolution than allowed
  step_too_small,      ///< the step control needs a step below the rounding of the phase
  non_finite,          ///< the state is no longer finite
  friction_unsettled,  ///< no friction obeys the law at all contacts with slip zero
  // Results of closed forms only, after which another solver makes the revolution: no run ends with them.
  no_closed_form,  ///< touching an annular stop, or an undamped resonance
  unsaturated,     ///< closed form up to this point, where friction of a touching contact leaves saturation
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
