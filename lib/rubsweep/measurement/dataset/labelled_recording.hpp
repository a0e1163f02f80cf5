#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/measurement/dataset/data_study.hpp"
#include "rubsweep/measurement/diagnose/random_stream.hpp"
#include "rubsweep/measurement/diagnose/simulated_motion.hpp"

namespace rubsweep::dataset {

/// Purposes of the random numbers of a set.
enum Purpose : std::uint64_t { of_machine, of_recording, of_readings };

/// Numbers of a machine that its recordings have in common.
struct MachineDraw {
  diagnose::Point unit{};  ///< places in the ranges of its candidate; those of one recording are drawn anew
  double clearance_m = 0, stop_angle_deg = 0, mark_turns = 0;
  std::string_view part{};     ///< training, validation or test
  std::vector<double> gain{};  ///< gain of each probe
};

/// Candidates take turns.
std::size_t candidate_of(const DataStudy& study, std::size_t machine);

/// Depends on the study and the number of the machine alone.
MachineDraw draw_machine(const DataStudy& study, std::size_t machine);

/// One recording and all that is known of it.
struct LabelledRecording {
  std::size_t index = 0, machine = 0, candidate = 0;
  std::string_view part{};  ///< training, validation or test, the same for all recordings of a machine
  diagnose::Point values{};
  double speed_hz = 0, clearance_m = 0, stop_angle_deg = 0;
  double mark_turns = 0;                          ///< turns of the shaft from the first reading to the mark
  double noise_m = 0;                             ///< standard deviation of every reading
  std::vector<double> gain{};                     ///< gain of each probe
  double penetration_ratio = 0, force_ratio = 0;  ///< ratios as RubBounds has them
  diagnose::SimulatedMotion motion{};             ///< label; its samples are used up
  std::string sha256{};                           ///< digest of its file, once that is written
  std::vector<double> t_s{}, x_m{}, y_m{}, keyphasor_v{};  ///< y_m: of two probes
};

/// Voltage of the keyphasor beside its mark and at it.
inline constexpr double no_mark_v = -2, mark_v = -12;

/// Makes the recording of that index. Of its machine are its stops, frequency, damping, clearance and
/// contact, where its stop stands and where its mark is, and the gains of its probes; its own are speed,
/// unbalance, the kick that started it, and its noise, drawn until the rub stays within the study's bounds.
/// Depends on its arguments alone. Throws SolverError where many draws in a row cannot be simulated or do
/// not.
LabelledRecording make_recording(const DataStudy& study, std::size_t index,
                                 response::motion::Workspace& workspace);

/// Share of a turn that the mark on the shaft passes the keyphasor: of the fewest readings a turn that a
/// study may have, which are 5, one at least falls on the mark.
inline constexpr double mark_share = 0.25;

/// Fills the columns of a recording from its motion: readings at even times from 0 on, with lines of other
/// origin, gains and noise; the leading edge of the mark passes `mark_turns` after the begin of each turn.
void read_motion(const Measurement& measurement, diagnose::RandomStream& random,
                 LabelledRecording& recording);

}  // namespace rubsweep::dataset
