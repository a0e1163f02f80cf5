#include "rubsweep/diagnose/features/phase_features.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "turned_lines.hpp"
#include "value_of.hpp"

namespace rubsweep::diagnose::features {
namespace {

/// Length that a line's arrow keeps in a point.
double kept(const MotionLines& lines, int k) {
  const double length = std::abs(lines.at(k));
  return length / (length + 0.01 * size_of(lines));
}

TEST(PhaseFeatures, ArePhasesOfLinesToEachOther) {
  const MotionLines lines = crooked_motion();
  const Features features = phase_features(lines, true);
  const double phase = 2 * std::arg(lines.at(24)) - std::arg(lines.at(12)) - std::arg(lines.at(36));
  const double length = kept(lines, 24) * kept(lines, 24) * kept(lines, 12) * kept(lines, 36);
  EXPECT_NEAR(value_of(features, "phase of 4/2, 4/2 to 2/2, 6/2, cosine"), length * std::cos(phase), 1e-12);
  EXPECT_NEAR(value_of(features, "phase of 4/2, 4/2 to 2/2, 6/2, sine"), length * std::sin(phase), 1e-12);
}

TEST(PhaseFeatures, OfOneProbeArePhasesToMultiplesOfAnother) {
  const MotionLines lines = one_reading(crooked_motion());
  const Features features = phase_features(lines, false);
  const double phase = std::arg(lines.at(24)) - 2 * std::arg(lines.at(12));
  const double length = kept(lines, 24) * kept(lines, 12) * kept(lines, 12);
  EXPECT_NEAR(value_of(features, "phase of 4/2 to 2 times 2/2, cosine"), length * std::cos(phase), 1e-12);
  EXPECT_NEAR(value_of(features, "phase of 4/2 to 2 times 2/2, sine"), length * std::sin(phase), 1e-12);
}

TEST(PhaseFeatures, AreNearTheMiddleWhereLinesAreWeak) {
  MotionLines lines{12, Eigen::VectorXcd::Zero(2 * 72 + 1)};
  lines.at(12) = 1;
  for (const Feature& feature : phase_features(lines, true)) EXPECT_EQ(feature.value, 0) << feature.name;
}

}  // namespace
}  // namespace rubsweep::diagnose::features
