#include "rubsweep/measurement/dataset/readings.hpp"

#include <cmath>
#include <complex>

#include "rubsweep/measurement/recording/shaft_turns.hpp"

namespace rubsweep::dataset {
namespace {

using diagnose::samples_per_revolution;

/// Readings of one direction at times that are in turns of the shaft.
std::vector<double> read(const std::vector<std::complex<double>>& motion, bool y,
                         const std::vector<double>& turns) {
  std::vector<double> signal;
  for (const std::complex<double> z : motion) signal.push_back(y ? z.imag() : z.real());
  // A reading is one sample of a stretch of its own; the last time only ends the last stretch.
  std::vector<double> ends = turns;
  ends.push_back(2 * turns.back() - turns[turns.size() - 2]);
  return recording::at_equal_angles(signal, 0, samples_per_revolution, ends, 1);
}

}  // namespace

void read_motion(const Measurement& measurement, diagnose::RandomStream& random,
                 LabelledRecording& recording) {
  std::vector<std::complex<double>>& motion = recording.motion.displacement_m;
  const double size_m = diagnose::size_of(motion);
  add_other_lines(motion, measurement.other_lines, size_m, random);
  recording.noise_m = size_m * value_at(measurement.noise_share, random.uniform());
  const auto samples = static_cast<double>(motion.size() - 1);
  std::vector<double> turns;
  for (long k = 0;; ++k) {
    const double t_s = static_cast<double>(k) / measurement.sampling_rate_hz, turn = t_s * recording.speed_hz;
    if (turn * samples_per_revolution > samples) break;
    turns.push_back(turn);
    recording.t_s.push_back(t_s);
    const double since_mark = turn - recording.mark_turns - std::floor(turn - recording.mark_turns);
    recording.keyphasor_v.push_back(since_mark < mark_share ? mark_v : no_mark_v);
  }
  for (std::size_t probe = 0; probe < recording.gain.size(); ++probe) {
    std::vector<double>& column = probe == 0 ? recording.x_m : recording.y_m;
    column = read(motion, probe == 1, turns);
    for (double& value : column) value = recording.gain[probe] * value + recording.noise_m * random.normal();
  }
}

}  // namespace rubsweep::dataset
