#include "rubsweep/core/response/rotating/cycle_measures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <functional>
#include <vector>

#include "rubsweep/core/numerics/full_turn.hpp"
#include "support/simple_scenes.hpp"

namespace rubsweep::response::rotating {
namespace {

using Complex = std::complex<double>;
constexpr double length_m = 1e-3;

struct Amplitude {
  int k = 0;
  Complex value;
};

/// One period of a motion with lines of order 1 + k spacing; lengths in clearances.
RotatingArc arc_of(double spacing, const std::vector<Amplitude>& lines) {
  const auto state = [&](double phase, double seen_from) {
    Complex z = 0, v = 0;
    for (const Amplitude& line : lines) {
      const double order = 1 + line.k * spacing;
      const Complex part = line.value * std::polar(1.0, order * phase - seen_from);
      z += part;
      v += Complex(0, order) * part;
    }
    return Eigen::Vector4d(z.real(), z.imag(), v.real(), v.imag());
  };
  RotatingArc arc;
  arc.angle_rad = numerics::full_turn / spacing;
  arc.end = state(arc.angle_rad, arc.angle_rad);
  const int samples = motion::ResponseOptions{}.samples_per_revolution;
  for (int k = 0; numerics::full_turn * k / samples < arc.angle_rad; ++k) {
    arc.samples.conservativeResize(4, k + 1);
    arc.samples.col(k) = state(numerics::full_turn * k / samples, 0);
  }
  return arc;
}

motion::Measures measure(const RotatingArc& arc) {
  motion::Workspace workspace;
  return measure_cycle(test::one_mass_scene(1, 1, 0, 1, length_m), arc, {}, workspace);
}

TEST(CycleMeasuresMeasure, ReadsTheLinesOfAComb) {
  const double spacing = 0.408547;
  const motion::Measures m = measure(arc_of(spacing, {{0, {0.5, 0.3}}, {-1, 0.9}, {-3, {0, 0.2}}, {1, 0.1}}));
  EXPECT_NEAR(m.comb_spacing.value(), spacing, 1e-12);
  EXPECT_NEAR(m.dominant.value().order, 1 - spacing, 1e-12);
  EXPECT_NEAR(m.dominant->amplitude_m, 0.9 * length_m, 1e-9);
  EXPECT_NEAR(m.amplitude_1x_forward_m, std::abs(Complex(0.5, 0.3)) * length_m, 1e-9);
  EXPECT_EQ(m.amplitude_1x_backward_m, 0);
  EXPECT_EQ(m.orbit, spectrum::OrbitKind::oval);
  EXPECT_EQ(m.whirl, spectrum::WhirlKind::forward);
}

TEST(CycleMeasuresMeasure, NamesBackwardAndMixedWhirlAndCircles) {
  const motion::Measures backward = measure(arc_of(1.83, {{-1, 0.9}, {0, 0.2}}));
  EXPECT_EQ(backward.whirl, spectrum::WhirlKind::backward);
  EXPECT_NEAR(backward.dominant.value().order, -0.83, 1e-12);
  EXPECT_EQ(measure(arc_of(1.83, {{-1, 0.9}, {0, 0.8}})).whirl, spectrum::WhirlKind::mixed);
  EXPECT_EQ(measure(arc_of(0.7, {{0, 1}, {1, 0.02}})).orbit, spectrum::OrbitKind::circle);
  EXPECT_EQ(measure(arc_of(0.7, {{0, 1}, {1, 0.03}})).orbit, spectrum::OrbitKind::oval);
}

TEST(CycleMeasuresMeasure, LinesThatAWindowCannotTellFromZeroOrMinusOneCountAsThese) {
  // Orders: 1 - 2 spacing = -0.999, 1 - spacing = 0.0005.
  const motion::Measures m = measure(arc_of(0.9995, {{-1, 5}, {-2, 0.25}, {0, 1}}));
  EXPECT_NEAR(m.amplitude_1x_backward_m, 0.25 * length_m, 1e-8);
  EXPECT_EQ(m.dominant.value().order, 1);
  EXPECT_EQ(m.whirl, spectrum::WhirlKind::forward);
}

TEST(CycleMeasuresMeasure, HitsAreThoseOfAWindow) {
  auto arc = arc_of(0.4, {{0, 1}, {-1, 0.5}});
  arc.hits = 3;
  arc.contact_fraction = 0.7;
  arc.peak_displacement_m = 1.4e-3;
  arc.peak_contact_force_n = 12;
  arc.peak_casing_displacement_m = 2e-4;
  const motion::Measures m = measure(arc);
  EXPECT_EQ(m.turns, 64);
  EXPECT_EQ(m.contact.hits, 77);  // 3 impacts in 2.5 turns: 76.8 in 64 turns
  EXPECT_EQ(m.contact.contact_fraction, 0.7);
  EXPECT_EQ(m.contact.peak_displacement_m, 1.4e-3);
  EXPECT_EQ(m.contact.peak_contact_force_n, 12);
  EXPECT_EQ(m.contact.peak_casing_displacement_m, 2e-4);
}

}  // namespace
}  // namespace rubsweep::response::rotating
