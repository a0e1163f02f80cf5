#pragma once

#include <array>
#include <optional>
#include <random>
#include <string_view>

#include "rubsweep/core/model/machine.hpp"

namespace rubsweep::audit {

/// Arrangement of the stops of a random machine.
enum class StopKind {
  one_flat,        ///< one flat stop at any angle
  flats,           ///< two to four flat stops with independent numbers
  equal_flats,     ///< two to four equal or nearly equal ones: contacts begin and end almost together
  annular,         ///< centred around the rotor
  offset_annular,  ///< annular, with the rest position off its centre
  thin_flats,      ///< one to four flat stops with friction and a shaft so thin that slips reverse
  parallel_flats,  ///< two or three with dry friction and parallel or nearly parallel tangents
  ring_and_flats,  ///< an annular stop beside one or two flat ones, dry, of equal or nearly equal radii and
                   ///< clearances
  rings            ///< two annular stops with dry friction, concentric or nearly so
};
/// Kinds with several simultaneous dry contacts, which time stepping checks.
constexpr bool several_dry(StopKind kind) { return kind >= StopKind::parallel_flats; }
/// Kinds used by an audit if none is named.
inline constexpr std::array stop_kinds{StopKind::one_flat, StopKind::flats, StopKind::equal_flats,
                                       StopKind::annular, StopKind::offset_annular};

inline constexpr std::array named_stop_kinds{
    StopKind::one_flat,       StopKind::flats,          StopKind::equal_flats,
    StopKind::annular,        StopKind::offset_annular, StopKind::thin_flats,
    StopKind::parallel_flats, StopKind::ring_and_flats, StopKind::rings};

constexpr std::string_view to_string(StopKind kind) {
  constexpr std::array<std::string_view, 9> names{"one_flat",       "flats",          "equal_flats",
                                                  "annular",        "offset_annular", "thin_flats",
                                                  "parallel_flats", "ring_and_flats", "rings"};
  return names[static_cast<std::size_t>(kind)];
}

/// One cell of a random map.
struct RandomCell {
  model::Machine machine;
  double speed_hz = 0;
  double whirl_ratio = 0;
  std::optional<double> eccentricity_m{};  ///< replaces the whirl ratio, if given
};

/// Draws a machine, a speed between 0.5 and 7 times its natural frequency, and an unbalance that does not
/// touch without the kick. Masses, stiffnesses, dampings and casings vary over several orders of magnitude;
/// restitution is usual or close to one; all kinds of friction occur; the kick can reach the wall. With
/// several dry contacts there are also slow speeds and a weight that may press the rotor onto its stops.
RandomCell random_cell(StopKind kind, std::mt19937_64& random);

}  // namespace rubsweep::audit
