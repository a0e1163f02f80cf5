#include "rubsweep/diagnose/features/described_motion.hpp"

#include "rubsweep/diagnose/features/line_features.hpp"
#include "rubsweep/diagnose/features/waveform_features.hpp"

namespace rubsweep::diagnose::features {

DescribedMotion describe(const MotionLines& lines, bool plane,
                         response::spectrum::SpectrumWorkspace& workspace) {
  constexpr int samples_of_a_turn = 32;
  const Eigen::VectorXcd waveform = waveform_of(lines, samples_of_a_turn, workspace);
  DescribedMotion motion{line_features(lines, plane), size_of(lines),
                         plane ? lopsided_direction(waveform) : 0};
  const Features shape = plane ? orbit_features(waveform) : signal_features(waveform.real());
  motion.features.insert(motion.features.end(), shape.begin(), shape.end());
  return motion;
}

Eigen::VectorXd values_of(const Features& features) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(features.size()));
  for (Eigen::Index i = 0; i < values.size(); ++i) values(i) = features[static_cast<std::size_t>(i)].value;
  return values;
}

}  // namespace rubsweep::diagnose::features
