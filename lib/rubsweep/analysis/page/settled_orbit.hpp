#pragma once

#include <complex>
#include <optional>
#include <string_view>
#include <vector>

#include "rubsweep/core/response/motion/workspace.hpp"
#include "rubsweep/core/response/spectrum/full_spectrum.hpp"
#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::page {

/// Facts from the row of a map that the recording of its settled motion needs.
struct KnownMotion {
  std::string_view motion_class;  ///< class as map.csv writes it
  std::optional<int> order;       ///< order of a periodic motion
  long revolutions = 0;           ///< after which the verdict stood
  bool proven = false;            ///< multipliers prove it; the run was on its way to the motion by then
  std::optional<double> hertz_force_n{};  ///< force of the last secants of Hertz' contacts
};

/// The settled motion of one cell, long enough to be drawn. Lengths in metres, as deviations from rest.
struct SettledOrbit {
  long first_revolution = 0;  ///< since the start of the kick, where the signals begin
  int turns = 0;
  int steps_per_turn = 0;
  /// x and y of the rotor, then for each stop the casing's x and y and the gap (< 0: penetration); each
  /// turns x steps_per_turn + 1 samples at equal distances, both ends included.
  std::vector<std::vector<double>> signals;
  std::vector<std::complex<double>> section_m;  ///< once per turn; of an aperiodic motion over more turns
  response::spectrum::FullSpectrum spectrum;    ///< spectrum over the window that the map takes
};

/// Most turns of a motion without a period that are drawn.
inline constexpr int longest_aperiodic_history = 6;

/// Fewest samples of a turn before redundant ones are left out of a drawing.
inline constexpr int fewest_steps_per_turn = 256;

/// Runs a cell of `study` again until its motion has settled and records it: a periodic motion for one
/// period, as soon as its section returns within 1e-5 clearances; a rotor at rest from its closed form for
/// one turn; a proven motion without a period from one window after its verdict on; any other at the end of
/// response.max_revolutions. The section of a motion without a period covers as much as two windows. The
/// instants and the solver are those of the map, so that rubtrace shows the same. Empty where the cell has no
/// motion: it failed, could not start, or failed when run on.
std::optional<SettledOrbit> settled_orbit(const sweep::Study& study, const scene::PreparedMachine& prepared,
                                          std::size_t cell, const KnownMotion& known,
                                          response::motion::Workspace& workspace);

}  // namespace rubsweep::page
