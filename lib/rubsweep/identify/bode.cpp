#include "rubsweep/identify/bode.hpp"

#include <Eigen/Core>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace rubsweep::identify {
namespace {

using std::numbers::pi;

BodePoint fit_window(std::span<const double> x, std::span<const double> angle, std::span<const double> speed,
                     double sensor_angle_deg) {
  const auto n = static_cast<Eigen::Index>(x.size());
  Eigen::MatrixX3d base(n, 3);
  for (Eigen::Index k = 0; k < n; ++k) {
    const double phi = angle[static_cast<std::size_t>(k)];
    base.row(k) << std::cos(phi), -std::sin(phi), 1;
  }
  const Eigen::Vector3d fit =
      base.colPivHouseholderQr().solve(Eigen::Map<const Eigen::VectorXd>(x.data(), n));
  double sum = 0;
  for (const double value : speed) sum += value;
  double phase = std::atan2(fit(1), fit(0)) * 180 / pi + sensor_angle_deg;
  phase -= 360 * std::ceil(phase / 360 - 1e-12);
  // Zero lag with its noise reads about 0, not about -360.
  if (phase <= -350) phase += 360;
  return {sum / static_cast<double>(x.size()), std::hypot(fit(0), fit(1)), phase};
}

}  // namespace

std::vector<BodePoint> bode_plot(std::span<const double> displacement_m,
                                 std::span<const double> shaft_angle_rad, std::span<const double> speed_hz,
                                 double sensor_angle_deg, int revolutions) {
  constexpr std::size_t fewest = 8;
  std::vector<BodePoint> plot;
  const double window = 2 * pi * revolutions;
  for (std::size_t begin = 0; begin < displacement_m.size();) {
    const double end_angle = shaft_angle_rad[begin] + window;
    std::size_t end = begin;
    while (end < displacement_m.size() && shaft_angle_rad[end] < end_angle) ++end;
    if (end == displacement_m.size()) break;  // no whole window is left
    const std::size_t count = end - begin;
    if (count >= fewest) {
      plot.push_back(fit_window(displacement_m.subspan(begin, count), shaft_angle_rad.subspan(begin, count),
                                speed_hz.subspan(begin, count), sensor_angle_deg));
    }
    begin = end;
  }
  return plot;
}

std::optional<double> critical_speed_hz(const std::vector<BodePoint>& plot) {
  if (plot.empty()) return std::nullopt;
  const auto top = std::max_element(plot.begin(), plot.end(), [](const BodePoint& a, const BodePoint& b) {
    return a.amplitude_m < b.amplitude_m;
  });
  if (top == plot.begin() || top + 1 == plot.end()) return std::nullopt;
  const auto &a = *(top - 1), &b = *top, &c = *(top + 1);
  const double left = (b.amplitude_m - a.amplitude_m) / (b.speed_hz - a.speed_hz);
  const double right = (c.amplitude_m - b.amplitude_m) / (c.speed_hz - b.speed_hz);
  const double bend = (right - left) / (c.speed_hz - a.speed_hz);
  if (bend >= 0) return b.speed_hz;
  // Newton's form: slope at b is left + bend (b - a).
  return b.speed_hz - (left + bend * (b.speed_hz - a.speed_hz)) / (2 * bend);
}

}  // namespace rubsweep::identify
