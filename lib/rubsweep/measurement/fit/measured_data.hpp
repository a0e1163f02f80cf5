#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace rubsweep::fit {

/// Shaft angle phi = 2 pi (from_hz t + rate_hz_per_s t^2 / 2). With knots, the speed is piecewise linear
/// between speeds at ascending instants; the first and the last line are extended.
struct Ramp {
  double from_hz = 0;
  double rate_hz_per_s = 0;
  std::vector<double> knot_s{}, knot_hz{};  ///< both empty, or two or more knots

  bool even() const { return knot_s.empty(); }
};
double speed_hz(const Ramp& ramp, double t_s);

/// Speed and angle of the shaft as functions of time, in rad/s and radians; the angle is 0 at t = 0, or at
/// the first knot.
class RampTurning {
 public:
  explicit RampTurning(const Ramp& ramp);

  double speed(double t_s) const;  ///< rad/s
  double gain(double t_s) const;   ///< rate of change of the speed, rad/s^2
  double angle(double t_s) const;
  double most_gain() const { return most_gain_; }  ///< largest magnitude of `gain`, rad/s^2

  /// Lowest and highest speed between two instants; each occurs at an end or at a knot.
  std::pair<double, double> speeds_between(double from_s, double to_s) const;

 private:
  Ramp ramp_;
  std::vector<double> turns_;  ///< turns at the knots
  double most_gain_ = 0;
};

/// Readings after an impulse at standstill: one row per sample, one column per sensor, in metres.
struct RingDown {
  std::vector<double> t_s;
  Eigen::MatrixXd signal_m;
};

/// 1X during a run-up or coast-down: A of Re(A e^{i phi}), phi = 0 at the mark; one row per instant, one
/// column per sensor.
struct RunUp {
  Ramp ramp;
  std::vector<double> t_s;
  Eigen::MatrixXcd phasor_m;
  double window_turns = 0;  ///< number of turns over which each value is averaged
  /// Whether each value is the mean of twice the readings times e^{-i phi} from mark to mark, as rubscope
  /// computes it, instead of the mean of A.
  bool from_readings = false;
};

/// 1X at steady speeds: one row per speed, one column per sensor.
struct Steady {
  std::vector<double> speed_hz;
  Eigen::MatrixXcd phasor_m;
};

/// Lines of the full spectrum of a rub that repeats after whole turns. x + iy is the sum of L e^{i order phi}
/// over the lines L; phi = 0 at the mark.
struct RubLines {
  double speed_hz = 0;
  int turns = 1;              ///< period in turns
  std::vector<double> order;  ///< multiples of 1 / turns other than 0
  Eigen::VectorXcd line_m;
};

/// One file of data; its sensors are in the order of the configuration (for a Jeffcott rotor x and y).
struct MeasuredData {
  std::string name;  ///< name of the file
  std::variant<RingDown, RunUp, Steady, RubLines> data;
  bool run_out = false;  ///< a constant per sensor is eliminated from its 1X
};

/// Reads a table with t_s and sensor_0_m, sensor_1_m, ..., as rubtrace writes sensors.csv. Times before
/// `from_s` are left out. Throws IoError with file:line for another kind of table, like the other readers,
/// and ConfigError for fewer than 8 rows.
RingDown read_ring_down(const std::filesystem::path& file, double from_s);

/// Reads bode.csv of rubscope: t_s, speed_hz, order, x_amplitude_m, x_phase_deg and, with two probes, y.
/// Every second row of order 1 is used, because each row is the mean of two turns. The ramp comes from
/// measured_ramp. Throws ConfigError where times do not ascend.
RunUp read_run_up(const std::filesystem::path& file);

/// Meaning of a table's phases, in degrees. `sensor`: from the instant when the mark passes the sensor
/// itself, negative where the displacement lags (bode.csv of rubtrace). `mark`: the same, from the single
/// instant of the mark (bode.csv of rubscope). `lag`: lag of the positive peak behind the single mark, as
/// instruments show it.
enum class PhaseConvention { sensor, mark, lag };

/// Reads a table of speed_hz, sensor_0_amplitude_m, sensor_0_phase_deg, ...; `angle_deg`: directions of the
/// sensors.
Steady read_steady(const std::filesystem::path& file, const std::vector<double>& angle_deg,
                   PhaseConvention convention = PhaseConvention::sensor);

/// Whether the phases of these data come from a table, so that their convention has to be given.
bool has_phases_of_a_table(const MeasuredData& data);

/// Converts the phases of such data from the convention in which they were read to another convention.
void take_phases_as(PhaseConvention other, PhaseConvention read_as, const std::vector<double>& angle_deg,
                    MeasuredData& data);

/// Reads the directory that rubscope wrote for a steady recording by two probes: speed and period from
/// measures.csv, lines from lines.csv without the gap (0X) and lines whose phase is lost in noise. Throws
/// ConfigError for a motion without a period, or with a period that is not a whole number from 1 to 64.
RubLines read_rub(const std::filesystem::path& directory);

/// Run-up through the same speeds at this rate; each of its values is a mean over `window_turns` turns.
RunUp as_run_up(const Steady& steady, double rate_hz_per_s, double window_turns);

}  // namespace rubsweep::fit
