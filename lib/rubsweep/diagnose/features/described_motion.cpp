#include "rubsweep/diagnose/features/described_motion.hpp"

#include <cmath>
#include <complex>
#include <string>

#include "rubsweep/diagnose/features/line_features.hpp"
#include "rubsweep/diagnose/features/phase_features.hpp"
#include "rubsweep/diagnose/features/waveform_features.hpp"

namespace rubsweep::diagnose::features {
namespace {

using Complex = std::complex<double>;

void add_direction(const std::string& name, double angle_rad, Features& features) {
  add(features, "cosine of " + name, std::cos(angle_rad));
  add(features, "sine of " + name, std::sin(angle_rad));
}

/// Along the lopsided direction and to its left, so that it stays the same when all is turned.
void add_mean(const MotionLines& lines, const View& view, const DescribedMotion& motion, Features& features) {
  const Complex mean = lines.at(0) / motion.size_m * std::polar(1.0, -motion.direction_rad);
  add(features, view.plane ? "mean position along lopsided direction" : "mean position", mean.real());
  if (view.plane) add(features, "mean position across lopsided direction", mean.imag());
}

}  // namespace

DescribedMotion describe(const MotionLines& lines, const View& view,
                         response::spectrum::SpectrumWorkspace& workspace) {
  constexpr int samples_of_a_turn = 32;
  const Eigen::VectorXcd waveform = waveform_of(lines, samples_of_a_turn, workspace);
  DescribedMotion motion{line_features(lines, view.plane), size_of(lines),
                         view.plane ? lopsided_direction(waveform) : 0};
  for (const Features& further : {phase_features(lines, view.plane),
                                  view.plane ? orbit_features(waveform) : signal_features(waveform.real())})
    motion.features.insert(motion.features.end(), further.begin(), further.end());
  if (view.plane && view.directions) {
    add_direction("lopsided direction", motion.direction_rad, motion.features);
    // An ellipse a e^{i phi} + b e^{-i phi} is longest along half the angle of a b.
    add_direction("twice the direction in which 1X is longest",
                  std::arg(lines.at(lines.turns) * lines.at(-lines.turns)), motion.features);
  }
  if (view.from_rest) add_mean(lines, view, motion, motion.features);
  return motion;
}

Eigen::VectorXd values_of(const Features& features) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(features.size()));
  for (Eigen::Index i = 0; i < values.size(); ++i) values(i) = features[static_cast<std::size_t>(i)].value;
  return values;
}

}  // namespace rubsweep::diagnose::features
