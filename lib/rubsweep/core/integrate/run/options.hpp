#pragma once

#include <cmath>
#include <string_view>

#include "rubsweep/core/model/key.hpp"
#include "rubsweep/core/model/range.hpp"
#include "rubsweep/core/vocabulary.hpp"

namespace rubsweep::integrate::run {

enum class Method { automatic, exact, adaptive };

/// Method of the adaptive solver. Descriptions and factory functions are in adaptive/stepper_table.
enum class Stepper {
  automatic,  ///< dopri5, but rosenbrock4 for steps that start in stiff friction
  dopri5,
  cash_karp54,
  rkf78,
  bulirsch_stoer,
  rosenbrock4,
};

/// Treatment of a change of contact mode by a stepper.
enum class ContactHandling {
  located,   ///< stops at every mode switch, located to rounding
  smoothed,  ///< integrates over the switch, with a law blended smoothly (C1) over `smoothing_m`
};

/// Words in the configuration and in tables.
constexpr std::string_view to_string(Method method) {
  return method == Method::automatic ? "auto" : enumerator_word(method);
}

constexpr std::string_view to_string(Stepper stepper) {
  return stepper == Stepper::automatic ? "auto" : enumerator_word(stepper);
}

constexpr std::string_view to_string(ContactHandling contact) { return enumerator_word(contact); }

struct SolverOptions {
  Method method = Method::automatic;
  Stepper stepper = Stepper::automatic;
  ContactHandling contact = ContactHandling::located;
  double relative_tolerance = 1e-8;  ///< absolute tolerance: times clearance, or clearance times speed
  double smoothing_m = 1e-7;         ///< penetration width of the blend; only for `smoothed`
  /// limit of accepted plus refused steps; if exceeded: step_limit
  long max_steps_per_revolution = 1'000'000;

  static constexpr model::Range relative_tolerance_range{.low = 1e-14, .high = 1e-2};
  static constexpr model::Range smoothing_range = model::positive;
  static constexpr long max_steps_low = 1000;

  static void visit_fields(auto& self, auto&& visit) {
    using model::key;
    visit("method", self.method,
          key(words_of<Method>(),
              "closed forms and Taylor pieces (exact), steppers (adaptive), or exact wherever it applies "
              "(auto)"));
    visit("stepper", self.stepper, key(words_of<Stepper>(), "stepper of the adaptive solver's turns"));
    visit("contact", self.contact,
          key(words_of<ContactHandling>(),
              "changes of contact mode found to rounding, or a law that is blended"));
    visit("relative_tolerance", self.relative_tolerance,
          key(relative_tolerance_range, "tolerance of the adaptive solver's turns"));
    visit("smoothing_m", self.smoothing_m, key(smoothing_range, "width of the blend of contact: smoothed"));
    visit("max_steps_per_revolution", self.max_steps_per_revolution,
          key(model::IntegerRange{max_steps_low, 1'000'000'000}, "steps that end a run as step_limit"));
  }
};

/// Whether a run with these options supports contacts with a non-linear law.
constexpr bool knows_curved_laws(const SolverOptions& options) {
  return options.method != Method::exact && options.contact == ContactHandling::located;
}
inline constexpr std::string_view no_curved_laws =
    "solver: method exact and contact smoothed know linear contacts alone, allowed: method auto or adaptive "
    "with contact located beside a law of another kind";

/// `automatic` uses the implicit stepper where the rate at which friction alone would change the slip exceeds
/// the contact's own angular frequency by this factor: 4 tolerance^(-1/4). For smaller ratios dopri5 takes
/// less time: stability limits its steps (h rate < 3.3), but they cost a fifth. For accuracy rosenbrock4, of
/// order 4, needs steps of about 8 tolerance^(1/4) / frequency. Measured by
/// studies/cost/stiff_friction_table.
inline double stiff_friction_ratio(double relative_tolerance) {
  return 4 / std::pow(relative_tolerance, 0.25);
}

}  // namespace rubsweep::integrate::run
