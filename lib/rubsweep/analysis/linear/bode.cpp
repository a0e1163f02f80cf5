#include "rubsweep/analysis/linear/bode.hpp"

#include <Eigen/Core>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace rubsweep::linear {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

constexpr std::size_t fewest_samples = 8;

/// Phasor A of the least-squares fit offset + Re(A e^{i angle}).
Complex fit_phasor(std::span<const double> x, std::span<const double> angle) {
  const auto n = static_cast<Eigen::Index>(x.size());
  Eigen::MatrixX3d base(n, 3);
  for (Eigen::Index k = 0; k < n; ++k) {
    const double phi = angle[static_cast<std::size_t>(k)];
    base.row(k) << std::cos(phi), -std::sin(phi), 1;
  }
  const Eigen::Vector3d fit =
      base.colPivHouseholderQr().solve(Eigen::Map<const Eigen::VectorXd>(x.data(), n));
  return {fit(0), fit(1)};
}

double lag_deg(Complex phasor, double sensor_angle_deg) {
  double phase = std::arg(phasor) * 180 / pi + sensor_angle_deg;
  phase -= 360 * std::ceil(phase / 360 - 1e-12);
  // With noise, a lag of zero shall read about 0, not about -360.
  return phase <= -350 ? phase + 360 : phase;
}

/// Middle of a window, and the noise that remains in it.
struct Window {
  std::size_t middle = 0;
  Complex noise_m;
};

std::vector<Window> windows_of(const OneXSignal& signal, int revolutions) {
  const std::span<const double> angle = signal.shaft_angle_rad;
  const auto reaching = [&](double target_rad) {
    return static_cast<std::size_t>(std::ranges::lower_bound(angle, target_rad) - angle.begin());
  };
  std::vector<Window> windows;
  for (long turn = 0;; ++turn) {
    const double begin_rad = angle.empty() ? 0 : angle.front() + 2 * pi * static_cast<double>(turn);
    const std::size_t begin = reaching(begin_rad), end = reaching(begin_rad + 2 * pi * revolutions);
    if (end >= angle.size()) break;  // no whole window remains
    if (end - begin < fewest_samples) continue;
    Window window{reaching(begin_rad + pi * revolutions), 0};
    if (!windows.empty() && windows.back().middle == window.middle) continue;
    if (!signal.noise_m.empty())
      window.noise_m =
          fit_phasor(signal.noise_m.subspan(begin, end - begin), angle.subspan(begin, end - begin));
    windows.push_back(window);
  }
  return windows;
}

/// Finds the largest amplitude between the neighbours of a window, by a parabola through the samples.
void find_top(const OneXSignal& signal, const Window& before, const Window& at, const Window& after,
              OneX& one) {
  const auto amplitude = [&](std::size_t k) { return std::abs(signal.phasor_m[k] + at.noise_m); };
  std::size_t top = at.middle;
  for (std::size_t k = before.middle; k <= after.middle; ++k) {
    if (amplitude(k) > amplitude(top)) top = k;
  }
  top = std::clamp<std::size_t>(top, before.middle + 1, after.middle - 1);
  const double a = amplitude(top - 1), b = amplitude(top), c = amplitude(top + 1), bend = a - 2 * b + c;
  const double shift = bend < 0 ? std::clamp((a - c) / (2 * bend), -1.0, 1.0) : 0;
  one.largest_amplitude_m = b - (a - c) * shift / 4;
  // From sample to sample the speed changes at a constant rate.
  one.speed_of_largest_hz = signal.speed_hz[top] + shift * (signal.speed_hz[top + 1] - signal.speed_hz[top]);
}

}  // namespace

OneX one_x(const OneXSignal& signal, int revolutions) {
  const std::vector<Window> windows = windows_of(signal, revolutions);
  OneX one;
  std::size_t top = 0;
  for (const Window& window : windows) {
    const Complex phasor = signal.phasor_m[window.middle] + window.noise_m;
    one.plot.push_back(
        {signal.speed_hz[window.middle], std::abs(phasor), lag_deg(phasor, signal.sensor_angle_deg)});
    if (one.plot.back().amplitude_m > one.plot[top].amplitude_m) top = one.plot.size() - 1;
  }
  if (one.plot.empty()) return one;
  one.largest_amplitude_m = one.plot[top].amplitude_m;
  const bool inside = top > 0 && top + 1 < windows.size();
  if (inside) find_top(signal, windows[top - 1], windows[top], windows[top + 1], one);
  return one;
}

}  // namespace rubsweep::linear
