#include "rubsweep/analysis/design/dry_whip.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

#include "rubsweep/analysis/design/unbalance_response.hpp"
#include "rubsweep/core/contact/friction_bounds.hpp"
#include "rubsweep/core/contact/friction_law.hpp"
#include "rubsweep/core/numerics/dense/factors.hpp"
#include "rubsweep/core/numerics/spectral/decompositions.hpp"
#include "rubsweep/core/structure/assembly.hpp"

namespace rubsweep::design {
namespace {

using std::numbers::pi;
constexpr double none = std::numeric_limits<double>::infinity();

/// Model of the rotor in one stop at one shaft speed, for backward whirl at a frequency w in rad/s.
struct WhirlInStop {
  structure::LinearSystem system;
  contact::RelativeMap map;
  double stiffness_n_per_m = 0;

  /// Receptance G in z = G f e^{-i w t}, for a force that rotates backward.
  std::complex<double> receptance(double w) const {
    const std::complex<double> i(0, 1);
    const Eigen::MatrixXcd dynamic =
        (system.stiffness - w * w * system.mass).cast<std::complex<double>>() + i * w * system.damping;
    const Eigen::MatrixXcd rows = map.cast<std::complex<double>>();
    // Backward motion in real coordinates: x = Re(conj(z) e^{i w t}), y = Re(i conj(z) e^{i w t}).
    const Eigen::Vector2cd backward(1, i);
    const Eigen::Vector2cd moved =
        rows * numerics::dense::solve(dynamic, Eigen::VectorXcd(rows.transpose() * backward));
    return std::conj((moved(0) - i * moved(1)) / 2.0);
  }

  /// Friction coefficient that a whirl at w needs; infinite where the stop allows no such whirl.
  double friction(double w) const {
    return friction_of_dry_whip(receptance(w), stiffness_n_per_m).value_or(none);
  }
};

/// Natural frequencies of the undamped rotor, free and coupled to the casing by the stop's spring. Each dry
/// whip frequency lies between a free one and a coupled one.
std::vector<double> frequencies_rad_per_s(const WhirlInStop& whirl) {
  const Eigen::MatrixXd free = (whirl.system.stiffness + whirl.system.stiffness.transpose()) / 2;
  const Eigen::MatrixXd tied = free + whirl.stiffness_n_per_m * whirl.map.transpose() * whirl.map;
  std::vector<double> found;
  for (const Eigen::MatrixXd& stiffness : {free, tied}) {
    for (const double square : numerics::spectral::generalized_eigenvalues(stiffness, whirl.system.mass))
      if (square > 0) found.push_back(std::sqrt(square));
  }
  std::ranges::sort(found);
  return found;
}

/// Whirl frequencies to try, ascending up to `fastest`, with equal steps between natural frequencies.
std::vector<double> whirls_up_to(double fastest, const WhirlInStop& whirl) {
  std::vector<double> ends = frequencies_rad_per_s(whirl);
  if (ends.empty()) return {};
  // Damping and gyroscopic moments shift the frequencies a little, so that the first and the last interval
  // are extended.
  ends.insert(ends.begin(), ends.front() / 4);
  ends.push_back(2 * ends.back());
  // With many intervals, fewer steps suffice in each.
  const int steps = std::max(8, 512 / static_cast<int>(ends.size()));
  std::vector<double> whirls;
  for (std::size_t k = 1; k < ends.size(); ++k) {
    for (int step = 0; step < steps; ++step)
      whirls.push_back(ends[k - 1] * std::pow(ends[k] / ends[k - 1], static_cast<double>(step) / steps));
  }
  std::erase_if(whirls, [&](double w) { return w > fastest; });
  if (fastest > ends.front() && fastest < ends.back()) whirls.push_back(fastest);
  return whirls;
}

/// Last whirl frequency with finite friction, by bisection between `with` (finite) and `without` (infinite).
double edge(const WhirlInStop& whirl, double with, double without) {
  constexpr int halvings = 60;
  for (int i = 0; i < halvings; ++i) {
    const double middle = with + (without - with) / 2;
    (std::isfinite(whirl.friction(middle)) ? with : without) = middle;
  }
  return with;
}

}  // namespace

std::optional<double> friction_of_dry_whip(std::complex<double> receptance_m_per_n,
                                           double stiffness_n_per_m) {
  const double towards = -receptance_m_per_n.real();
  if (!(towards > 0)) return std::nullopt;
  const double friction = receptance_m_per_n.imag() / towards;
  if (!(towards * (1 + friction * friction) * stiffness_n_per_m >= 1)) return std::nullopt;
  return friction;
}

std::optional<DryWhip> least_dry_whip(const scene::PreparedMachine& prepared, std::size_t stop,
                                      double speed_hz) {
  const model::Stop& described = prepared.machine.stops[stop];
  const double speed = 2 * pi * speed_hz;
  const WhirlInStop whirl{structure::system_at(prepared.assembly, speed), stop_places(prepared)[stop].map,
                          described.stiffness_n_per_m};
  const std::vector<double> whirls =
      whirls_up_to(described.contact_radius_m * speed / described.clearance_m, whirl);
  DryWhip least{none, 0, speed_hz};
  const auto consider = [&](double w, double friction) {
    if (friction < least.least_friction) least = {friction, w / (2 * pi), speed_hz};
  };
  std::vector<double> frictions;
  for (const double w : whirls) frictions.push_back(whirl.friction(w));
  for (std::size_t k = 0; k < whirls.size(); ++k) {
    consider(whirls[k], frictions[k]);
    if (k == 0) continue;
    if (std::isfinite(frictions[k - 1]) != std::isfinite(frictions[k])) {
      const bool begins = std::isfinite(frictions[k]);
      const double w = edge(whirl, whirls[begins ? k : k - 1], whirls[begins ? k - 1 : k]);
      consider(w, whirl.friction(w));
    }
    if (k + 1 == whirls.size() || !(frictions[k] <= std::min(frictions[k - 1], frictions[k + 1])) ||
        !std::isfinite(frictions[k]))
      continue;
    std::uintmax_t iterations = 100;
    const auto [w, friction] = boost::math::tools::brent_find_minima(
        [&](double one) { return whirl.friction(one); }, whirls[k - 1], whirls[k + 1], 40, iterations);
    consider(w, friction);
  }
  if (least.least_friction == none) return std::nullopt;
  least.least_friction = std::max(0.0, least.least_friction);
  return least;
}

double largest_friction(const model::Friction& friction, double slip_m_per_s) {
  return std::max({0.0, contact::friction_bounds(friction).largest,
                   contact::friction_coefficient(friction, slip_m_per_s)});
}

}  // namespace rubsweep::design
