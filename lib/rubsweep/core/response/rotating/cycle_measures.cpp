#include "rubsweep/core/response/rotating/cycle_measures.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <vector>

#include "rubsweep/core/numerics/full_turn.hpp"
#include "rubsweep/core/response/motion/classify.hpp"
#include "rubsweep/core/response/spectrum/full_spectrum.hpp"
#include "rubsweep/core/response/spectrum/orbit_shape.hpp"

namespace rubsweep::response::rotating {
namespace {

using Complex = std::complex<double>;

/// w = z e^{-i phase} and its rate at one phase, in metres.
struct Knot {
  double phase_rad = 0;
  Complex w, rate;
};

std::vector<Knot> knots_of(const scene::Scene& scene, const RotatingArc& once, int samples_per_revolution) {
  const auto& map = scene::observed(scene);
  const Eigen::Index n = map.cols();
  const auto knot = [&](double phase, const Eigen::VectorXd& state, double turn_back_rad) {
    const Eigen::Vector2d z = scene.length_scale_m * (map * state.head(n)),
                          v = scene.length_scale_m * (map * state.tail(n));
    const Complex back = std::polar(1.0, -turn_back_rad), place(z.x(), z.y()), velocity(v.x(), v.y());
    return Knot{phase, place * back, (velocity - Complex(0, 1) * place) * back};
  };
  std::vector<Knot> knots;
  for (Eigen::Index k = 0; k < once.samples.cols(); ++k) {
    const double phase = numerics::full_turn * static_cast<double>(k) / samples_per_revolution;
    knots.push_back(knot(phase, once.samples.col(k), phase));
  }
  knots.push_back(knot(once.angle_rad, once.end, 0));
  return knots;
}

/// Cubic through values and rates of both ends.
Complex between(const Knot& a, const Knot& b, double phase_rad) {
  const double h = b.phase_rad - a.phase_rad, x = h > 0 ? (phase_rad - a.phase_rad) / h : 0, y = 1 - x;
  return y * y * ((1 + 2 * x) * a.w + x * h * a.rate) + x * x * ((1 + 2 * y) * b.w - y * h * b.rate);
}

/// Equidistant samples of w over the period, without the end point. Their number is a power of two shared by
/// many cells, because planning a transform of a new length takes longer than the transform. Twice as many
/// samples change no line of figure 11 by 1e-10 of the clearance.
std::vector<Complex> one_period(const std::vector<Knot>& knots) {
  const double period = knots.back().phase_rad;
  const std::size_t count = std::bit_ceil(knots.size());
  std::vector<Complex> w;
  std::size_t k = 0;
  for (std::size_t j = 0; j < count; ++j) {
    const double phase = period * static_cast<double>(j) / static_cast<double>(count);
    while (k + 2 < knots.size() && knots[k + 1].phase_rad <= phase) ++k;
    w.push_back(between(knots[k], knots[k + 1], phase));
  }
  return w;
}

void measure_lines(const spectrum::FullSpectrum& spectrum, double spacing, double half_bin,
                   motion::Measures& measures) {
  double forward = 0, backward = 0;
  spectrum::SpectralLine dominant;
  for (int k = spectrum.first_line(); k <= spectrum.last_line(); ++k) {
    const double order = 1 + k * spacing, amplitude_m = spectrum.amplitude(k);
    for (const motion::MeasuredLine& line : motion::measured_lines) {
      double& measured_m = measures.*line.amplitude_m;
      if (std::abs(order - line.order) < half_bin) measured_m = std::max(measured_m, amplitude_m);
    }
    if (std::abs(order) < half_bin) continue;
    (order > 0 ? forward : backward) += amplitude_m * amplitude_m;
    if (amplitude_m > dominant.amplitude_m) dominant = {.order = order, .amplitude_m = amplitude_m};
  }
  measures.dominant = dominant;
  measures.whirl = spectrum::whirl_kind(forward, backward);
}

}  // namespace

motion::Measures measure_cycle(const scene::Scene& scene, const RotatingArc& once,
                               const motion::ResponseOptions& options, motion::Workspace& workspace) {
  const double turns = once.angle_rad / numerics::full_turn, spacing = 1 / turns;
  const auto w = one_period(knots_of(scene, once, options.samples_per_revolution));
  motion::Measures measures;
  measures.turns = options.window_revolutions;
  measures.contact = {.hits = static_cast<int>(std::lround(once.hits * options.window_revolutions / turns)),
                      .contact_fraction = std::min(1.0, once.contact_fraction),
                      .peak_displacement_m = once.peak_displacement_m,
                      .peak_contact_force_n = once.peak_contact_force_n,
                      .peak_casing_displacement_m = once.peak_casing_displacement_m};
  // The mean of such a motion is at the centre.
  measures.orbit = spectrum::is_circle(w, 0) ? spectrum::OrbitKind::circle : spectrum::OrbitKind::oval;
  measures.comb_spacing = spacing;
  measure_lines(spectrum::full_spectrum(w, 1, workspace.spectrum), spacing, 0.5 / options.window_revolutions,
                measures);
  return measures;
}

}  // namespace rubsweep::response::rotating
