#include "rubsweep/measurement/diagnose/candidate.hpp"

#include <algorithm>

#include "rubsweep/core/model/normal_law.hpp"

namespace rubsweep::diagnose {

const std::array<UnknownRow, unknown_count>& unknown_rows() {
  constexpr model::Range ratio{.low = 0, .high = 1, .low_open = true, .high_open = true},
      restitution{.low = 0, .high = 1, .low_open = true}, friction{.low = 0, .high = 1};
  static const std::array<UnknownRow, unknown_count> rows{{
      {Unknown::natural_frequency, "natural_frequency_hz", model::positive, {}, false, false},
      {Unknown::damping_ratio, "damping_ratio", model::positive, {}, false, false},
      // Below 0.1, no kick that a machine survives carries the rotor to the stop. At 3, the quiet whirl would
      // be three times as large as the clearance.
      {Unknown::whirl_ratio, "whirl_ratio", model::positive, {0.1, 3, true}, true},
      // Contact stiffness from a seal strip to steel on steel.
      {Unknown::stiffness, "stiffness_n_per_m", model::positive, {1e5, 1e8, true}, true},
      {Unknown::restitution, "restitution", restitution, {0.3, 0.95, false}, false},
      // Friction from oiled steel to dry metal.
      {Unknown::friction, "friction_coefficient", friction, {0.02, 0.3, false}, false},
      {Unknown::casing_mass, "casing_mass_kg", model::positive, {0.02, 2, true}, true},
      {Unknown::casing_frequency, "casing_frequency_hz", model::positive, {100, 2000, true}, true},
      // Range from a kick that moves the rotor over half the clearance to a kick with 40 times this speed.
      {Unknown::kick_ratio, "kick_ratio", model::positive, {0.5, 20, true}, true},
      {Unknown::kick_angle, "kick_angle_deg", model::any_finite, {-180, 180, false}, false, false},
      {Unknown::kick_phase, "kick_phase_deg", model::any_finite, {0, 360, false}, false, false},
      {Unknown::second_clearance_ratio, "second_clearance_ratio", model::positive, {0.7, 1.43, true}, true},
      {Unknown::offset_ratio, "offset_ratio", ratio, {0.15, 0.9, false}, false},
      {Unknown::stop_angle, "stop_angle_deg", model::any_finite, {}, false, false, true},
      {Unknown::position, "position_m", model::not_negative, {}, false, false, true},
      {Unknown::kit, "kit", model::any_finite, {}, false, false, true},
      // From flat pads, which are springs, to the points of Hertz. Half of the machines have springs, whose
      // motions have closed forms; the others take several times as long.
      {Unknown::exponent, "exponent", model::NormalLaw::exponent_range, {1, 1.5, false, 0.5}, false},
  }};
  return rows;
}

Spread& spread_of(Candidate& candidate, Unknown unknown) {
  return candidate.spreads[static_cast<std::size_t>(unknown)];
}
const Spread& spread_of(const Candidate& candidate, Unknown unknown) {
  return candidate.spreads[static_cast<std::size_t>(unknown)];
}

Candidate usual_candidate(Cause cause) {
  Candidate candidate{.name = std::string(to_string(cause)), .cause = cause};
  for (const UnknownRow& row : unknown_rows()) spread_of(candidate, row.unknown) = row.usual;
  const auto known = [&](Unknown unknown, double value) { spread_of(candidate, unknown) = {value, value}; };
  if (cause != Cause::two_sides) known(Unknown::second_clearance_ratio, 1);
  if (cause != Cause::annular_offset) known(Unknown::offset_ratio, 0);
  if (cause != Cause::no_rub) return candidate;
  for (const UnknownRow& row : unknown_rows())
    if (row.of_file) known(row.unknown, row.usual.low);
  known(Unknown::kick_angle, 0);
  known(Unknown::kick_phase, 0);
  known(Unknown::offset_ratio, 0);
  // Without a rub: range from a well-balanced rotor to a rotor whose quiet whirl almost touches the stop.
  spread_of(candidate, Unknown::whirl_ratio) = {0.01, 1, true};
  return candidate;
}

std::vector<Candidate> usual_candidates() {
  std::vector<Candidate> candidates;
  candidates.reserve(all_causes.size());
  for (const Cause cause : all_causes) candidates.push_back(usual_candidate(cause));
  return candidates;
}

std::vector<double> usual_prior(const std::vector<Candidate>& candidates) {
  constexpr double without_over_with_rub = 2;
  const auto count = [&](Cause cause) {
    return static_cast<double>(std::ranges::count(candidates, cause, &Candidate::cause));
  };
  const bool both_round = count(Cause::annular) > 0 && count(Cause::annular_offset) > 0;
  const double of_round = both_round ? 0.5 : 1,
               rubs = count(Cause::one_side) + count(Cause::two_sides) +
                      of_round * (count(Cause::annular) + count(Cause::annular_offset)),
               still = count(Cause::no_rub),
               of_still = still == 0 || rubs == 0 ? 1 : without_over_with_rub * rubs / still;
  std::vector<double> prior;
  prior.reserve(candidates.size());
  for (const Candidate& candidate : candidates) {
    const bool is_round = candidate.cause == Cause::annular || candidate.cause == Cause::annular_offset;
    const double share = candidate.cause == Cause::no_rub ? of_still : is_round ? of_round : 1;
    prior.push_back(share / (rubs + of_still * still));
  }
  return prior;
}

Point values_at(const Candidate& candidate, const Point& unit) {
  Point values{};
  for (std::size_t i = 0; i < unknown_count; ++i) values[i] = value_at(candidate.spreads[i], unit[i]);
  return values;
}

}  // namespace rubsweep::diagnose
