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

/// Purposes that keep the random streams of a data set apart.
enum Purpose : std::uint64_t { of_machine, of_recording, of_readings, of_other_cause };

/// Numbers of a machine that its recordings have in common.
struct MachineDraw {
  diagnose::Point unit{};  ///< values in unit ranges of the candidate; some are drawn again each time
  double clearance_m = 0, stop_angle_deg = 0, mark_turns = 0;
  std::string_view part{};     ///< training, validation or test
  std::vector<double> gain{};  ///< gain of each probe
};

/// Index of the candidate for a machine: the machines go through the candidates in turn.
std::size_t candidate_of(const DataStudy& study, std::size_t machine);

/// Draws the numbers of a machine; they depend on the study and the machine's index alone.
MachineDraw draw_machine(const DataStudy& study, std::size_t machine);

/// One recording and everything that is known about its machine and motion.
struct LabelledRecording {
  std::size_t index = 0, machine = 0, candidate = 0;
  std::string_view part{};  ///< training, validation or test, the same for all recordings of a machine
  diagnose::Point values{};
  double speed_hz = 0, clearance_m = 0, stop_angle_deg = 0;
  double mark_turns = 0;                          ///< turns of the shaft from the first reading to the mark
  double noise_m = 0;                             ///< standard deviation of every reading
  std::vector<double> gain{};                     ///< gain of each probe
  double penetration_ratio = 0, force_ratio = 0;  ///< ratios as defined in RubBounds
  double peak_acceleration_m_per_s2 = 0;          ///< of the rotor, from samples_per_revolution points a turn
  diagnose::SimulatedMotion motion{};             ///< label; its samples are replaced by the readings
  std::string other_cause{};  ///< kinds of vibrations of another cause, as in OtherVibration; empty: none
  std::string sha256{};       ///< digest of the recording's file, once the file is written
  std::vector<double> t_s{}, x_m{}, y_m{}, keyphasor_v{};  ///< y_m: empty with one probe
};

/// Voltage of the keyphasor away from its mark and at the mark.
inline constexpr double no_mark_v = -2, mark_v = -12;

/// Makes the recording with index `index`. The machine fixes stops, frequency, damping, clearance, contact,
/// the angles of stop and mark, and the gains of the probes. Speed, unbalance, the kick at the start and the
/// noise are drawn for each recording until the rub stays within the study's limits. The result depends on
/// the arguments alone. Throws SolverError where many draws in a row cannot be simulated or exceed the
/// limits.
LabelledRecording make_recording(const DataStudy& study, std::size_t index,
                                 response::motion::Workspace& workspace);

/// Share of a turn during which the mark passes the keyphasor. With the fewest readings per turn that a study
/// may have, 5, at least one reading still falls on the mark.
inline constexpr double mark_share = 0.25;

/// Fills the columns of a recording from its motion: equidistant readings from t = 0 on, with lines of other
/// origin, probe gains and noise. The leading edge of the mark passes `mark_turns` after the beginning of
/// each turn.
void read_motion(const Measurement& measurement, diagnose::RandomStream& random,
                 LabelledRecording& recording);

}  // namespace rubsweep::dataset
