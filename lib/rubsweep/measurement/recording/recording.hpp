#pragma once

#include <array>
#include <complex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "rubsweep/measurement/recording/integrated.hpp"
#include "rubsweep/measurement/recording/readings.hpp"
#include "rubsweep/measurement/recording/shaft_turns.hpp"

namespace rubsweep::recording {

inline constexpr int samples_per_revolution = 128;  ///< Number of samples per turn of the shaft.

/// Turns of a shaft whose speed changes, found from its line in the readings.
struct FollowedTurns {
  std::vector<double> begin_s;         ///< beginnings of turns
  double speed_uncertainty_hz = 0;     ///< standard, of the speed at an instant
  double angle_uncertainty_turns = 0;  ///< standard, of an angle beside those nearby
  std::string finding{};               ///< what has to be said of them
};

/// Measured motion over whole turns of the shaft, sampled at equal angles.
struct Recording {
  double sampling_rate_hz = 0;
  std::vector<double> turn_begin_s{};  ///< instants at which turns begin, and the end of the last one
  /// Displacement x + iy in metres, samples_per_revolution values per turn. With one probe, its real reading.
  std::vector<std::complex<double>> displacement_m{};
  /// Where velocity or acceleration was measured: the same samples of it over powers of the mean angular
  /// speed, so that its lines are those of the displacement times (i order)^times; else empty.
  std::vector<std::complex<double>> measured_m{};
  bool plane = false;      ///< measured by two probes
  bool phased = true;      ///< false: turns follow the line of the shaft, so that its phase is not known
  bool from_rest = false;  ///< whether displacements are measured from the rest position of the rotor
  AngleDoubt angle_doubt{};
  Integration integration{};
  Place place = Place::shaft;
  std::optional<MachineGroup> machine_group{};
  std::optional<std::array<double, 3>> zone_limits_mm_per_s{}, zone_limits_um{};
  std::vector<ProbeSignal> probes{};    ///< readings over the evaluated turns
  std::vector<std::string> findings{};  ///< faults of the data: sentences without a full stop

  int turns() const { return static_cast<int>(turn_begin_s.size()) - 1; }
  double mean_speed_hz() const { return mean_speed_hz(0, turns()); }
  double mean_speed_hz(int first_turn, int turns) const {
    const double* begin_s = turn_begin_s.data() + first_turn;
    return turns / (begin_s[turns] - begin_s[0]);
  }
  std::span<const std::complex<double>> samples(int first_turn, int turns) const {
    const auto count = [](int any) { return static_cast<std::size_t>(any) * samples_per_revolution; };
    return std::span(displacement_m).subspan(count(first_turn), count(turns));
  }
};

/// Makes a recording from the columns and the instrument's description, and subtracts the run-out of the
/// shaft where a slow interval is given. Velocities and accelerations are integrated. Of the turns without
/// gaps the longest stretch is kept. Findings: gaps, a clipped signal (its extreme value too often in a row,
/// or too often in all), a dead probe, a speed that changes by more than 1 % from turn to turn, vibration
/// near half the sampling rate. Throws ConfigError, with `name`:line where a row is at fault: for missing
/// columns, unknown units, probes of different quantities or places, rest or run-out of others than
/// displacement, uneven times, and fewer turns than `fewest_turns`.
/// `followed`: turns of a shaft with `instrument.sweep`.
Recording make_recording(const Channels& channels, const Instrument& instrument, const std::string& name,
                         const FollowedTurns* followed = nullptr);

}  // namespace rubsweep::recording
