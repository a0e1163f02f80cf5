#include "rubsweep/ring/ring_critical_speeds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/numerics/dense/eigenvalues.hpp"
#include "rubsweep/core/numerics/dense/lu.hpp"
#include "rubsweep/ring/closed_forms.hpp"

namespace rubsweep::ring {
namespace {

bool all_alike(const std::vector<Load>& loads) {
  return std::all_of(loads.begin(), loads.end(), [&](const Load& load) {
    const Load& first = loads.front();
    return load.motion == first.motion && load.inclination_deg == first.inclination_deg &&
           load.radial_mass_kg == first.radial_mass_kg && load.flexural_mass_kg == first.flexural_mass_kg &&
           load.rotary_mass_kg == first.rotary_mass_kg &&
           load.gyroscopic_mass_kg == first.gyroscopic_mass_kg &&
           load.radial_stiffness_n_per_m == first.radial_stiffness_n_per_m &&
           load.tangential_stiffness_n_per_m == first.tangential_stiffness_n_per_m;
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
  // 1 / O^2 rather than O^2: K2 may be singular (loads without mass), K0 holds every spring.
  const Eigen::MatrixXd inverse = numerics::dense::solve_full_pivot(form.stiffness, form.softening);
  const Eigen::VectorXcd roots = numerics::dense::eigenvalues(inverse);
  if (roots.hasNaN()) throw SolverError("divergence: the eigenvalue iteration did not converge");
  const double largest = roots.cwiseAbs().maxCoeff();
  std::vector<double> speeds;
  for (const std::complex<double>& root : roots) {
    // Equal roots of identical loads may come out as a pair that close to the axis.
    if (std::abs(root.imag()) > 1e-9 * largest || !(root.real() > 1e-14 * largest)) continue;
    speeds.push_back(form.reference_rad_per_s / std::sqrt(root.real()));
  }
  std::sort(speeds.begin(), speeds.end());
  return speeds;
}

}  // namespace rubsweep::ring
