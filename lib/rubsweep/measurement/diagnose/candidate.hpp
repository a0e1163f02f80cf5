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

/// Kind of stops that a candidate has.
enum class Cause {
  no_rub,         ///< nothing is touched
  one_side,       ///< one flat stop
  two_sides,      ///< two flat stops that face each other
  annular,        ///< a round stop about the rest position
  annular_offset  ///< a round stop whose centre is somewhere else
};
constexpr std::string_view to_string(Cause cause) { return enumerator_word(cause); }
inline constexpr auto cause_words = words_of<Cause>();
inline constexpr auto& all_causes = cause_words.values;

/// Numbers that a recording alone does not tell. Angles count from the stop.
enum class Unknown : std::size_t {
  natural_frequency,  ///< frequency of the rotor, Hz
  damping_ratio,
  whirl_ratio,             ///< quiet whirl / clearance left
  stiffness,               ///< stiffness of the contact, N/m
  restitution,             ///< nominal
  friction,                ///< dry coefficient
  casing_mass,             ///< kg
  casing_frequency,        ///< frequency of the casing on its mount, Hz
  kick_ratio,              ///< velocity after the kick / (clearance x natural angular frequency)
  kick_angle,              ///< degrees from the stop
  kick_phase,              ///< angle of the shaft, degrees
  second_clearance_ratio,  ///< two_sides: clearance of the second stop / that of the first one
  offset_ratio,            ///< annular_offset: offset / clearance
  stop_angle,  ///< degrees from +x; 0 where the machine looks the same from all directions without the stop
  position,    ///< place of the stops along the shaft of a rotor kit, m
  kit          ///< place in KnownKit::likely, as a share of them
};
inline constexpr std::size_t unknown_count = 16;

/// A number for every unknown: its values, or places in the unit interval where its Spread has them.
using Point = std::array<double, unknown_count>;

struct UnknownRow {
  Unknown unknown;
  std::string_view key;  ///< in a file of candidates
  model::Range range;    ///< values that a machine may have
  Spread usual;          ///< unless a file says otherwise
  bool logarithmic;      ///< how an interval of a file is meant
  bool of_file = true;   ///< may be said in a file; false: the machine or the recording says it
  bool of_kit = false;   ///< a Jeffcott rotor has none
};
const std::array<UnknownRow, unknown_count>& unknown_rows();

/// One explanation that is asked about.
struct Candidate {
  std::string name;
  Cause cause = Cause::no_rub;
  std::array<Spread, unknown_count> spreads{};
  Spread clearance_m{};  ///< clearance of the first stop; usual candidates have none, the study says it
  std::optional<Spread> position_m{};  ///< along the shaft of a rotor kit; else all places that it may have
};

Spread& spread_of(Candidate& candidate, Unknown unknown);
const Spread& spread_of(const Candidate& candidate, Unknown unknown);

/// A candidate with the usual ranges; numbers that its stops do not have are known (bounds that are equal).
Candidate usual_candidate(Cause cause);

/// One of every cause.
std::vector<Candidate> usual_candidates();

/// Values at a place in the unit cube.
Point values_at(const Candidate& candidate, const Point& unit);

inline double value_of(const Point& point, Unknown unknown) {
  return point[static_cast<std::size_t>(unknown)];
}

}  // namespace rubsweep::diagnose
