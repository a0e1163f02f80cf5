#include "rubsweep/measurement/diagnose/features/described_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <set>

#include "turned_lines.hpp"
#include "value_of.hpp"

namespace rubsweep::diagnose::features {
namespace {

using std::numbers::pi;

Eigen::VectorXcd circle(int count) {
  Eigen::VectorXcd z(count);
  for (int k = 0; k < count; ++k) z(k) = std::polar(2.0, 2 * std::numbers::pi * k / count);
  return z;
}

TEST(DescribedMotionWaveformFeatures, OfACircleAreThoseOfASine) {
  const Features features = orbit_features(circle(64));
  EXPECT_NEAR(value_of(features, "ovality"), 0, 1e-12);
  EXPECT_NEAR(value_of(features, "lopsidedness"), 0, 1e-12);
  EXPECT_NEAR(value_of(features, "kurtosis of extent along"), 1.5, 1e-12);
  EXPECT_NEAR(value_of(features, "radius of 50 %"), 1, 1e-12);
  EXPECT_EQ(value_of(features, "share of backward whirl"), 0);
}

TEST(DescribedMotionWaveformFeatures, KnowBackwardWhirlFromForward) {
  const Eigen::VectorXcd backward = circle(64).conjugate();
  EXPECT_EQ(value_of(orbit_features(backward), "share of backward whirl"), 1);
}

TEST(DescribedMotionWaveformFeatures, PointToWhereAnOrbitReachesFarthest) {
  // A circle that is flattened on the +x side.
  Eigen::VectorXcd z = circle(64);
  for (std::complex<double>& w : z) w = {std::min(w.real(), 1.0), w.imag()};
  z.array() -= z.mean();
  EXPECT_NEAR(std::abs(lopsided_direction(z)), std::numbers::pi, 1e-9);
  EXPECT_NEAR(lopsided_direction(z * std::polar(1.0, 0.7)), 0.7 - std::numbers::pi, 1e-9);
}

TEST(DescribedMotionWaveformFeatures, OfOneProbeAreItsMoments) {
  const Eigen::VectorXd x = circle(64).real();
  const Features features = signal_features(x);
  EXPECT_NEAR(value_of(features, "kurtosis of signal"), 1.5, 1e-12);
  EXPECT_NEAR(value_of(features, "skewness of signal"), 0, 1e-12);
  EXPECT_NEAR(value_of(features, "largest signal"), std::sqrt(2.0), 0.02);
}

TEST(DescribedMotion, HasTheSameFeaturesHoweverItIsTurnedScaledAndMarked) {
  response::spectrum::SpectrumWorkspace workspace;
  const MotionLines lines = crooked_motion();
  const DescribedMotion one = describe(lines, {}, workspace);
  // Marks an eighth of a turn apart: the waveform has the same samples, but begins at another one.
  const DescribedMotion other = describe(seen_otherwise(lines, 3e-5, 1.1, 2 * pi * 9 / 8), {}, workspace);
  ASSERT_EQ(one.features.size(), other.features.size());
  for (std::size_t i = 0; i < one.features.size(); ++i) {
    EXPECT_EQ(one.features[i].name, other.features[i].name);
    EXPECT_NEAR(one.features[i].value, other.features[i].value, 1e-6) << one.features[i].name;
  }
  EXPECT_NEAR(other.size_m / one.size_m, 3e-5, 1e-12);
  EXPECT_NEAR(std::remainder(other.direction_rad - one.direction_rad - 1.1, 2 * pi), 0, 1e-6);
}

TEST(DescribedMotion, OfOneProbeHasTheSameFeaturesHoweverItIsScaledAndMarked) {
  response::spectrum::SpectrumWorkspace workspace;
  const MotionLines lines = crooked_motion();
  const DescribedMotion one = describe(one_reading(lines), {.plane = false}, workspace),
                        other = describe(one_reading(seen_otherwise(lines, 2, 0, 2 * pi * 5 / 8)),
                                         {.plane = false}, workspace);
  for (std::size_t i = 0; i < one.features.size(); ++i)
    EXPECT_NEAR(one.features[i].value, other.features[i].value, 1e-6) << one.features[i].name;
  EXPECT_EQ(one.direction_rad, 0);
}

TEST(DescribedMotion, TurnsItsDirectionsWithTheMotion) {
  response::spectrum::SpectrumWorkspace workspace;
  const View view{.directions = true};
  const MotionLines lines = crooked_motion();
  const DescribedMotion one = describe(lines, view, workspace),
                        turned = describe(seen_otherwise(lines, 1, pi / 2, 0), view, workspace);
  const double angle = std::atan2(value_of(one.features, "sine of lopsided direction"),
                                  value_of(one.features, "cosine of lopsided direction"));
  EXPECT_NEAR(angle, one.direction_rad, 1e-12);
  EXPECT_NEAR(value_of(turned.features, "sine of lopsided direction"),
              value_of(one.features, "cosine of lopsided direction"), 1e-9);
  // An ellipse rotated by 90 degrees is longest in the other direction.
  const char* longest = "cosine of twice the direction in which 1X is longest";
  EXPECT_NEAR(value_of(turned.features, longest), -value_of(one.features, longest), 1e-9);
  const double of_1x = std::arg(lines.at(12) * lines.at(-12));
  EXPECT_NEAR(value_of(one.features, longest), std::cos(of_1x), 1e-12);
}

TEST(DescribedMotion, HasTheMeanInUnitsOfItsSizeHoweverItIsTurned) {
  response::spectrum::SpectrumWorkspace workspace;
  const View view{.from_rest = true};
  MotionLines lines = crooked_motion();
  const DescribedMotion at_rest = describe(lines, view, workspace);
  EXPECT_EQ(value_of(at_rest.features, "mean position along lopsided direction"), 0);
  lines.at(0) = std::polar(0.4 * at_rest.size_m, at_rest.direction_rad + 0.3);
  for (const double turn : {0.0, 2.0}) {
    const DescribedMotion pushed = describe(seen_otherwise(lines, 3e-5, turn, 0), view, workspace);
    EXPECT_NEAR(value_of(pushed.features, "mean position along lopsided direction"), 0.4 * std::cos(0.3),
                1e-9);
    EXPECT_NEAR(value_of(pushed.features, "mean position across lopsided direction"), 0.4 * std::sin(0.3),
                1e-9);
  }
}

TEST(DescribedMotion, NamesItsFeaturesOnce) {
  response::spectrum::SpectrumWorkspace workspace;
  for (const bool plane : {true, false}) {
    std::set<std::string> names;
    const DescribedMotion motion =
        describe(plane ? crooked_motion() : one_reading(crooked_motion()),
                 {.plane = plane, .directions = true, .from_rest = true}, workspace);
    for (const Feature& feature : motion.features) {
      EXPECT_TRUE(std::isfinite(feature.value)) << feature.name;
      names.insert(feature.name);
    }
    EXPECT_EQ(names.size(), motion.features.size());
    EXPECT_EQ(values_of(motion.features).size(), static_cast<Eigen::Index>(motion.features.size()));
  }
}

/// Ratio by which the features shorten the arrow of line k.
double kept(const MotionLines& lines, int k) {
  const double length = std::abs(lines.at(k));
  return length / (length + 0.01 * size_of(lines));
}

TEST(DescribedMotion, ArePhasesOfLinesToEachOther) {
  const MotionLines lines = crooked_motion();
  const Features features = phase_features(lines, true);
  const double phase = 2 * std::arg(lines.at(24)) - std::arg(lines.at(12)) - std::arg(lines.at(36));
  const double length = kept(lines, 24) * kept(lines, 24) * kept(lines, 12) * kept(lines, 36);
  EXPECT_NEAR(value_of(features, "phase of 4/2, 4/2 to 2/2, 6/2, cosine"), length * std::cos(phase), 1e-12);
  EXPECT_NEAR(value_of(features, "phase of 4/2, 4/2 to 2/2, 6/2, sine"), length * std::sin(phase), 1e-12);
}

TEST(DescribedMotion, OfOneProbeArePhasesToMultiplesOfAnother) {
  const MotionLines lines = one_reading(crooked_motion());
  const Features features = phase_features(lines, false);
  const double phase = std::arg(lines.at(24)) - 2 * std::arg(lines.at(12));
  const double length = kept(lines, 24) * kept(lines, 12) * kept(lines, 12);
  EXPECT_NEAR(value_of(features, "phase of 4/2 to 2 times 2/2, cosine"), length * std::cos(phase), 1e-12);
  EXPECT_NEAR(value_of(features, "phase of 4/2 to 2 times 2/2, sine"), length * std::sin(phase), 1e-12);
}

TEST(DescribedMotion, AreNearTheMiddleWhereLinesAreWeak) {
  MotionLines lines{12, Eigen::VectorXcd::Zero(2 * 72 + 1)};
  lines.at(12) = 1;
  for (const Feature& feature : phase_features(lines, true)) EXPECT_EQ(feature.value, 0) << feature.name;
}

}  // namespace
}  // namespace rubsweep::diagnose::features
