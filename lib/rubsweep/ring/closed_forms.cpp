#include "rubsweep/ring/closed_forms.hpp"

#include <algorithm>
#include <boost/math/special_functions/cos_pi.hpp>
#include <boost/math/special_functions/sin_pi.hpp>
#include <boost/math/tools/quartic_roots.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>

#include "rubsweep/ring/square.hpp"

namespace rubsweep::ring {
namespace {

double soft_mass(const Load& load) { return load.flexural_mass_kg - load.rotary_mass_kg; }

/// Real roots of a x^2 + b x + c, none when they are complex.
std::vector<double> quadratic(double a, double b, double c) {
  if (a == 0 ? b == 0 : b * b < 4 * a * c) return {};
  if (a == 0) return {-c / b};
  const auto [first, second] = boost::math::tools::quadratic_roots(a, b, c);
  return {first, second};
}

/// Positive speeds, ascending, from values of their square.
std::vector<double> speeds_of_squares(const std::vector<double>& squares) {
  std::vector<double> speeds;
  for (const double value : squares) {
    if (value > 0) speeds.push_back(std::sqrt(value));
  }
  std::sort(speeds.begin(), speeds.end());
  return speeds;
}

}  // namespace

std::vector<double> radial_divergence_speeds(const System& system) {
  const Load& load = system.loads.front();
  const double n = system.ring.nodal_diameters, count = static_cast<double>(system.loads.size());
  double sum_ss = 0, sum_cc = 0, sum_sc = 0;
  for (const Load& one : system.loads) {
    const double c = boost::math::cos_pi(n * one.angle_deg / 180),
                 s = boost::math::sin_pi(n * one.angle_deg / 180);
    sum_ss += s * s;
    sum_cc += c * c;
    sum_sc -= s * c;
  }
  const double friction = system.friction_coefficient * surface_ratio(system.ring) / n;
  const double product = std::max(0.0, sum_ss * sum_cc - square(sum_sc));  // l1 l2 = det S
  const double a = amplitude_mass_kg(system.ring), own = a * square(critical_speed(system.ring));
  std::vector<double> squares;
  for (const double l : quadratic(1, -count, (1 + square(friction)) * product)) {
    squares.push_back((own + l * load.radial_stiffness_n_per_m) / (a + l * load.radial_mass_kg));
  }
  return speeds_of_squares(squares);
}

std::optional<std::pair<double, double>> radial_stability_window(const Ring& ring, const Load& load) {
  const double n2 = square(ring.nodal_diameters), critical = critical_speed(ring);
  const double radial2 = load.radial_stiffness_n_per_m / load.radial_mass_kg;
  const double under_root = (n2 + 1) * radial2 - n2 * square(critical);
  if (!(load.radial_mass_kg > 0) || under_root < 0) return std::nullopt;
  const double root = std::sqrt(under_root), middle = n2 * critical;
  return std::pair(std::abs(root - middle) / (n2 + 1), (root + middle) / (n2 + 1));
}

double tangential_divergence_speed(const Load& load) {
  return std::sqrt(load.tangential_stiffness_n_per_m / soft_mass(load));
}

double aperiodic_speed(const Load& load, double friction_coefficient) {
  const double damping = friction_coefficient * load.gyroscopic_mass_kg;
  return std::sqrt(load.tangential_stiffness_n_per_m /
                   (soft_mass(load) + square(damping) / load.flexural_mass_kg));
}

std::vector<NeutralSpeed> neutral_speeds(const Ring& ring, const Load& load) {
  const double n2 = square(ring.nodal_diameters), critical = critical_speed(ring);
  // With the frequency n (Omega_c + x), x positive for the backward and negative for the forward mode: (k_r -
  // m_r (f2 + x^2)) (k_t - m_t f2 - m_s x^2) = 4 g^2 x^2 f2, f2 = n^2 (Omega_c + x)^2. Lengths in units of
  // Omega_c.
  const double unit2 = square(critical);
  const double mr = load.radial_mass_kg * unit2, mt = load.flexural_mass_kg * unit2,
               ms = soft_mass(load) * unit2;
  const double kr = load.radial_stiffness_n_per_m, kt = load.tangential_stiffness_n_per_m;
  // Coefficients of 1, x, x^2.
  const double u0 = kr - mr * n2, u1 = -2 * mr * n2, u2 = -mr * (n2 + 1);
  const double v0 = kt - mt * n2, v1 = -2 * mt * n2, v2 = -(mt * n2 + ms);
  const double g = 4 * square(load.gyroscopic_mass_kg) * unit2 * unit2 * n2;
  std::vector<double> roots;
  if (load.motion == Motion::radial) {
    roots = quadratic(u2, u1, u0);
  } else {
    for (const double root :
         boost::math::tools::quartic_roots(u2 * v2 - g, u2 * v1 + u1 * v2 - 2 * g,
                                           u2 * v0 + u1 * v1 + u0 * v2 - g, u1 * v0 + u0 * v1, u0 * v0)) {
      if (std::isfinite(root)) roots.push_back(root);
    }
  }
  std::vector<NeutralSpeed> speeds;
  const double n = ring.nodal_diameters;
  for (const double x : roots) {
    if (x != 0) speeds.push_back({std::abs(x) * critical, n * critical * std::abs(1 + x), x < 0});
  }
  std::sort(speeds.begin(), speeds.end(), [](const NeutralSpeed& a, const NeutralSpeed& b) {
    return a.speed_rad_per_s < b.speed_rad_per_s;
  });
  return speeds;
}

std::vector<double> inclined_divergence_speeds(const Ring& ring, const Load& load,
                                               double friction_coefficient) {
  const double c = boost::math::cos_pi(load.inclination_deg / 180);
  const double s = boost::math::sin_pi(load.inclination_deg / 180);
  const double along = s * (s - friction_coefficient * c), across = c * (c + friction_coefficient * s);
  const double a = amplitude_mass_kg(ring), critical2 = square(critical_speed(ring));
  const double kr = load.radial_stiffness_n_per_m, kt = load.tangential_stiffness_n_per_m;
  const double mr = load.radial_mass_kg, ms = soft_mass(load);
  const double k = kr * along + kt * across, m = mr * along + ms * across;
  std::vector<double> squares = quadratic(a * m + mr * ms, -(a * k + a * critical2 * m + kr * ms + kt * mr),
                                          a * critical2 * k + kr * kt);
  squares.push_back(critical2);
  return speeds_of_squares(squares);
}

}  // namespace rubsweep::ring
