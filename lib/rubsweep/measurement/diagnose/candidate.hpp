#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/core/model/range.hpp"
#include "rubsweep/core/vocabulary.hpp"
#include "rubsweep/measurement/diagnose/random_stream.hpp"

namespace rubsweep::diagnose {

/// Kind of the stops of a candidate; also "no rub".
enum class Cause {
  no_rub,         ///< no stop is touched
  one_side,       ///< one flat stop
  two_sides,      ///< two flat stops that face each other
  annular,        ///< a round stop about the rest position
  annular_offset  ///< a round stop whose centre is not that of the rotor
};
constexpr std::string_view to_string(Cause cause) { return enumerator_word(cause); }
inline constexpr auto cause_words = words_of<Cause>();
inline constexpr auto& all_causes = cause_words.values;

/// Parameters that cannot be read from a recording. Angles are measured from the direction of the stop.
enum class Unknown : std::size_t {
  natural_frequency,  ///< frequency of the rotor, Hz
  damping_ratio,
  whirl_ratio,             ///< radius of the quiet whirl / remaining clearance
  stiffness,               ///< stiffness of the contact, N/m
  restitution,             ///< nominal coefficient of restitution
  friction,                ///< coefficient of dry friction
  casing_mass,             ///< mass of the casing, kg
  casing_frequency,        ///< frequency of the casing on its mount, Hz
  kick_ratio,              ///< velocity after the kick / (clearance x natural angular frequency)
  kick_angle,              ///< direction of the kick, degrees from the stop
  kick_phase,              ///< angle of the shaft at the kick, degrees
  second_clearance_ratio,  ///< two_sides: clearance of the second stop / clearance of the first
  offset_ratio,            ///< annular_offset: offset / clearance
  stop_angle,  ///< degrees from +x; 0 where the machine looks the same from all directions without the stop
  position,    ///< place of the stops along the shaft of a rotor kit, m
  kit,         ///< position in the list KnownKit::likely, from 0 (first) to 1 (last)
  exponent     ///< exponent of the force law; at 1/20 of the clearance all exponents have the same stiffness
};
inline constexpr std::size_t unknown_count = 17;

/// One number per unknown: its value, or the position in [0, 1] that its Spread maps to the value.
using Point = std::array<double, unknown_count>;

struct UnknownRow {
  Unknown unknown;
  std::string_view key;  ///< key in a file of candidates
  model::Range range;    ///< values that a machine may have
  Spread usual;          ///< range where a file gives none
  bool logarithmic;      ///< whether intervals from a file are uniform in the logarithm
  bool of_file = true;   ///< whether a candidates' file gives this number, not machine or recording
  bool of_kit = false;   ///< whether only rotor kits have this number
};
const std::array<UnknownRow, unknown_count>& unknown_rows();

/// One possible explanation of a recording.
struct Candidate {
  std::string name;
  Cause cause = Cause::no_rub;
  std::array<Spread, unknown_count> spreads{};
  Spread clearance_m{};  ///< clearance of the first stop; usual candidates take the clearance of the study
  std::optional<Spread> position_m{};  ///< range along the shaft of a rotor kit; empty: all allowed places
};

Spread& spread_of(Candidate& candidate, Unknown unknown);
const Spread& spread_of(const Candidate& candidate, Unknown unknown);

/// A candidate with the usual ranges. A number that its stops do not have gets two equal bounds, and so
/// counts as known.
Candidate usual_candidate(Cause cause);

std::vector<Candidate> usual_candidates();  ///< One usual candidate for every cause.

/// Probabilities of candidates before a recording is looked at; they add up to 1. A stop that is not touched
/// leaves no trace, and about two in three machines of the usual ranges of a rub do not rub, or rub too deep:
/// candidates without rub have two thirds together. All rubs are equally likely, but centred and offset round
/// stops, which are one kind, count half each where both are listed.
std::vector<double> usual_prior(const std::vector<Candidate>& candidates);

/// Values of the unknowns at a point of the unit cube.
Point values_at(const Candidate& candidate, const Point& unit);

inline double value_of(const Point& point, Unknown unknown) {
  return point[static_cast<std::size_t>(unknown)];
}

}  // namespace rubsweep::diagnose
