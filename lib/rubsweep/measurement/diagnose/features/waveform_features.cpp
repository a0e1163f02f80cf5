#include "rubsweep/measurement/diagnose/features/waveform_features.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

namespace rubsweep::diagnose::features {
namespace {

using Complex = std::complex<double>;
using Eigen::ArrayXd;

/// Extent and moments of numbers in units of their root mean square.
void add_moments(const std::string& name, const ArrayXd& x, Features& features) {
  const double size = std::max(std::sqrt(x.square().mean()), 1e-300);
  const ArrayXd unit = x / size;
  add(features, "skewness of " + name, unit.cube().mean());
  add(features, "kurtosis of " + name, unit.square().square().mean());
  std::vector<double> sorted(unit.begin(), unit.end());
  std::ranges::sort(sorted);
  const auto quantile = [&](double share) {
    return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
  };
  add(features, "least " + name, quantile(0.01));
  add(features, "largest " + name, quantile(0.99));
}

/// The samples one step later and one step earlier; whole turns begin again where they end.
template <class Array>
Array after(const Array& x) {
  Array shifted(x.size());
  shifted << x.tail(x.size() - 1), x(0);
  return shifted;
}
template <class Array>
Array before(const Array& x) {
  Array shifted(x.size());
  shifted << x(x.size() - 1), x.head(x.size() - 1);
  return shifted;
}

/// Sharpest bend of a signal beside its usual one: what a contact leaves of its force.
void add_bends(const std::string& name, const ArrayXd& x, Features& features) {
  const ArrayXd bend = after(x) - 2 * x + before(x);
  const double size = std::max(std::sqrt(bend.square().mean()), 1e-300);
  add(features, "kurtosis of acceleration " + name, (bend / size).square().square().mean());
  add(features, "skewness of acceleration " + name, (bend / size).cube().mean());
}

}  // namespace

double lopsided_direction(const Eigen::VectorXcd& waveform) {
  return std::arg((waveform.array().abs2() * waveform.array()).mean());
}

Features orbit_features(const Eigen::VectorXcd& waveform) {
  Features features;
  const auto z = waveform.array();
  const double size = std::max(std::sqrt(z.abs2().mean()), 1e-300);
  const Complex oval = z.square().mean() / (size * size),
                lopsided = (z.abs2() * z).mean() / std::pow(size, 3),
                corners = z.cube().mean() / std::pow(size, 3);
  add(features, "ovality", std::abs(oval));
  add(features, "lopsidedness", std::abs(lopsided));
  add(features, "three corners", std::abs(corners));
  const Complex direction = std::polar(1.0, std::arg(lopsided));
  add(features, "ovality along the lopsided direction", std::real(oval / (direction * direction)));
  add(features, "ovality across the lopsided direction", std::imag(oval / (direction * direction)));
  add(features, "corners along the lopsided direction", std::real(corners / std::pow(direction, 3)));
  const Eigen::ArrayXcd turned = z / direction;
  add_moments("extent along", turned.real(), features);
  add_moments("extent across", turned.imag(), features);
  add_bends("along", turned.real(), features);
  add_bends("across", turned.imag(), features);
  std::vector<double> radii;
  for (const Complex w : turned) radii.push_back(std::abs(w) / size);
  std::ranges::sort(radii);
  const auto radius = [&](double share) {
    return radii[static_cast<std::size_t>(share * static_cast<double>(radii.size() - 1))];
  };
  for (const double share : {0.01, 0.25, 0.5, 0.75, 0.99})
    add(features, "radius of " + std::to_string(static_cast<int>(100 * share)) + " %", radius(share));
  const ArrayXd swept = (turned.conjugate() * after(turned)).imag() / (size * size);
  add(features, "mean whirl", swept.mean());
  add(features, "share of backward whirl", (swept < 0).cast<double>().mean());
  return features;
}

Features signal_features(const Eigen::VectorXd& waveform) {
  Features features;
  add_moments("signal", waveform.array(), features);
  add_bends("of the signal", waveform.array(), features);
  return features;
}

}  // namespace rubsweep::diagnose::features
