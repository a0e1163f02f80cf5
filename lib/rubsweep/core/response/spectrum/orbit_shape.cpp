#include "rubsweep/core/response/spectrum/orbit_shape.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace rubsweep::response::spectrum {
namespace {

double squared(double value) { return value * value; }

std::complex<double> mean(std::span<const std::complex<double>> values) {
  return std::accumulate(values.begin(), values.end(), std::complex<double>{}) /
         static_cast<double>(values.size());
}

bool is_oval(const FullSpectrum& spectrum) {
  const int k = dominant_line(spectrum);
  if (k == 0 || -k < spectrum.first_line() || -k > spectrum.last_line()) return false;
  const double partner = spectrum.amplitude(-k);
  for (int other = spectrum.first_line(); other <= spectrum.last_line(); ++other) {
    if (other != 0 && other != k && other != -k && spectrum.amplitude(other) >= partner) return false;
  }
  const double held = squared(spectrum.amplitude(k)) + squared(partner);
  return held >= oval_energy_share * spectrum.energy_without_mean();
}

}  // namespace

bool is_circle(std::span<const std::complex<double>> displacement_m, std::complex<double> centre_m) {
  double nearest = std::numeric_limits<double>::infinity();
  double farthest = 0;
  for (const auto& z : displacement_m) {
    const double square = std::norm(z - centre_m);
    nearest = std::min(nearest, square);
    farthest = std::max(farthest, square);
  }
  return !displacement_m.empty() && farthest < circle_ratio * circle_ratio * nearest;
}

OrbitKind orbit_kind(std::span<const std::complex<double>> displacement_m, const FullSpectrum& spectrum) {
  if (is_circle(displacement_m, mean(displacement_m))) return OrbitKind::circle;
  return is_oval(spectrum) ? OrbitKind::oval : OrbitKind::complex;
}

WhirlKind whirl_kind(double forward, double backward) {
  const double share = whirl_energy_share * (forward + backward);
  if (forward >= share && forward > 0) return WhirlKind::forward;
  if (backward >= share && backward > 0) return WhirlKind::backward;
  return WhirlKind::mixed;
}

WhirlKind whirl_kind(const FullSpectrum& spectrum) {
  double forward = 0;
  double backward = 0;
  for (int k = spectrum.first_line(); k <= spectrum.last_line(); ++k) {
    if (k > 0) forward += squared(spectrum.amplitude(k));
    if (k < 0) backward += squared(spectrum.amplitude(k));
  }
  return whirl_kind(forward, backward);
}

}  // namespace rubsweep::response::spectrum
