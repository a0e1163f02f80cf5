#include "rubsweep/ring/closed_forms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/special_functions/cos_pi.hpp>
#include <boost/math/special_functions/sin_pi.hpp>
#include <boost/math/tools/quartic_roots.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/numerics/dense/eigenvalues.hpp"
#include "rubsweep/core/numerics/dense/factors.hpp"

namespace rubsweep::ring {
namespace {

bool all_alike(const std::vector<Load>& loads) {
  return std::ranges::all_of(loads, [&](Load load) {
    load.angle_deg = loads.front().angle_deg;
    return load == loads.front();
  });
}

std::optional<double> nearest(const std::vector<double>& speeds, double wanted) {
  std::optional<double> best;
  for (const double speed : speeds) {
    if (std::abs(speed - wanted) > 1e-6 * wanted) continue;
    if (!best || std::abs(speed - wanted) < std::abs(*best - wanted)) best = speed;
  }
  return best;
}

struct Found {
  std::vector<double> divergence, flutter, mergers;
};

Found found_numerically(const System& system, const std::vector<Change>& changes) {
  Found found{divergence_speeds(normal_form(system)), {}, {}};
  for (const Change& change : changes) {
    if (change.before.growing_pairs != change.after.growing_pairs)
      found.flutter.push_back(change.speed_rad_per_s);
    if (change.before.decaying_real != change.after.decaying_real)
      found.mergers.push_back(change.speed_rad_per_s);
  }
  return found;
}

double soft_mass(const Load& load) { return load.flexural_mass_kg - load.rotary_mass_kg; }

/// Real roots of a x^2 + b x + c; empty where they are complex.
std::vector<double> quadratic(double a, double b, double c) {
  if (a == 0 ? b == 0 : b * b < 4 * a * c) return {};
  if (a == 0) return {-c / b};
  const auto [first, second] = boost::math::tools::quadratic_roots(a, b, c);
  return {first, second};
}

/// Positive speeds, ascending, whose squares are `squares`.
std::vector<double> speeds_of_squares(const std::vector<double>& squares) {
  std::vector<double> speeds;
  for (const double value : squares) {
    if (value > 0) speeds.push_back(std::sqrt(value));
  }
  std::sort(speeds.begin(), speeds.end());
  return speeds;
}

}  // namespace

std::vector<CriticalSpeed> critical_speeds(const System& system, const std::vector<Change>& changes) {
  const Found found = found_numerically(system, changes);
  std::vector<CriticalSpeed> speeds;
  const auto add = [&](std::string name, double closed_form, const std::vector<double>& numeric) {
    speeds.push_back({std::move(name), closed_form, nearest(numeric, closed_form)});
  };
  const double critical = critical_speed(system.ring);
  const std::vector<Load>& loads = system.loads;
  add("omega_c", critical, found.divergence);
  if (loads.empty() || !all_alike(loads)) return speeds;
  const Load& load = loads.front();
  const bool alone = loads.size() == 1, upright = load.inclination_deg == 0;
  const bool has_friction = system.friction_coefficient != 0;
  if (load.motion != Motion::tangential && upright) {
    int count = 0;
    for (const double speed : radial_divergence_speeds(system)) {
      if (alone && std::abs(speed - critical) <= 1e-12 * critical) continue;
      add(alone ? "omega_c2" : fmt::format("ring_divergence_{}", ++count), speed, found.divergence);
    }
  }
  if (load.motion == Motion::radial && alone && has_friction) {
    if (const auto window = radial_stability_window(system.ring, load)) {
      add("omega_cs1", window->first, found.flutter);
      add("omega_cs2", window->second, found.flutter);
    }
  }
  if (load.motion != Motion::radial && upright) {
    add("omega_t", tangential_divergence_speed(load), found.divergence);
  }
  if (load.motion == Motion::tangential && has_friction) {
    add("aperiodic", aperiodic_speed(load, system.friction_coefficient), found.mergers);
  }
  if (load.motion == Motion::both && !upright && alone) {
    int count = 0;
    for (const double speed : inclined_divergence_speeds(system.ring, load, system.friction_coefficient)) {
      if (speed != critical) add(fmt::format("inclined_divergence_{}", ++count), speed, found.divergence);
    }
  }
  if (load.motion == Motion::both && has_friction) {
    int forward = 0, backward = 0;
    for (const NeutralSpeed& neutral : neutral_speeds(system.ring, load)) {
      int& count = neutral.forward ? forward : backward;
      add(fmt::format("neutral_{}_{}", neutral.forward ? "forward" : "backward", ++count),
          neutral.speed_rad_per_s, found.flutter);
    }
  }
  return speeds;
}

std::vector<double> divergence_speeds(const NormalForm& form) {
  // Solved for 1 / O^2 instead of O^2, because K2 may be singular (loads without mass), while K0 contains
  // every spring.
  const Eigen::MatrixXd inverse = numerics::dense::solve_full_pivot(form.stiffness, form.softening);
  const Eigen::VectorXcd roots = numerics::dense::eigenvalues(inverse);
  if (roots.hasNaN()) throw SolverError("divergence: the eigenvalue iteration did not converge");
  const double largest = roots.cwiseAbs().maxCoeff();
  std::vector<double> speeds;
  for (const std::complex<double>& root : roots) {
    // For identical loads, two equal roots may be computed as a pair that lies this close to the real axis.
    if (std::abs(root.imag()) > 1e-9 * largest || !(root.real() > 1e-14 * largest)) continue;
    speeds.push_back(form.reference_rad_per_s / std::sqrt(root.real()));
  }
  std::sort(speeds.begin(), speeds.end());
  return speeds;
}

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
  std::ranges::sort(speeds, {}, &NeutralSpeed::speed_rad_per_s);
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
