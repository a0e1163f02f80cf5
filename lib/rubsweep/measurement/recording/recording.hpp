#pragma once

#include <complex>
#include <span>
#include <string>
#include <vector>

#include "rubsweep/measurement/recording/channels.hpp"
#include "rubsweep/measurement/recording/instrument.hpp"
#include "rubsweep/measurement/recording/shaft_turns.hpp"

namespace rubsweep::recording {

/// Samples of one turn of the shaft.
inline constexpr int samples_per_revolution = 128;

/// Measured motion over whole turns of the shaft, at equal angles.
struct Recording {
  double sampling_rate_hz = 0;
  std::vector<double> turn_begin_s{};  ///< begins of the turns, and the end of the last one
  /// Displacement x + iy in metres, samples_per_revolution of every turn; of one probe its reading, real.
  std::vector<std::complex<double>> displacement_m{};
  bool plane = false;      ///< two probes
  bool from_rest = false;  ///< displacements count from where the rotor rests
  AngleDoubt angle_doubt{};
  std::vector<std::string> findings{};  ///< faults of the numbers, sentences without a full stop

  int turns() const { return static_cast<int>(turn_begin_s.size()) - 1; }
  double mean_speed_hz() const { return turns() / (turn_begin_s.back() - turn_begin_s.front()); }
};

/// Fewest whole turns that are worth to be looked at.
inline constexpr int fewest_turns = 4;

/// Puts columns and instrument together, and subtracts the run-out of the shaft where a slow stretch is
/// named. Turns that a gap in a signal touches are left out: the longest stretch without one stays. Findings:
/// gaps, a clipped signal (its largest or smallest value too often in a row, or too often in all), a
/// dead probe, a speed that changes by more than 1 % from one turn to the next, vibration near half the
/// sampling rate. Throws ConfigError, with `name`:line where a row is at fault, for columns that are not
/// there, units that are not known, times that are not evenly spaced, and fewer turns than `fewest_turns`.
Recording make_recording(const Channels& channels, const Instrument& instrument, const std::string& name);

/// Run-out of a shaft: the mean turn of a slow stretch, whose `displacement_m` has samples_per_turn of
/// every whole turn. Its own mean, the gap, is left out. `vector`: its component that turns with the shaft
/// alone, in both directions, as instruments with a slow-roll vector do. Turns with a gap (NaN) are left out.
/// Throws ConfigError where no turn is without one.
std::vector<std::complex<double>> run_out_of(std::span<const std::complex<double>> displacement_m,
                                             int samples_per_turn, bool vector);

/// Subtracts a run-out from every turn.
void subtract_run_out(std::span<std::complex<double>> displacement_m,
                      std::span<const std::complex<double>> run_out_m);

}  // namespace rubsweep::recording
