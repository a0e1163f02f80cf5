#include "machine_search/candidate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rubsweep::machine_search {
namespace {

/// Uniform number in [0, 1), the same with every standard library.
double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

constexpr double clearance_m = 1e-3, farther_clearance_m = 1.5e-3;
constexpr double stiffness_in_hole = 1.18;  ///< contact stiffness in a hole / on a flat stop

std::string stop_text(const Candidate& candidate, Arrangement arrangement, double angle_deg,
                      double clearance) {
  const bool annular = arrangement == Arrangement::annulus || arrangement == Arrangement::annulus_with_offset;
  const double rate = 2 * std::numbers::pi * candidate.casing_frequency_hz;
  const std::string geometry =
      annular ? fmt::format("kind: annular, offset_m: [0, {}]",
                            arrangement == Arrangement::annulus_with_offset ? clearance_m / 4 : 0.0)
              : fmt::format("kind: one_side, angle_deg: {}", angle_deg);
  return fmt::format(
      "  - {{{}, clearance_m: {}, contact_radius_m: 0.005, stiffness_n_per_m: {},\n"
      "     restitution_delivered: {}, friction: {{stribeck: [0, 0, 0, {}, 100, 0]}},\n"
      "     casing: {{mass_kg: {}, stiffness_n_per_m: {}, damping_ratio: {}}}}}\n",
      geometry, clearance, candidate.contact_stiffness_n_per_m * (annular ? stiffness_in_hole : 1.0),
      candidate.restitution_delivered, candidate.friction_coefficient, candidate.casing_mass_kg,
      candidate.casing_mass_kg * rate * rate, candidate.casing_damping_ratio);
}

}  // namespace

Candidate random_candidate(std::mt19937_64& random) {
  Candidate candidate;
  for (const Parameter& parameter : parameters) {
    candidate.*parameter.field = parameter.low * std::pow(parameter.high / parameter.low, uniform(random));
  }
  return candidate;
}

Candidate perturbed(const Candidate& candidate, double spread, std::mt19937_64& random) {
  Candidate changed = candidate;
  for (const Parameter& parameter : parameters) {
    const bool kept = uniform(random) < 0.5;
    const double factor = std::exp(2 * spread * (2 * uniform(random) - 1));
    if (kept) continue;
    double& field = changed.*parameter.field;
    field = std::clamp(field * factor, parameter.low, parameter.high);
  }
  return changed;
}

std::string machine_text(const Candidate& candidate, Arrangement arrangement) {
  std::string text = fmt::format(
      "rotor: {{kind: jeffcott, mass_kg: 0.8, natural_frequency_hz: 30, damping_ratio: {}}}\nstops:\n",
      candidate.rotor_damping_ratio);
  text += stop_text(candidate, arrangement, 90, clearance_m);
  if (arrangement == Arrangement::both_sides) text += stop_text(candidate, arrangement, -90, clearance_m);
  if (arrangement == Arrangement::unequal_casings)
    text += stop_text(candidate, arrangement, -90, farther_clearance_m);
  return text + fmt::format("kick: {{force_n: {}, duration_s: {}}}\n", candidate.kick_force_n,
                            candidate.kick_duration_s);
}

}  // namespace rubsweep::machine_search
