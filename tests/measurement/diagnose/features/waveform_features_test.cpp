#include "rubsweep/measurement/diagnose/features/waveform_features.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "value_of.hpp"

namespace rubsweep::diagnose::features {
namespace {

Eigen::VectorXcd circle(int count) {
  Eigen::VectorXcd z(count);
  for (int k = 0; k < count; ++k) z(k) = std::polar(2.0, 2 * std::numbers::pi * k / count);
  return z;
}

TEST(WaveformFeatures, OfACircleAreThoseOfASine) {
  const Features features = orbit_features(circle(64));
  EXPECT_NEAR(value_of(features, "ovality"), 0, 1e-12);
  EXPECT_NEAR(value_of(features, "lopsidedness"), 0, 1e-12);
  EXPECT_NEAR(value_of(features, "kurtosis of extent along"), 1.5, 1e-12);
  EXPECT_NEAR(value_of(features, "radius of 50 %"), 1, 1e-12);
  EXPECT_EQ(value_of(features, "share of backward whirl"), 0);
}

TEST(WaveformFeatures, KnowBackwardWhirlFromForward) {
  const Eigen::VectorXcd backward = circle(64).conjugate();
  EXPECT_EQ(value_of(orbit_features(backward), "share of backward whirl"), 1);
}

TEST(WaveformFeatures, PointToWhereAnOrbitReachesFarthest) {
  // A circle that is flattened on the side towards +x.
  Eigen::VectorXcd z = circle(64);
  for (std::complex<double>& w : z) w = {std::min(w.real(), 1.0), w.imag()};
  z.array() -= z.mean();
  EXPECT_NEAR(std::abs(lopsided_direction(z)), std::numbers::pi, 1e-9);
  EXPECT_NEAR(lopsided_direction(z * std::polar(1.0, 0.7)), 0.7 - std::numbers::pi, 1e-9);
}

TEST(WaveformFeatures, OfOneProbeAreItsMoments) {
  const Eigen::VectorXd x = circle(64).real();
  const Features features = signal_features(x);
  EXPECT_NEAR(value_of(features, "kurtosis of signal"), 1.5, 1e-12);
  EXPECT_NEAR(value_of(features, "skewness of signal"), 0, 1e-12);
  EXPECT_NEAR(value_of(features, "largest signal"), std::sqrt(2.0), 0.02);
}

}  // namespace
}  // namespace rubsweep::diagnose::features
