#pragma once

#include <array>
#include <optional>
#include <random>
#include <string_view>

#include "rubsweep/core/model/machine.hpp"

namespace rubsweep::audit {

/// Stops around the rotor of a random machine.
enum class StopKind {
  one_flat,        ///< one flat stop at any angle
  flats,           ///< two to four, each with numbers of its own
  equal_flats,     ///< two to four alike, or nearly: contacts begin and end at nearly equal instants
  annular,         ///< centred around the rotor
  offset_annular,  ///< the rotor rests off its centre
  thin_flats,      ///< one to four flat stops with friction around a shaft so thin that slips reverse
  parallel_flats,  ///< two or three with dry friction whose tangents are parallel, or nearly
  ring_and_flats,  ///< an annular stop beside one or two flat ones, dry, of equal or nearly equal radii and
                   ///< clearances
  rings            ///< two annular stops with dry friction, concentric or nearly
};
/// Kinds with several dry contacts at once, which time stepping makes again.
constexpr bool several_dry(StopKind kind) { return kind >= StopKind::parallel_flats; }
/// Kinds that an audit draws where none is named.
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
  std::optional<double> eccentricity_m{};  ///< takes the place of the whirl ratio where it is given
};

/// Draws a machine, a speed between half and seven times its natural frequency, and an unbalance that does
/// not touch without the kick: masses, stiffnesses, dampings and casings over several orders of magnitude,
/// usual restitution and restitution near one, every kind of friction, a kick that can reach the wall. Where
/// several contacts are dry, slow speeds and a weight that may press the rotor on its stops, too.
RandomCell random_cell(StopKind kind, std::mt19937_64& random);

}  // namespace rubsweep::audit
