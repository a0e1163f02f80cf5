#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace rubsweep::fit {

/// Shaft angle phi = 2 pi (from_hz t + rate_hz_per_s t^2 / 2); or, of a speed that changes unevenly, straight
/// lines between the speeds at ascending instants, of which the first and last go on beyond them.
struct Ramp {
  double from_hz = 0;
  double rate_hz_per_s = 0;
  std::vector<double> knot_s{}, knot_hz{};  ///< empty, or two or more of each

  bool even() const { return knot_s.empty(); }
};
double speed_hz(const Ramp& ramp, double t_s);

/// Speed and angle of the shaft over time, in radians; the angle is 0 at t = 0, or at the first knot.
class RampTurning {
 public:
  explicit RampTurning(const Ramp& ramp);

  double speed(double t_s) const;  ///< rad/s
  double gain(double t_s) const;   ///< rate of the speed, rad/s^2
  double angle(double t_s) const;
  double most_gain() const { return most_gain_; }  ///< largest size of the rate

  /// Lowest and highest speed between two instants: at one of them or at a knot.
  std::pair<double, double> speeds_between(double from_s, double to_s) const;

 private:
  Ramp ramp_;
  std::vector<double> turns_;  ///< turns at the knots
  double most_gain_ = 0;
};

/// Readings after an impulse at standstill: samples x sensors, in metres.
struct RingDown {
  std::vector<double> t_s;
  Eigen::MatrixXd signal_m;
};

/// 1X during a run-up or coast-down: A of Re(A e^{i phi}), phi = 0 at the mark;
/// points x sensors.
struct RunUp {
  Ramp ramp;
  std::vector<double> t_s;
  Eigen::MatrixXcd phasor_m;
  double window_turns = 0;  ///< number of turns that each point is the mean of
  /// Means of twice the readings times e^{-i phi} from mark to mark, as rubscope has them, and not of A.
  bool from_readings = false;
};

/// 1X at steady speeds: speeds x sensors.
struct Steady {
  std::vector<double> speed_hz;
  Eigen::MatrixXcd phasor_m;
};

/// Lines of the full spectrum of a rub that repeats after whole turns: L of x + iy = sum of L e^{i order
/// phi}, phi = 0 at the mark.
struct RubLines {
  double speed_hz = 0;
  int turns = 1;              ///< turns of the period
  std::vector<double> order;  ///< multiples of 1 / turns other than 0
  Eigen::VectorXcd line_m;
};

/// One file of data; sensors in the order of the configuration's sensors (of a Jeffcott rotor x and y).
struct MeasuredData {
  std::string name;  ///< name of the file
  std::variant<RingDown, RunUp, Steady, RubLines> data;
  bool run_out = false;  ///< a constant of every sensor is eliminated from 1X
};

/// Table with t_s and sensor_0_m, sensor_1_m, ...: as rubtrace writes sensors.csv. Times before `from_s` are
/// left out. Throws IoError with file:line for what is no such table, as the others do, ConfigError for fewer
/// than 8 rows.
RingDown read_ring_down(const std::filesystem::path& file, double from_s);

/// bode.csv of rubscope: t_s, speed_hz, order, x_amplitude_m, x_phase_deg and perhaps y; of order 1 every
/// second row is taken, since each is the mean of two turns. The ramp is that of measured_ramp. Throws
/// ConfigError where times do not rise.
RunUp read_run_up(const std::filesystem::path& file);

/// Meaning of the phases of a table: degrees from the instant at which the mark passes each sensor, negative
/// where the displacement lags (bode.csv of rubtrace); the same from the one instant of the mark (bode.csv of
/// rubscope); or degrees by which the positive peak lags behind the one mark, as instruments have it.
enum class PhaseConvention { sensor, mark, lag };

/// Table of speed_hz, sensor_0_amplitude_m, sensor_0_phase_deg, ...; sensors look in directions `angle_deg`.
Steady read_steady(const std::filesystem::path& file, const std::vector<double>& angle_deg,
                   PhaseConvention convention = PhaseConvention::sensor);

/// Whether phases of these data are of a table, and mean what is said beside it.
bool has_phases_of_a_table(const MeasuredData& data);

/// The phases of such data taken in another meaning than the one that they were read in.
void take_phases_as(PhaseConvention other, PhaseConvention read_as, const std::vector<double>& angle_deg,
                    MeasuredData& data);

/// Directory that rubscope wrote of a steady recording by two probes: speed and period of measures.csv, lines
/// of lines.csv but the gap (0X) and those that noise leaves no phase. Throws ConfigError for a motion
/// without a period, or with one that is no whole number from 1 to 64.
RubLines read_rub(const std::filesystem::path& directory);

/// The same speeds as a run-up of this rate, each a mean of `window_turns`.
RunUp as_run_up(const Steady& steady, double rate_hz_per_s, double window_turns);

}  // namespace rubsweep::fit
