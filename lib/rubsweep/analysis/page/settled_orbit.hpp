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

/// Facts from the row of a map that are needed to record its settled motion.
struct KnownMotion {
  std::string_view motion_class;  ///< class as map.csv writes it
  std::optional<int> order;       ///< order of a periodic motion
  long revolutions = 0;           ///< number of revolutions before the classification
  bool proven = false;            ///< true: proven by multipliers, possibly before the run had settled
  std::optional<double> hertz_force_n{};  ///< force of the last secants of Hertz' contacts
};

/// The settled motion of one cell, long enough to be drawn. Lengths in metres, as deviations from rest.
struct SettledOrbit {
  /// number of the revolution at which the signals begin, counted from the start of the kick
  long first_revolution = 0;
  int turns = 0;
  int steps_per_turn = 0;
  /// Signals in m: x and y of the rotor, then for each stop x and y of the casing and the gap (< 0:
  /// penetration). Each signal has turns x steps_per_turn + 1 equidistant samples, both ends included.
  std::vector<std::vector<double>> signals;
  std::vector<std::complex<double>> section_m;  ///< one per turn, over more turns if aperiodic
  response::spectrum::FullSpectrum spectrum;    ///< spectrum over the same window as in the map
};

/// Largest number of turns that are drawn of a motion without a period.
inline constexpr int longest_aperiodic_history = 6;

/// Smallest number of samples per turn, before samples that a drawing does not need are left out.
inline constexpr int fewest_steps_per_turn = 256;

/// Runs a cell of `study` again until its motion has settled, and records it. A periodic motion is recorded
/// for one period, as soon as its section returns within 1e-5 clearances. A rotor at rest is recorded for one
/// turn, from its closed form. A proven motion without a period is recorded one window after its proof, any
/// other motion at the end of response.max_revolutions. The section of a motion without a period covers two
/// windows. Sampling and solver are those of the map, so that rubtrace shows the same motion. Empty where the
/// cell has no motion: it failed, could not start, or failed when continued.
std::optional<SettledOrbit> settled_orbit(const sweep::Study& study, const scene::PreparedMachine& prepared,
                                          std::size_t cell, const KnownMotion& known,
                                          response::motion::Workspace& workspace);

}  // namespace rubsweep::page
